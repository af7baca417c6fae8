// SPARQL 1.1 Protocol (W3C Recommendation 21 March 2013), its query operation.
#include <nlohmann/json.hpp>
#include <semaphore>

#include "base/aside.h"
#include "base/error.h"
#include "base/text.h"
#include "ontology/rdf/writer.h"
#include "reasoner/sparql/results.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/scope.h"
#include "server/api/standing_query.h"
#include "server/http/media_type.h"
#include "server/http/problem.h"
#include "server/http/url.h"

namespace lares::api {
namespace {

constexpr std::uint64_t kMaxRequest = 2u << 20;
constexpr int kMaxTimeoutMs = 60'000;
constexpr int kMaxRows = 10'000'000;
constexpr std::size_t kMaxMemory = 128u << 20;  // of one query
constexpr std::ptrdiff_t kAtOnce = 8;           // queries that run at the same time
constexpr std::chrono::seconds kPatience{1};    // with those that wait for them

// A format that an answer can have, best first of its form.
struct Format {
  const char* name;  // of ?as=
  const char* media_type;
  std::optional<sparql::ResultFormat> table;  // SELECT and ASK
  rdf::Format graph = rdf::Format::kTurtle;   // CONSTRUCT and DESCRIBE
};
using sparql::ResultFormat;
const std::vector<Format> kTables{{"json", "application/sparql-results+json", ResultFormat::kJson},
                                  {"xml", "application/sparql-results+xml", ResultFormat::kXml},
                                  {"csv", "text/csv", ResultFormat::kCsv},
                                  {"tsv", "text/tab-separated-values", ResultFormat::kTsv},
                                  {"json", "application/json", ResultFormat::kJson},
                                  {"xml", "application/xml", ResultFormat::kXml}};
const std::vector<Format> kGraphs{{"turtle", "text/turtle", {}, rdf::Format::kTurtle},
                                  {"ntriples", "application/n-triples", {}, rdf::Format::kNTriples},
                                  {"rdfxml", "application/rdf+xml", {}, rdf::Format::kRdfXml},
                                  {"trig", "application/trig", {}, rdf::Format::kTriG},
                                  {"nquads", "application/n-quads", {}, rdf::Format::kNQuads}};
const std::vector<Format> kPlans{{"text", "text/plain", {}}, {"json", "application/json", {}}};

struct Asked {
  sparql::Query query;
  Format format;
  sparql::Limits limits;
  std::string explain;  // "", "plan", "run"
};

const Format& ChooseFormat(const http::Request& request, const std::vector<Format>& offered) {
  std::vector<std::string> types, names;
  for (const Format& format : offered) {
    types.emplace_back(format.media_type);
    if (std::find(names.begin(), names.end(), format.name) == names.end()) {
      names.emplace_back(format.name);
    }
  }
  const auto refuse = [&] {
    return http::ProblemError("not-acceptable",
                              "an answer to this form of query is given as " + Join(types, ", "))
        .WithMembers(Json{{"offered", types}}.dump());
  };
  if (const auto as = request.Query("as")) {
    for (const Format& format : offered) {
      if (*as == format.name) return format;
    }
    auto error = refuse();
    error.WithHint("?as= is one of " + Join(names, ", ") + " here");
    throw error;
  }
  const auto chosen = http::ChooseMediaType(request.headers.GetList("Accept"), types);
  for (const Format& format : offered) {
    if (chosen == format.media_type) return format;
  }
  throw refuse();
}

// The parameters of the address and, in a form, those of the body; ?query= is the query's text.
http::Request Collect(const http::Request& request) {
  http::Request all;
  all.headers = request.headers;
  all.query = request.query;
  if (!request.has_body) return all;
  const std::string body = http::ReadWholeBody(request, kMaxRequest);
  const auto media = http::ParseMediaType(request.headers.Get("Content-Type"));
  if (media && media->type == "application/sparql-query") {
    all.query.emplace("query", body);
    return all;
  }
  auto form = http::ParseQuery(body);
  if (!form) throw http::ProblemError("bad-request", "the form cannot be read");
  all.query.merge(*form);
  return all;
}

Asked ReadQuestion(const http::Request& request, const rdf::AliasTable& aliases) {
  if (request.query.count("query") != 1) {
    http::ProblemError error("bad-request", request.query.contains("query")
                                                ? "there is more than one query"
                                                : "there is no query");
    error.WithHint("send ?query=, a form with it, or a body of application/sparql-query");
    throw error;
  }
  Asked asked{ParseSparql(*request.Query("query"), aliases, request.query), kPlans.front(), {}, {}};
  asked.explain = request.Query("explain").value_or("");
  if (asked.explain == "true") asked.explain = "plan";
  if (!asked.explain.empty() && asked.explain != "plan" && asked.explain != "run") {
    throw Error(Code::kInvalid, "?explain= is plan or run, not '" + asked.explain + "'");
  }
  const bool is_table =
      asked.query.form() == sparql::Form::kSelect || asked.query.form() == sparql::Form::kAsk;
  asked.format = ChooseFormat(request, !asked.explain.empty() ? kPlans
                                       : is_table             ? kTables
                                                              : kGraphs);
  asked.limits.timeout =
      std::chrono::milliseconds(QueryNumber(request, "timeout_ms", 10'000, 1, kMaxTimeoutMs));
  asked.limits.max_rows =
      static_cast<std::size_t>(QueryNumber(request, "max_rows", 1'000'000, 1, kMaxRows));
  asked.limits.max_memory_bytes = kMaxMemory;
  return asked;
}

void WriteSelect(const Asked& asked, const sparql::Dataset& dataset, http::OpenSink& sink) {
  sparql::ResultWriter writer(*asked.format.table, asked.query.variables(),
                              [&sink](std::string_view text) {
                                sink.Write(text);
                                return true;
                              });
  sparql::Select(asked.query, dataset, asked.limits, sink.gone(),
                 [&writer](sparql::Cells cells) { return writer.Row(cells); });
  writer.End();
}

void WriteAnswer(const Asked& asked, const rdf::View& view, http::OpenSink& sink) {
  const sparql::Dataset dataset = DatasetOf(view);
  if (!asked.explain.empty()) {
    const bool runs = asked.explain == "run";
    const bool is_json = asked.format.name == std::string_view("json");
    return sink.Write(sparql::Explain(
        asked.query, dataset, is_json ? sparql::ExplainFormat::kJson : sparql::ExplainFormat::kText,
        runs ? std::optional(asked.limits) : std::nullopt, sink.gone()));
  }
  switch (asked.query.form()) {
    case sparql::Form::kSelect:
      return WriteSelect(asked, dataset, sink);
    case sparql::Form::kAsk:
      return sink.Write(sparql::WriteBoolean(
          *asked.format.table, sparql::Ask(asked.query, dataset, asked.limits, sink.gone())));
    case sparql::Form::kConstruct:
    case sparql::Form::kDescribe:
      return sink.Write(rdf::WriteRdf(
          sparql::Construct(asked.query, dataset, asked.limits, sink.gone()), asked.format.graph));
  }
}

// Queries that run at the same time; the others are told to come again.
class Gate {
 public:
  class Pass {
   public:
    explicit Pass(Gate& gate) : gate_(gate) {
      if (gate_.places_.try_acquire_for(kPatience)) return;
      throw http::ProblemError("unavailable", std::to_string(kAtOnce) + " queries run already")
          .WithHeader("Retry-After", "2");
    }
    ~Pass() { gate_.places_.release(); }
    Pass(const Pass&) = delete;
    Pass& operator=(const Pass&) = delete;

   private:
    Gate& gate_;
  };

 private:
  std::counting_semaphore<kAtOnce> places_{kAtOnce};
};

http::Response Answer(const http::Request& request, Context& context,
                      const std::shared_ptr<Gate>& gate) {
  const http::Request all = Collect(request);
  auto asked = std::make_shared<const Asked>(ReadQuestion(all, context.knowledge.aliases()));
  const server::ViewRequest about = ReadViewRequest(all, context.store);
  CheckReach(request, about.environment);
  auto pinned = std::make_shared<const server::PinnedView>(context.snapshots,
                                                           context.knowledge.ViewFor(about));
  http::Response response;
  const std::string type = asked->format.media_type;
  response.headers.Set("Content-Type", type.starts_with("text/") ? type + "; charset=utf-8" : type);
  response.headers.Set("Vary", "Accept");
  response.body = http::OpenBody{[asked, pinned, gate](http::OpenSink& sink) {
    const Gate::Pass pass(*gate);
    RunAside([&] { WriteAnswer(*asked, pinned->view(), sink); });
  }};
  return response;
}

}  // namespace

void AddSparqlRoutes(http::Router& router, Context& context) {
  const auto handler = [&context, gate = std::make_shared<Gate>()](const http::Request& request) {
    return Answer(request, context, gate);
  };
  router.Add({"GET", "/v1/sparql", "querySparql", handler, {}, 0});
  router.Add({"POST",
              "/v1/sparql",
              "postSparql",
              handler,
              {"application/sparql-query", "application/x-www-form-urlencoded"},
              kMaxRequest});
}

}  // namespace lares::api
