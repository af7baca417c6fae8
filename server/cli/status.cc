#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "server/cli/command.h"
#include "server/cli/exit_codes.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

void ShowStatus(const Options& options) {
  Remote remote(options.server);
  const Json status = remote.GetJson("/v1/status");
  if (options.json) return PrintJson(status);
  std::string text = "Lares " + TextOf(status, "version") + " at " + remote.url() + ", up for " +
                     std::to_string(static_cast<long>(status.value("uptime_s", 0.0) / 60)) +
                     " min\n";
  const std::string refused = TextOf(status, "writes_refused");
  if (!refused.empty()) text += "writes are refused: " + refused + "\n";
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, count] : status.at("counts").items()) {
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    rows.push_back({words, std::to_string(count.get<std::uint64_t>())});
  }
  Print(text + FormatTable({"WHAT", "COUNT"}, rows));
}

}  // namespace

void AddStatus(CLI::App& app, const Options& options) {
  auto* status = AddCommand(app, "status", "What the server holds", "  lares status");
  status->callback([&options] { ShowStatus(options); });
  auto* version = AddCommand(app, "version", "The version of this program", "  lares version");
  version->callback([&options] {
    if (options.json) return PrintJson({{"version", LARES_VERSION}});
    Print("lares " LARES_VERSION "\n");
  });
  auto* help = AddCommand(app, "help", "What more there is to know", "  lares help exit-codes");
  auto topic = std::make_shared<std::string>();
  help->add_option("TOPIC", *topic, "exit-codes");
  help->callback([topic, &app] {
    if (topic->empty()) return Print(app.help());
    if (*topic != "exit-codes") throw CLI::ValidationError("TOPIC", "is exit-codes");
    Print(ExitCodesText());
  });
}

}  // namespace lares::cli
