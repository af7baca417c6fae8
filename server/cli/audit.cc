#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "server/cli/command.h"
#include "server/cli/print.h"
#include "server/cli/when.h"

namespace lares::cli {
namespace {

struct AuditOptions {
  std::string since;
  std::string token;
  std::string environment;
  std::size_t limit = 100;
};

// The newest `limit` records, over as many pages as that takes.
Json Ask(const AuditOptions& audit, const Options& options) {
  std::multimap<std::string, std::string> query;
  if (!audit.since.empty()) {
    query.emplace("since", ToRfc3339(ParseWhen(audit.since, Now(), -1)));
  }
  if (!audit.token.empty()) query.emplace("token", audit.token);
  if (!audit.environment.empty()) query.emplace("environment", audit.environment);
  Remote remote(options.server);
  Json all{{"items", Json::array()}, {"next", nullptr}};
  while (all["items"].size() < audit.limit) {
    auto page_query = query;
    page_query.emplace(
        "limit", std::to_string(std::min<std::size_t>(1000, audit.limit - all["items"].size())));
    if (all["next"].is_string()) page_query.emplace("after", all["next"].get<std::string>());
    const Json page = remote.GetJson("/v1/audit", page_query);
    for (const Json& item : page.at("items")) all["items"].push_back(item);
    all["next"] = page.at("next");
    if (all["next"].is_null()) break;
  }
  return all;
}

}  // namespace

void AddAudit(CLI::App& app, const Options& options) {
  auto* command = AddCommand(app, "audit", "What was written, and by whom",
                             "  lares audit --since 7d\n"
                             "  lares audit --environment flat-1 --json");
  auto audit = std::make_shared<AuditOptions>();
  command->add_option("--since", audit->since, "7d, 12h, or a time");
  command->add_option("--token", audit->token, "only of this one: its id");
  command->add_option("--environment", audit->environment, "only about this one");
  command->add_option("--limit", audit->limit, "the newest so many")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->callback([audit, &options] {
    const Json all = Ask(*audit, options);
    if (options.json) return PrintJson(all);
    std::vector<std::vector<std::string>> rows;
    for (const Json& record : all.at("items")) {
      const std::string label = TextOf(record, "label");
      rows.push_back({FormatTime(TextOf(record, "time")), label.empty() ? "-" : label,
                      TextOf(record, "operation"), TextOf(record, "result"),
                      TextOf(record, "target")});
    }
    if (rows.empty()) return Print("nothing was written\n");
    Print(FormatTable({"time", "token", "operation", "result", "target"}, rows));
  });
}

}  // namespace lares::cli
