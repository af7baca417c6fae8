#include "server/http/router.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "server/http/url.h"

namespace lares::http {
namespace {

std::vector<std::string> PathParts(std::string_view path) {
  if (path.starts_with('/')) path.remove_prefix(1);
  return Split(path, '/');
}

}  // namespace

std::vector<Router::Segment> Router::ParseTemplate(const std::string& path) {
  if (!path.starts_with('/')) throw Error(Code::kInternal, "route '" + path + "' has no '/'");
  std::vector<Segment> segments;
  for (const std::string& part : PathParts(path)) {
    const std::size_t open = part.find('{');
    const std::size_t close = part.find('}');
    if ((open == std::string::npos) != (close == std::string::npos) ||
        (open != std::string::npos && close < open + 2)) {
      throw Error(Code::kInternal, "route '" + path + "' is malformed at '" + part + "'");
    }
    if (open == std::string::npos) {
      segments.push_back({part, "", ""});
    } else {
      segments.push_back(
          {part.substr(0, open), part.substr(open + 1, close - open - 1), part.substr(close + 1)});
    }
  }
  return segments;
}

void Router::Add(Route route) {
  for (const Route& other : routes_) {
    if (other.method == route.method && other.path == route.path) {
      throw Error(Code::kInternal, "route " + route.method + " " + route.path + " exists already");
    }
  }
  segments_.push_back(ParseTemplate(route.path));
  routes_.push_back(std::move(route));
  std::vector<std::size_t>& order = by_length_[segments_.back().size()];
  order.push_back(routes_.size() - 1);
  const auto literal = [this](std::size_t index) {
    std::size_t length = 0;
    for (const Segment& segment : segments_[index]) {
      length += segment.before.size() + segment.after.size() + (segment.name.empty() ? 1000 : 0);
    }
    return length;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return literal(a) > literal(b); });
}

bool Router::Matches(const std::vector<Segment>& segments, const std::vector<std::string>& parts,
                     std::map<std::string, std::string>& params) {
  params.clear();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const std::string& part = parts[i];
    if (segment.name.empty()) {
      if (part != segment.before) return false;
      continue;
    }
    const std::size_t literal = segment.before.size() + segment.after.size();
    if (part.size() <= literal || !part.starts_with(segment.before) ||
        !part.ends_with(segment.after)) {
      return false;
    }
    auto value =
        PercentDecode(std::string_view(part).substr(segment.before.size(), part.size() - literal));
    if (!value) return false;
    params[segment.name] = std::move(*value);
  }
  return true;
}

Router::Match Router::Find(const std::string& method, std::string_view path) const {
  Match match;
  const std::vector<std::string> parts = PathParts(path);
  const auto candidates = by_length_.find(parts.size());
  if (candidates == by_length_.end()) return match;
  std::map<std::string, std::string> params;
  for (const std::size_t index : candidates->second) {
    const Route& route = routes_[index];
    if (!Matches(segments_[index], parts, params)) continue;
    if (route.method == method || (route.method == "GET" && method == "HEAD")) {
      return {&route, std::move(params), {}};
    }
    match.allow.push_back(route.method);
    if (route.method == "GET") match.allow.push_back("HEAD");
  }
  std::sort(match.allow.begin(), match.allow.end());
  match.allow.erase(std::unique(match.allow.begin(), match.allow.end()), match.allow.end());
  return match;
}

}  // namespace lares::http
