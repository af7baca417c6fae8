#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/openapi.h"
#include "server/api/scope.h"
#include "server/web/bundle.h"

namespace lares::api {
namespace {

http::Response Static(const std::string& name, const std::string& type) {
  http::Response response;
  response.headers.Set("Content-Type", type);
  response.headers.Set("Content-Security-Policy",
                       "default-src 'none'; script-src 'self'; style-src 'self'; connect-src "
                       "'self'; img-src 'self' data:; base-uri 'none'; form-action 'none'; "
                       "frame-ancestors 'none'");
  response.body = std::string(web::Bundled(name));
  return response;
}

Json CountsToJson(const http::Request& request, const Context& context) {
  const server::Knowledge::Counts counts = context.knowledge.counts();
  const auto documents = [&](store::DocumentKind kind) {
    return context.store.ListDocuments(kind).size();
  };
  const std::vector<store::EnvironmentInfo> all = context.store.ListEnvironments();
  const auto environments = std::count_if(
      all.begin(), all.end(), [&](const auto& one) { return Reaches(request, one.id); });
  return {{"ontology_modules", context.knowledge.Modules().size()},
          {"recipes", documents(store::DocumentKind::kRecipe)},
          {"robots", documents(store::DocumentKind::kRobot)},
          {"object_models", documents(store::DocumentKind::kObjectModel)},
          {"priors", documents(store::DocumentKind::kPrior)},
          {"environments", environments},
          {"terms", counts.terms},
          {"statements_asserted", counts.asserted},
          {"statements_inferred", counts.inferred},
          {"views_cached", counts.views_cached},
          {"contradictions", counts.clashes}};
}

// The server runs: nothing else is looked at.
http::Response Health(const http::Request&) { return JsonAnswer({{"status", "ok"}}); }

http::Response Ready(const Context& context) {
  const std::string why_not = context.store.health();
  if (!why_not.empty()) throw Error(Code::kUnavailable, why_not);
  if (context.knowledge.counts().asserted == 0) {
    throw Error(Code::kUnavailable, "the ontology is not loaded");
  }
  return JsonAnswer({{"status", "ready"}});
}

http::Response Status(const http::Request& request, const Context& context) {
  const auto uptime = std::chrono::steady_clock::now() - context.started;
  Json json{{"name", "lares"},
            {"version", LARES_VERSION},
            {"uptime_s", std::chrono::duration<double>(uptime).count()},
            {"writes_refused", context.store.health()},
            {"counts", CountsToJson(request, context)}};
  return JsonAnswer(json);
}

// How goals ended, one series for each way.
std::string GoalsEnded(const prolog::Workers::Counts& goals) {
  std::string text =
      "# HELP lares_prolog_goals_total Goals by how they ended; time, memory, idle, abandoned, "
      "escape and died ended with their process being killed.\n"
      "# TYPE lares_prolog_goals_total counter\n";
  for (const char* how :
       {"yes", "no", "error", "time", "memory", "idle", "abandoned", "escape", "died", "worker"}) {
    const auto found = goals.ended.find(how);
    text += std::string("lares_prolog_goals_total{ended=\"") + how + "\"} " +
            std::to_string(found == goals.ended.end() ? 0 : found->second) + "\n";
  }
  return text;
}

http::Response MetricsText(const Context& context) {
  const server::Knowledge::Counts counts = context.knowledge.counts();
  const auto uptime = std::chrono::steady_clock::now() - context.started;
  const prolog::Workers::Counts goals = context.workers->counts();
  http::Response response;
  response.headers.Set("Content-Type", "text/plain; version=0.0.4; charset=utf-8");
  response.body =
      context.metrics->ToPrometheus(
          {{"lares_terms", "Distinct terms in the dictionary.", static_cast<double>(counts.terms)},
           {"lares_statements_asserted", "Statements of loaded documents.",
            static_cast<double>(counts.asserted)},
           {"lares_statements_inferred", "Statements that follow from them.",
            static_cast<double>(counts.inferred)},
           {"lares_views_cached", "Views held ready for questions.",
            static_cast<double>(counts.views_cached)},
           {"lares_contradictions", "Contradictions found in loaded documents.",
            static_cast<double>(counts.clashes)},
           {"lares_store_healthy", "1 while the store takes writes.",
            context.store.health().empty() ? 1.0 : 0.0},
           {"lares_prolog_workers_running", "Processes that run a goal.",
            static_cast<double>(goals.running)},
           {"lares_prolog_goals_waiting", "Goals that wait for a process.",
            static_cast<double>(goals.waiting)},
           {"lares_prolog_goals_turned_away", "Goals that found no room, since the start.",
            static_cast<double>(goals.refused)},
           {"lares_prolog_snapshot_bytes", "Copies of views that are kept for goals.",
            static_cast<double>(goals.snapshot_bytes)},
           {"lares_snapshots_pinned", "Snapshots that running questions hold.",
            static_cast<double>(context.snapshots->count())},
           {"lares_snapshot_oldest_seconds", "Age of the one that was pinned first; 0 without any.",
            std::chrono::duration<double>(context.snapshots->OldestAge()).count()},
           {"lares_watch_subscribers", "Clients that watch a query.",
            static_cast<double>(context.watches->subscribers())},
           {"lares_uptime_seconds", "Since the server started.",
            std::chrono::duration<double>(uptime).count()}}) +
      GoalsEnded(goals);
  return response;
}

}  // namespace

void AddOperationRoutes(http::Router& router, Context& context) {
  const auto get = [&router](const char* path, const char* operation, http::Handler handler) {
    router.Add({"GET", path, operation, std::move(handler), {}, 0});
  };
  get("/healthz", "getHealth", Health);
  get("/readyz", "getReadiness", [&context](const http::Request&) { return Ready(context); });
  get("/metrics", "getMetrics", [&context](const http::Request&) { return MetricsText(context); });
  get("/v1/status", "getStatus",
      [&context](const http::Request& request) { return Status(request, context); });
  get("/openapi.json", "getOpenApi", [&context](const http::Request&) {
    http::Response response;
    response.headers.Set("Content-Type", "application/json");
    response.body = context.openapi;
    return response;
  });
  const auto page = [&](const char* path, const char* operation, const char* file,
                        const char* type) {
    get(path, operation,
        [file = std::string(file), type = std::string(type)](const http::Request&) {
          return Static(file, type);
        });
  };
  page("/", "getStartPage", "index.html", "text/html; charset=utf-8");
  page("/docs", "getDocs", "docs.html", "text/html; charset=utf-8");
  page("/web/page.css", "getPageStyle", "page.css", "text/css; charset=utf-8");
  page("/web/index.js", "getStartScript", "index.js", "text/javascript; charset=utf-8");
  page("/web/docs.js", "getDocsScript", "docs.js", "text/javascript; charset=utf-8");
}

}  // namespace lares::api
