// Which handler answers a path.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/message.h"

namespace lares::http {

using Handler = std::function<Response(const Request&)>;

struct Route {
  std::string method;     // "GET" answers HEAD too
  std::string path;       // "/v1/environments/{id}/versions/{number}.tar"
  std::string operation;  // the operation's id in the OpenAPI document
  Handler handler;
  // Media types that the body may have; empty: the route takes no body. "*/*" takes anything.
  std::vector<std::string> consumes;
  std::uint64_t max_body_bytes = 1u << 20;
};

// Filled once, then read by any number of threads.
class Router {
 public:
  // A template's segment is literal text or one {name} with literal text around it. Throws
  // kInternal for a malformed template, or a method and path that are there already.
  void Add(Route route);

  struct Match {
    const Route* route = nullptr;               // null: no such path, or `allow` lists its methods
    std::map<std::string, std::string> params;  // decoded
    std::vector<std::string> allow;             // of the path, when it has other methods only
  };
  // `path` still percent-encoded, so that an encoded '/' stays within its segment. A route with
  // more literal text wins.
  Match Find(const std::string& method, std::string_view path) const;

  const std::vector<Route>& routes() const { return routes_; }

 private:
  struct Segment {
    std::string before;
    std::string name;  // empty: all literal, in `before`
    std::string after;
  };
  static std::vector<Segment> ParseTemplate(const std::string& path);
  static bool Matches(const std::vector<Segment>& segments, const std::vector<std::string>& parts,
                      std::map<std::string, std::string>& params);

  std::vector<Route> routes_;
  std::vector<std::vector<Segment>> segments_;  // of each route
  // Routes by number of segments, those with more literal text first.
  std::map<std::size_t, std::vector<std::size_t>> by_length_;
};

}  // namespace lares::http
