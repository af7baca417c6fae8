#include <nlohmann/json.hpp>

#include "base/error.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/standing_query.h"
#include "server/http/problem.h"

namespace lares::api {
namespace {

// The query of a triple pattern, whose terms are written as SPARQL writes them.
std::string QueryOfPattern(const http::Request& request) {
  std::string pattern;
  bool is_open = false;
  bool is_given = false;
  for (const char* part : {"subject", "predicate", "object"}) {
    const auto term = request.Query(part);
    (term ? is_given : is_open) = true;
    pattern += " " + term.value_or("?" + std::string(part));
  }
  if (!is_given) {
    http::ProblemError error("bad-request", "there is nothing to watch");
    error.WithHint("give ?query=, or one or more of ?subject=, ?predicate= and ?object=");
    throw error;
  }
  return (is_open ? "SELECT * {" : "ASK {") + pattern + " }";
}

FirstEvent ReadFirst(const http::Request& request) {
  const std::string first = request.Query("first").value_or("rows");
  if (first == "rows") return FirstEvent::kRows;
  if (first == "count") return FirstEvent::kCount;
  throw Error(Code::kInvalid, "?first= is rows or count, not '" + first + "'");
}

// Whether the token that the stream was asked with is still good.
std::function<bool()> StillAllowed(const http::Request& request, const Context& context) {
  if (request.grant == nullptr || context.access == nullptr) return [] { return true; };
  return [access = context.access, grant = request.grant] { return access->IsStillGood(*grant); };
}

http::Response Watch(const http::Request& request, Context& context) {
  const FirstEvent first = ReadFirst(request);
  const std::string text =
      request.Query("query") ? *request.Query("query") : QueryOfPattern(request);
  const server::ViewRequest about = ReadViewRequest(request, context.store);
  Json key{text, about.recipe, about.robot, about.environment, about.environment_version};
  Json graphs = Json::array();
  for (const char* name : {"default-graph-uri", "named-graph-uri"}) {
    const auto [begin, end] = request.query.equal_range(name);
    for (auto graph = begin; graph != end; ++graph) graphs.push_back({name, graph->second});
  }
  key.push_back(std::move(graphs));
  Standing standing{Compact(key), ParseSparql(text, context.knowledge.aliases(), request.query),
                    about};
  context.knowledge.ViewFor(about);  // names that nothing answers to are refused here
  auto place = context.watches->Reserve(standing.key);
  http::Response response;
  response.headers.Set("Content-Type", "text/event-stream");
  response.headers.Set("Cache-Control", "no-store");
  response.body = http::EventsBody{
      [hub = context.watches, standing, first, place,
       allowed = StillAllowed(request, context)](std::shared_ptr<http::EventChannel> channel) {
        hub->Subscribe(standing, first, std::move(channel), place, allowed);
      }};
  return response;
}

}  // namespace

void AddWatchRoutes(http::Router& router, Context& context) {
  if (context.watches == nullptr) {
    context.watches = std::make_shared<WatchHub>(context.knowledge, context.snapshots);
  }
  router.Add({"GET",
              "/v1/watches",
              "watchQuery",
              [&context](const http::Request& request) { return Watch(request, context); },
              {},
              0});
}

}  // namespace lares::api
