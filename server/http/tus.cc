#include "server/http/tus.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <ctime>

#include "base/text.h"
#include "server/http/problem.h"

namespace lares::http {
namespace {

constexpr std::string_view kAlphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kSha256Bytes = 32;

ProblemError Malformed(std::string_view header, const std::string& why) {
  return ProblemError("bad-request", std::string(header) + " " + why);
}

std::string ToHex(std::string_view bytes) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string hex;
  for (const char c : bytes) {
    hex += kHex[static_cast<unsigned char>(c) >> 4];
    hex += kHex[c & 15];
  }
  return hex;
}

bool IsMetadataKey(std::string_view key) {
  if (key.empty()) return false;
  for (const char c : key) {
    if (c <= ' ' || c == ',' || c > '~') return false;
  }
  return true;
}

}  // namespace

std::optional<std::string> DecodeBase64(std::string_view text) {
  if (text.size() % 4 != 0) return std::nullopt;
  std::string_view digits = text;
  while (digits.ends_with('=') && text.size() - digits.size() < 2) digits.remove_suffix(1);
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : digits) {
    const std::size_t value = kAlphabet.find(c);
    if (value == std::string_view::npos) return std::nullopt;
    bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xfff;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  if ((bits & ((1u << count) - 1)) != 0) return std::nullopt;  // another text says the same
  return bytes;
}

std::uint64_t ReadUploadNumber(const Request& request, std::string_view header) {
  const std::string_view text = request.headers.Get(header);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || text.front() == '-' || error != std::errc() ||
      end != text.data() + text.size()) {
    throw Malformed(header, text.empty() ? "is missing" : "is no number of bytes");
  }
  return static_cast<std::uint64_t>(value);
}

std::map<std::string, std::string> ParseUploadMetadata(std::string_view header) {
  constexpr std::string_view kName = "Upload-Metadata";
  if (header.size() > kMaxUploadMetadataBytes) throw Malformed(kName, "is longer than 4096 bytes");
  std::map<std::string, std::string> metadata;
  if (Trim(header).empty()) return metadata;
  for (const std::string& pair : Split(header, ',')) {
    const std::string_view text = Trim(pair);
    const std::size_t space = text.find(' ');
    const std::string_view key = text.substr(0, space);
    const auto value =
        DecodeBase64(space == std::string_view::npos ? "" : Trim(text.substr(space)));
    if (!IsMetadataKey(key)) throw Malformed(kName, "has a pair without a key");
    if (!value) throw Malformed(kName, "has a value that is no Base64");
    if (!metadata.emplace(key, *value).second) throw Malformed(kName, "has a key twice");
  }
  return metadata;
}

std::optional<std::string> ParseUploadChecksum(std::string_view header) {
  constexpr std::string_view kName = "Upload-Checksum";
  if (header.empty()) return std::nullopt;
  const std::size_t space = header.find(' ');
  if (header.substr(0, space) != "sha256") throw Malformed(kName, "must be of sha256");
  const auto digest =
      DecodeBase64(space == std::string_view::npos ? "" : Trim(header.substr(space)));
  if (!digest || digest->size() != kSha256Bytes) throw Malformed(kName, "is no SHA-256 in Base64");
  return ToHex(*digest);
}

std::string FormatHttpDate(Time time) {
  static constexpr std::array<const char*, 7> kDays = {"Sun", "Mon", "Tue", "Wed",
                                                       "Thu", "Fri", "Sat"};
  static constexpr std::array<const char*, 12> kMonths = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                          "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const std::time_t seconds =
      std::chrono::floor<std::chrono::seconds>(time.time_since_epoch()).count();
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  char text[40];
  std::snprintf(text, sizeof text, "%s, %02d %s %04d %02d:%02d:%02d GMT",
                kDays.at(static_cast<std::size_t>(parts.tm_wday)), parts.tm_mday,
                kMonths.at(static_cast<std::size_t>(parts.tm_mon)), parts.tm_year + 1900,
                parts.tm_hour, parts.tm_min, parts.tm_sec);
  return text;
}

}  // namespace lares::http
