#include "server/http/range.h"

#include <strings.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/text.h"

namespace lares::http {
namespace {

// Digits only. A number beyond 64 bits is a position behind the end of any file.
std::optional<std::uint64_t> ParsePosition(std::string_view text) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos) {
    return std::nullopt;
  }
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) return UINT64_MAX;
  return value;
}

ByteRange Suffix(std::uint64_t wanted, std::uint64_t size) {
  if (wanted == 0 || size == 0) return {ByteRange::Kind::kUnsatisfiable, 0, 0};
  const std::uint64_t length = std::min(wanted, size);
  return {ByteRange::Kind::kPart, size - length, length};
}

}  // namespace

ByteRange ParseRange(std::string_view header, std::uint64_t size) {
  const std::string_view text = Trim(header);
  if (text.size() < 6 || ::strncasecmp(text.data(), "bytes=", 6) != 0) return {};
  const std::string_view spec = Trim(text.substr(6));
  const std::size_t dash = spec.find('-');
  if (dash == std::string_view::npos) return {};
  const std::string_view first_text = Trim(spec.substr(0, dash));
  const std::string_view last_text = Trim(spec.substr(dash + 1));
  const auto first = ParsePosition(first_text);
  const auto last = ParsePosition(last_text);
  if (first_text.empty()) return last ? Suffix(*last, size) : ByteRange{};
  if (!first || (!last && !last_text.empty())) return {};
  if (last && *last < *first) return {};
  if (*first >= size) return {ByteRange::Kind::kUnsatisfiable, 0, 0};
  const std::uint64_t end = last ? std::min(*last, size - 1) : size - 1;
  return {ByteRange::Kind::kPart, *first, end - *first + 1};
}

std::string FormatContentRange(const ByteRange& range, std::uint64_t size) {
  if (range.kind == ByteRange::Kind::kUnsatisfiable) return "bytes */" + std::to_string(size);
  return "bytes " + std::to_string(range.offset) + "-" +
         std::to_string(range.offset + range.length - 1) + "/" + std::to_string(size);
}

}  // namespace lares::http
