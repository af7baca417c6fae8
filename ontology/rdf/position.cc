#include "ontology/rdf/position.h"

#include <algorithm>

namespace lares::rdf {
namespace {

bool IsContinuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

std::size_t SkipMark(std::string_view text) { return text.starts_with("\xEF\xBB\xBF") ? 3 : 0; }

}  // namespace

Place PlaceAt(std::string_view text, std::size_t offset, const std::string& source) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t newline = before.rfind('\n');
  const std::size_t line_start =
      newline == std::string_view::npos ? std::min(SkipMark(text), before.size()) : newline + 1;
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const auto characters =
      std::count_if(before.begin() + static_cast<std::ptrdiff_t>(line_start), before.end(),
                    [](char byte) { return !IsContinuation(byte); });
  return {source, static_cast<int>(lines) + 1, static_cast<int>(characters) + 1};
}

std::size_t LineStart(std::string_view text, int line) {
  std::size_t offset = SkipMark(text);
  for (int i = 1; i < line; ++i) {
    const std::size_t newline = text.find('\n', offset);
    if (newline == std::string_view::npos) return text.size();
    offset = newline + 1;
  }
  return offset;
}

std::size_t OffsetOf(std::string_view text, int line, int column) {
  std::size_t offset = LineStart(text, line);
  for (int i = 1; i < column && offset < text.size() && text[offset] != '\n'; ++i) {
    ++offset;
    while (offset < text.size() && IsContinuation(text[offset])) ++offset;
  }
  return offset;
}

Error WithPlace(const Error& error, Place place) {
  if (error.place()) return error;
  return Error(error.code(), error.what(), std::move(place)).WithHint(error.hint());
}

}  // namespace lares::rdf
