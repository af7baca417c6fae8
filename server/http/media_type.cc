#include "server/http/media_type.h"

#include <array>
#include <cstdlib>
#include <utility>

#include "base/text.h"

namespace lares::http {
namespace {

bool IsToken(std::string_view text) {
  static constexpr std::string_view kOther = "!#$%&'*+-.^_`|~";
  if (text.empty()) return false;
  for (const char c : text) {
    const bool alphanumeric =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!alphanumeric && kOther.find(c) == std::string_view::npos) return false;
  }
  return true;
}

// Takes `name=token` or `name="quoted"` off the front of `rest`; nothing when malformed.
std::optional<std::pair<std::string, std::string>> TakeParameter(std::string_view& rest) {
  const std::size_t equals = rest.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  const std::string_view name = Trim(rest.substr(0, equals));
  if (!IsToken(name)) return std::nullopt;
  rest = Trim(rest.substr(equals + 1));
  std::string value;
  if (rest.starts_with('"')) {
    std::size_t i = 1;
    for (; i < rest.size() && rest[i] != '"'; ++i) {
      if (rest[i] == '\\' && i + 1 < rest.size()) ++i;
      value += rest[i];
    }
    if (i >= rest.size()) return std::nullopt;
    rest = Trim(rest.substr(i + 1));
  } else {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    value = std::string(Trim(rest.substr(0, end)));
    if (!IsToken(value)) return std::nullopt;
    rest = rest.substr(end);
  }
  return std::pair(ToLower(name), value);
}

// How much an Accept entry likes `offered`: its quality and how exactly it names it.
struct Liking {
  double quality = -1;
  int precision = -1;
};

Liking HowMuch(const MediaType& entry, const std::string& offered) {
  const std::string group = offered.substr(0, offered.find('/'));
  const int precision = entry.type == offered        ? 2
                        : entry.type == group + "/*" ? 1
                        : entry.type == "*/*"        ? 0
                                                     : -1;
  if (precision < 0) return {};
  const auto quality = entry.parameters.find("q");
  return {quality == entry.parameters.end() ? 1.0 : std::strtod(quality->second.c_str(), nullptr),
          precision};
}

}  // namespace

std::optional<MediaType> ParseMediaType(std::string_view text) {
  std::string_view rest = Trim(text);
  const std::size_t end = std::min(rest.find(';'), rest.size());
  MediaType media{ToLower(Trim(rest.substr(0, end))), {}};
  const std::size_t slash = media.type.find('/');
  if (slash == std::string::npos || !IsToken(std::string_view(media.type).substr(0, slash)) ||
      !IsToken(std::string_view(media.type).substr(slash + 1))) {
    return std::nullopt;
  }
  rest = rest.substr(end);
  while (rest.starts_with(';')) {
    rest = Trim(rest.substr(1));
    if (rest.empty()) break;
    auto parameter = TakeParameter(rest);
    if (!parameter) return std::nullopt;
    media.parameters.insert(std::move(*parameter));
  }
  if (!rest.empty()) return std::nullopt;
  return media;
}

std::optional<std::string> ChooseMediaType(std::string_view accept,
                                           const std::vector<std::string>& offered) {
  if (Trim(accept).empty()) return offered.front();
  std::vector<MediaType> entries;
  for (const std::string& text : Split(accept, ',')) {
    auto entry = ParseMediaType(text);
    if (!entry) return offered.front();
    entries.push_back(std::move(*entry));
  }
  const std::string* best = nullptr;
  double best_quality = 0;
  for (const std::string& candidate : offered) {
    Liking liking;
    for (const MediaType& entry : entries) {
      const Liking now = HowMuch(entry, candidate);
      if (now.precision > liking.precision) liking = now;
    }
    if (liking.quality > best_quality) {
      best_quality = liking.quality;
      best = &candidate;
    }
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

std::string MediaTypeOfFile(std::string_view file_name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 23> kTypes{{
      {".owl", "application/rdf+xml"},
      {".rdf", "application/rdf+xml"},
      {".ttl", "text/turtle"},
      {".trig", "application/trig"},
      {".nt", "application/n-triples"},
      {".nq", "application/n-quads"},
      {".ofn", "text/owl-functional"},
      {".owx", "application/owl+xml"},
      {".jsonld", "application/ld+json"},
      {".tsv", "text/tab-separated-values"},
      {".json", "application/json"},
      {".yaml", "application/yaml"},
      {".tar", "application/x-tar"},
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".jpg", "image/jpeg"},
      {".pgm", "image/x-portable-graymap"},
      {".txt", "text/plain; charset=utf-8"},
      {".xml", "application/xml"},
      {".urdf", "application/urdf+xml"},
  }};
  const std::string lower = ToLower(file_name);
  for (const auto& [extension, type] : kTypes) {
    if (lower.ends_with(extension)) return std::string(type);
  }
  return "application/octet-stream";
}

}  // namespace lares::http
