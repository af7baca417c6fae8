#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "server/cli/command.h"
#include "server/cli/documents.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

constexpr const char* kCollection = "/v1/skill-templates";
const DocumentCommand kSkills{kCollection, "skill", "", [](const Json&) { return ""; },
                              "skill-template"};

std::string Labels(const Json& resources) {
  std::string text;
  for (const Json& each : resources) text += (text.empty() ? "" : ", ") + TextOf(each, "label");
  return text;
}

std::string Texts(const Json& texts) {
  std::string all;
  for (const Json& each : texts) all += (all.empty() ? "" : ", ") + each.get<std::string>();
  return all;
}

void ListSkills(const Options& options) {
  Remote remote(options.server);
  const Json list = remote.GetList(kCollection);
  if (options.json) return PrintJson(list);
  std::vector<std::vector<std::string>> rows;
  for (const Json& item : list.at("items")) {
    const Json document = item.value("document", Json());
    rows.push_back({TextOf(item, "skill"), Labels(item.at("actions")), Texts(item.at("conditions")),
                    document.is_string() ? document.get<std::string>() : "built-in"});
  }
  Print(FormatTable({"SKILL", "FOR", "CONDITIONS", "DOCUMENT"}, rows));
}

std::string Limits(const Json& item) {
  std::string text;
  if (item.contains("retries")) text += "tried again " + TextOf(item, "retries") + " times";
  if (item.contains("time_limit_s")) {
    text += (text.empty() ? "" : ", ") + ("at most " + TextOf(item, "time_limit_s") + " s each");
  }
  return text;
}

void Line(std::string& text, const std::string& name, const std::string& value) {
  if (!value.empty()) text += "  " + name + std::string(12 - name.size(), ' ') + value + "\n";
}

std::string Describe(const Json& item) {
  std::string text = TextOf(item, "skill") + ": " + TextOf(item, "comment") + "\n";
  Line(text, "template", TextOf(item, "iri"));
  Line(text, "for", Labels(item.at("actions")));
  Line(text, "applies", Texts(item.at("conditions")));
  for (const Json& input : item.at("inputs")) {
    const std::string unit = TextOf(input, "unit");
    Line(text, "input",
         TextOf(input, "name") + " (" + TextOf(input, "type") + (unit.empty() ? "" : ", " + unit) +
             (input.value("optional", false) ? ", optional" : "") +
             "): " + Texts(input.at("sources")));
  }
  for (const Json& output : item.at("outputs")) {
    Line(text, "output", TextOf(output, "name") + " (" + TextOf(output, "type") + ")");
  }
  for (const Json& outcome : item.at("outcomes")) {
    const std::string means =
        outcome.at("means").is_object() ? ", " + TextOf(outcome.at("means"), "label") : "";
    const std::string effects = Texts(outcome.at("effects"));
    Line(text, "outcome",
         TextOf(outcome, "name") + means + (effects.empty() ? "" : "; then " + effects));
  }
  Line(text, "needs", Texts(item.at("preconditions")));
  Line(text, "claims", Labels(item.at("claims")));
  Line(text, "limits", Limits(item));
  Line(text, "fragment", TextOf(item, "tree_fragment"));
  return text;
}

bool GoesBy(const Json& item, const std::string& name) {
  const std::string lower = ToLower(name);
  return TextOf(item, "iri") == name || ToLower(TextOf(item, "skill")) == lower ||
         ToLower(TextOf(item, "label")) == lower ||
         ToLower(std::string(LocalName(TextOf(item, "iri")))) == lower ||
         (item.value("document", Json()).is_string() && item.at("document") == name);
}

void ShowSkill(const std::string& name, const Options& options) {
  Remote remote(options.server);
  const Json list = remote.GetList(kCollection);
  Json found = Json::array();
  std::vector<std::string> known;
  for (const Json& item : list.at("items")) {
    known.push_back(TextOf(item, "skill"));
    if (GoesBy(item, name)) found.push_back(item);
  }
  if (found.empty()) {
    throw Error(Code::kNotFound, "no skill template is called '" + name + "'")
        .WithCandidates(SimilarNames(name, known));
  }
  if (options.json) return PrintJson(found);
  std::string text;
  for (const Json& item : found) text += (text.empty() ? "" : "\n") + Describe(item);
  Print(text);
}

}  // namespace

void AddSkill(CLI::App& app, const Options& options) {
  auto* skill = AddCommand(app, "skill", "Skill templates: what robots' programs can carry out",
                           "  lares skill list\n  lares skill show NavigateToPose\n"
                           "  lares skill put my-skills.ttl");
  skill->require_subcommand(1);
  auto* show = AddCommand(*skill, "show", "What a template says: conditions, inputs, outcomes",
                          "  lares skill show NavigateToPose\n  lares skill show Dock --json");
  auto name = std::make_shared<std::string>();
  show->add_option("NAME", *name, "skill, label, IRI, or id of a document")->required();
  show->callback([=, &options] { ShowSkill(*name, options); });
  AddDocumentCommands(*skill, kSkills, options, "my-skills.ttl");
  auto* list = skill->get_subcommand("list");
  list->description("The skills that plans are made of");
  list->callback([&options] { ListSkills(options); });
}

}  // namespace lares::cli
