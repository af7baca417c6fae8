#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "server/cli/command.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

// What a question is about, by the names of its parameters over HTTP.
using Given = std::map<std::string, std::string>;

void AddAbout(CLI::App& command, Given& given) {
  command.add_option("--recipe", given["recipe"], "ask about this recipe too");
  command.add_option("--robot", given["robot"], "ask about this robot too");
  command.add_option("--environment", given["environment"], "ask about this environment too");
  command.add_option("--version", given["version"], "of the environment (default: the newest)");
}

std::string Ask(const Options& options, const std::string& path, const Given& given,
                const std::string& as) {
  http::ClientRequest request;
  request.path = path;
  for (const auto& [name, value] : given) {
    if (!value.empty()) request.query.emplace(name, value);
  }
  if (!as.empty()) request.query.emplace("as", as);
  return Remote(options.server).Send(request).body;
}

void AddTriple(CLI::App& command, Given& given, bool required) {
  for (const auto& [name, what] :
       {std::pair("subject", "what is asked about"),
        std::pair("predicate", "property; 'a' for rdf:type"),
        std::pair("object", "what it should be; a literal as in Turtle")}) {
    std::string upper = name;
    for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    command.add_option(upper, given[name], what)->required(required);
  }
}

std::string FormatWay(const Json& way, const char* measure) {
  if (way.is_null()) return std::string(measure) + ": no named class is above both\n";
  std::string path;
  for (const Json& step : way.at("path"))
    path += (path.empty() ? "" : " – ") + TextOf(step, "label");
  const bool is_rada = std::string(measure) == "Rada";
  return std::string(measure) + ": " +
         (is_rada ? std::to_string(way.value("edges", 0)) + " edges"
                  : FormatPercent(way.value("similarity", 0.0)) + " alike") +
         ", through " + TextOf(way.at("common"), "label") + ": " + path + "\n";
}

}  // namespace

void AddWhy(CLI::App& app, const Options& options) {
  auto given = std::make_shared<Given>();
  auto svg = std::make_shared<std::string>();
  auto contradiction = std::make_shared<bool>(false);
  auto* why = AddCommand(app, "why", "Why something holds: its shortest proof",
                         "  lares why Cup rdfs:subClassOf Container\n"
                         "  lares why cup1 a Container --environment flat --svg proof.svg");
  AddTriple(*why, *given, false);
  AddAbout(*why, *given);
  why->add_option("--svg", *svg, "draw the proof into this file");
  why->add_flag("--contradiction", *contradiction, "prove a contradiction");
  why->callback([=, &options] {
    Given asked = *given;
    if (*contradiction) {
      asked["contradiction"] = "true";
    } else if (asked["object"].empty()) {
      throw CLI::RequiredError("SUBJECT PREDICATE OBJECT");
    }
    if (!svg->empty()) {
      WriteFileAtomically(*svg, Ask(options, "/v1/why", asked, "svg"));
      return Print("wrote " + *svg + "\n");
    }
    Print(Ask(options, "/v1/why", asked, options.json ? "json" : "text"));
  });

  auto lacking = std::make_shared<Given>();
  auto* why_not = AddCommand(app, "why-not", "Why something does not hold: what is missing",
                             "  lares why-not cup1 a Container --environment flat\n"
                             "  lares why-not scout hasCapability Grasping --robot scout");
  AddTriple(*why_not, *lacking, true);
  AddAbout(*why_not, *lacking);
  why_not->callback([=, &options] {
    Print(Ask(options, "/v1/why-not", *lacking, options.json ? "json" : "text"));
  });
}

void AddDistance(CLI::App& app, const Options& options) {
  auto given = std::make_shared<Given>();
  auto measure = std::make_shared<std::string>();
  auto* distance =
      AddCommand(app, "distance", "How far apart two classes are",
                 "  lares distance Cup Bottle\n  lares distance Cup Bottle --measure rada");
  distance->add_option("FROM", (*given)["from"], "class")->required();
  distance->add_option("TO", (*given)["to"], "class")->required();
  distance->add_option("--measure", *measure, "only this one")
      ->check(CLI::IsMember({"rada", "wu-palmer"}));
  AddAbout(*distance, *given);
  distance->callback([=, &options] {
    const Json answer = Json::parse(Ask(options, "/v1/distances", *given, ""));
    if (options.json) return PrintJson(answer);
    std::string text;
    if (*measure != "wu-palmer") text += FormatWay(answer.at("rada"), "Rada");
    if (*measure != "rada") text += FormatWay(answer.at("wu_palmer"), "Wu–Palmer");
    Print(text);
  });
}

}  // namespace lares::cli
