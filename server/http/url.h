// URLs: percent-encoding, queries, base addresses.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace lares::http {

// Everything but unreserved characters (RFC 3986) as %XX: for one path segment or query value.
std::string PercentEncode(std::string_view text);
// Nothing for a '%' without two hexadecimal digits, or a zero byte.
std::optional<std::string> PercentDecode(std::string_view text);

// "a=1&b=x%20y"; '+' is a space. Nothing when malformed.
std::optional<std::multimap<std::string, std::string>> ParseQuery(std::string_view query);
// "?a=1&b=x%20y", "" when empty.
std::string FormatQuery(const std::multimap<std::string, std::string>& query);

// "http://host:port" or "https://host:port" taken apart; IPv6 hosts without brackets.
struct BaseUrl {
  std::string host;
  int port = 80;  // 443 for https
  bool tls = false;
};
// Throws kInvalid for anything but http://host[:port][/] and https://host[:port][/].
BaseUrl ParseBaseUrl(std::string_view url);
// "http://127.0.0.1:8080", "http://[::1]:8080".
std::string FormatBaseUrl(const BaseUrl& url);

}  // namespace lares::http
