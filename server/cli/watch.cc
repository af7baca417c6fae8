#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "server/cli/print.h"
#include "server/cli/query.h"
#include "server/http/events.h"

namespace lares::cli {
namespace {

struct WatchCommand {
  QueryOptions query;
  std::map<std::string, std::string> pattern;
  bool count = false;
  std::size_t events = 0;  // 0: until it is stopped
};

struct Enough {};

std::string FormatChange(const http::Event& event, const TermPrinter& printer) {
  const Json data = Json::parse(event.data, nullptr, false);
  if (!data.is_object()) throw Error(Code::kIo, "an event of the server is no JSON");
  std::string text = "generation " + std::to_string(data.value("generation", 0ull)) + ": " +
                     Plural(data.value("count", std::size_t{0}), "row") + "\n";
  const auto list = [&](const char* name, const char* mark) {
    if (!data.contains(name)) return;
    for (const Json& row : data[name]) text += mark + printer.PrintRow(row) + "\n";
  };
  list("rows", "  ");
  list("removed", "- ");
  list("added", "+ ");
  return text;
}

[[noreturn]] void ThrowProblem(const http::Event& event) {
  const Json problem = Json::parse(event.data, nullptr, false);
  throw RemoteError(TextOf(problem, "code"), TextOf(problem, "detail"), event.data);
}

// Until the server ends the stream, or there were enough events.
void Follow(const WatchCommand& watch, const Options& options) {
  http::ClientRequest request{"GET", "/v1/watches", AboutParameters(watch.query), {}, {}};
  const std::string text = ReadQuery(watch.query);
  if (!text.empty()) request.query.emplace("query", text);
  for (const auto& [name, term] : watch.pattern) {
    if (!term.empty()) request.query.emplace(name, term);
  }
  if (request.query.count("query") > 0 &&
      request.query.size() > 1 + AboutParameters(watch.query).size()) {
    throw CLI::ValidationError("--subject", "give a query or a pattern, not both");
  }
  request.query.emplace("first", watch.count ? "count" : "rows");
  const TermPrinter printer(text);
  std::size_t seen = 0;
  http::EventReader reader([&](const http::Event& event) {
    if (event.event == "error") ThrowProblem(event);
    Print(options.json ? event.data + "\n" : FormatChange(event, printer));
    if (++seen == watch.events) throw Enough{};
  });
  http::Transfer transfer;
  transfer.sink = [&reader](std::string_view piece) { reader.Feed(piece); };
  try {
    Remote(options.server).Send(request, transfer);
  } catch (const Enough&) {
    return;
  }
  throw RemoteError("unavailable", "the server has ended the stream", "");
}

}  // namespace

void AddWatch(CLI::App& app, const Options& options) {
  auto* command =
      AddCommand(app, "watch", "Be told whenever the answer to a query changes",
                 "  lares watch -q 'SELECT ?cup { ?cup a lares:Cup }' --environment kitchen\n"
                 "  lares watch --predicate rdf:type --object lares:Cup --environment kitchen\n"
                 "  lares watch query.rq --count --events 1\n"
                 "Prints the answer that stands, then what each commit adds (+) and removes (-).");
  auto watch = std::make_shared<WatchCommand>();
  AddQueryOptions(*command, watch->query);
  command->add_option("--subject", watch->pattern["subject"], "of a triple, as SPARQL writes it");
  command->add_option("--predicate", watch->pattern["predicate"], "likewise");
  command->add_option("--object", watch->pattern["object"], "likewise");
  command->add_flag("--count", watch->count, "say first how many rows there are, not which");
  command->add_option("--events", watch->events, "end after so many (default: never)")
      ->check(CLI::PositiveNumber);
  command->callback([watch, &options] { Follow(*watch, options); });
}

}  // namespace lares::cli
