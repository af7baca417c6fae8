#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "server/cli/command.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

std::string FormatPosition(const Json& object) {
  if (!object.contains("pose")) return "somewhere";
  const Json& p = object["pose"]["position_m"];
  char text[96];
  std::snprintf(text, sizeof text, "at (%.2f, %.2f, %.2f) m", p[0].get<double>(),
                p[1].get<double>(), p[2].get<double>());
  return text;
}

std::string FormatSeen(const Json& seen) {
  std::string text;
  for (const Json& object : seen) {
    text += "seen: " + TextOf(object, "label") + " " + FormatPosition(object) + " in " +
            TextOf(object, "environment") + " version " +
            std::to_string(object.value("version", 0));
    if (object.contains("age")) text += ", " + TextOf(object, "age");
    text += "\n";
  }
  return text;
}

std::string FormatRanked(const Json& places, const std::string& heading, std::size_t limit) {
  if (places.empty()) return "";
  std::size_t width = 0;
  for (const Json& place : places) width = std::max(width, TextOf(place, "label").size());
  std::string text = heading + "\n";
  for (std::size_t i = 0; i < places.size() && i < limit; ++i) {
    const std::string label = TextOf(places[i], "label");
    const std::string percent = FormatPercent(places[i].value("probability", 0.0));
    text += "  " + label + std::string(width - label.size() + 2, ' ') +
            std::string(percent.size() < 7 ? 7 - percent.size() : 0, ' ') + percent + "\n";
  }
  return text;
}

std::string Format(const Json& answer, std::size_t limit) {
  const Json& prior = answer.at("prior");
  const std::string title = TextOf(prior, "title");
  std::string text = FormatSeen(answer.at("seen"));
  const std::string from =
      "by table '" + TextOf(prior, "name") + "'" +
      (title.empty() || title == TextOf(prior, "name") ? "" : " (" + title + ")");
  const std::string object = TextOf(answer.at("object"), "label");
  const std::string ranked =
      FormatRanked(answer.at("rooms"), object + ": likely rooms, " + from, limit) +
      FormatRanked(answer.at("furniture"), object + ": likely places in them", limit);
  if (!ranked.empty()) return text + ranked;
  return text + "nothing is known " + from + " about where to find " + object + "\n";
}

}  // namespace

void AddWhere(CLI::App& app, const Options& options) {
  auto* where = AddCommand(app, "where", "Where an object is seen, or usually is",
                           "  lares where Cup\n  lares where Cup --prior omics\n"
                           "  lares where Bottle --environment hospital-room");
  auto query = std::make_shared<std::map<std::string, std::string>>();
  auto limit = std::make_shared<std::size_t>(10);
  where->add_option("OBJECT", (*query)["object"], "class of the object: name, label or IRI")
      ->required();
  where->add_option("--prior", (*query)["prior"], "table to answer from (default: our own)");
  where->add_option("--environment", (*query)["environment"], "look there first");
  where->add_option("--version", (*query)["version"], "of the environment");
  where->add_option("--limit", *limit, "places to print")->capture_default_str();
  where->callback([=, &options] {
    Remote remote(options.server);
    std::multimap<std::string, std::string> given;
    for (const auto& [name, value] : *query) {
      if (!value.empty()) given.emplace(name, value);
    }
    const Json answer = remote.GetJson("/v1/likely-places", given);
    if (options.json) return PrintJson(answer);
    Print(Format(answer, *limit));
  });
}

}  // namespace lares::cli
