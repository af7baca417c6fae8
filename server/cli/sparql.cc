#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "server/cli/print.h"
#include "server/cli/query.h"

namespace lares::cli {
namespace {

struct SparqlOptions {
  QueryOptions query;
  std::string format = "table";
  std::string explain;
  double timeout_s = 0;
  std::uint64_t max_rows = 0;
};

std::string FormatRows(const Json& answer, const TermPrinter& printer) {
  if (answer.contains("boolean")) return printer.Print(answer["boolean"]) + "\n";
  const auto names = answer.at("head").at("vars").get<std::vector<std::string>>();
  std::vector<std::string> heads;
  for (const std::string& name : names) heads.push_back("?" + name);
  std::vector<std::vector<std::string>> rows;
  for (const Json& binding : answer.at("results").at("bindings")) {
    std::vector<std::string>& row = rows.emplace_back();
    for (const std::string& name : names) {
      row.push_back(binding.contains(name) ? printer.Print(binding[name]) : "");
    }
  }
  return FormatTable(heads, rows) + Plural(rows.size(), "row") + "\n";
}

std::string ReadAnswer(const http::ClientResponse& response, const std::string& query) {
  const std::string_view type = response.headers.Get("Content-Type");
  if (!type.starts_with("application/sparql-results+json")) return response.body;
  const Json answer = Json::parse(response.body, nullptr, false);
  if (!answer.is_object()) throw Error(Code::kIo, "the server's answer is no JSON");
  try {
    return FormatRows(answer, TermPrinter(query));
  } catch (const Json::exception&) {
    throw Error(Code::kIo, "the server's answer is no table");
  }
}

void Query(const SparqlOptions& sparql, const Options& options) {
  const std::string text = ReadQuery(sparql.query);
  if (text.empty()) throw CLI::ValidationError("FILE", "name a file, or give the query with -q");
  const std::string format = options.json ? "json" : sparql.format;
  http::ClientRequest request{"POST", "/v1/sparql", AboutParameters(sparql.query), {}, text};
  request.headers.Set("Content-Type", "application/sparql-query");
  const auto give = [&](const char* name, const std::string& value) {
    request.query.emplace(name, value);
  };
  if (sparql.timeout_s > 0) {
    give("timeout_ms", std::to_string(std::lround(sparql.timeout_s * 1000)));
  }
  if (sparql.max_rows > 0) give("max_rows", std::to_string(sparql.max_rows));
  if (!sparql.explain.empty()) give("explain", sparql.explain);
  Remote remote(options.server);
  if (format == "table" && sparql.explain.empty()) {
    // The form of the query decides which of the two it is.
    request.headers.Set("Accept", "application/sparql-results+json, text/turtle");
    return Print(ReadAnswer(remote.Send(request), text));
  }
  give("as", format == "table" ? "text" : format);
  http::Transfer transfer;
  transfer.sink = [](std::string_view piece) { Print(std::string(piece)); };
  remote.Send(request, transfer);
}

}  // namespace

void AddSparql(CLI::App& app, const Options& options) {
  auto* command = AddCommand(app, "sparql", "Ask in SPARQL 1.1",
                             "  lares sparql -q 'SELECT ?c { ?c rdfs:subClassOf lares:Cup }'\n"
                             "  lares sparql query.rq --environment hospital-room --format csv\n"
                             "  lares sparql query.rq --explain run\n"
                             "The prefixes lares, rdf, rdfs, owl and xsd need no declaration.");
  auto sparql = std::make_shared<SparqlOptions>();
  AddQueryOptions(*command, sparql->query);
  command
      ->add_option(
          "--format", sparql->format,
          "table; json, xml, csv, tsv (SELECT, ASK); turtle, ntriples, rdfxml, trig, nquads "
          "(CONSTRUCT, DESCRIBE)")
      ->check(CLI::IsMember(
          {"table", "json", "xml", "csv", "tsv", "turtle", "ntriples", "rdfxml", "trig", "nquads"}))
      ->capture_default_str();
  command
      ->add_option("--explain", sparql->explain,
                   "the plan instead of the answer; run: with the rows that each step gave")
      ->check(CLI::IsMember({"plan", "run"}));
  command->add_option("--timeout", sparql->timeout_s, "seconds (default: 10, at most 60)")
      ->check(CLI::Range(0.001, 60.0));
  command->add_option("--max-rows", sparql->max_rows, "a longer answer is refused")
      ->check(CLI::Range(1, 10'000'000));
  command->callback([sparql, &options] { Query(*sparql, options); });
}

}  // namespace lares::cli
