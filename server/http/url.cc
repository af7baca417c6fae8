#include "server/http/url.h"

#include <charconv>

#include "base/error.h"

namespace lares::http {
namespace {

bool IsUnreserved(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '.' || c == '_' || c == '~';
}

std::optional<int> HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return std::nullopt;
}

std::optional<std::string> DecodeQueryPart(std::string_view text) {
  std::string spaced(text);
  for (char& c : spaced) {
    if (c == '+') c = ' ';
  }
  return PercentDecode(spaced);
}

}  // namespace

std::string PercentEncode(std::string_view text) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : text) {
    if (IsUnreserved(c)) {
      encoded += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    encoded += {'%', kHex[byte >> 4], kHex[byte & 15]};
  }
  return encoded;
}

std::optional<std::string> PercentDecode(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    const auto high = HexDigit(text[i + 1]);
    const auto low = HexDigit(text[i + 2]);
    if (!high || !low || (*high == 0 && *low == 0)) return std::nullopt;
    decoded += static_cast<char>(*high * 16 + *low);
    i += 2;
  }
  return decoded;
}

std::optional<std::multimap<std::string, std::string>> ParseQuery(std::string_view query) {
  std::multimap<std::string, std::string> values;
  while (!query.empty()) {
    const std::size_t end = std::min(query.find('&'), query.size());
    const std::string_view pair = query.substr(0, end);
    query.remove_prefix(std::min(end + 1, query.size()));
    if (pair.empty()) continue;
    const std::size_t equals = std::min(pair.find('='), pair.size());
    auto name = DecodeQueryPart(pair.substr(0, equals));
    auto value = DecodeQueryPart(equals < pair.size() ? pair.substr(equals + 1) : "");
    if (!name || !value) return std::nullopt;
    values.emplace(std::move(*name), std::move(*value));
  }
  return values;
}

std::string FormatQuery(const std::multimap<std::string, std::string>& query) {
  std::string text;
  for (const auto& [name, value] : query) {
    text += (text.empty() ? "?" : "&") + PercentEncode(name) + "=" + PercentEncode(value);
  }
  return text;
}

BaseUrl ParseBaseUrl(std::string_view url) {
  const auto refuse = [url](const std::string& why) -> Error {
    return Error(Code::kInvalid, "'" + std::string(url) + "' is no server address: " + why)
        .WithHint("write it as http://127.0.0.1:8080");
  };
  std::string_view rest = url;
  BaseUrl parsed;
  parsed.tls = rest.starts_with("https://");
  if (!parsed.tls && !rest.starts_with("http://")) {
    throw refuse("it does not begin with http:// or https://");
  }
  rest.remove_prefix(parsed.tls ? 8 : 7);
  if (parsed.tls) parsed.port = 443;
  if (rest.ends_with('/')) rest.remove_suffix(1);
  if (rest.starts_with('[')) {
    const std::size_t close = rest.find(']');
    if (close == std::string_view::npos) throw refuse("']' is missing");
    parsed.host = std::string(rest.substr(1, close - 1));
    rest.remove_prefix(close + 1);
  } else {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    parsed.host = std::string(rest.substr(0, end));
    rest.remove_prefix(end);
  }
  if (parsed.host.empty() || parsed.host.find_first_of("/?#@ ") != std::string::npos) {
    throw refuse("the host is missing or malformed");
  }
  if (rest.empty()) return parsed;
  rest.remove_prefix(1);
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), parsed.port);
  if (error != std::errc() || end != rest.data() + rest.size() || parsed.port < 1 ||
      parsed.port > 65535) {
    throw refuse("the port is no number from 1 to 65535");
  }
  return parsed;
}

std::string FormatBaseUrl(const BaseUrl& url) {
  const bool ipv6 = url.host.find(':') != std::string::npos;
  return std::string(url.tls ? "https://" : "http://") + (ipv6 ? "[" + url.host + "]" : url.host) +
         ":" + std::to_string(url.port);
}

}  // namespace lares::http
