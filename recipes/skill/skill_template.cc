#include "recipes/skill/skill_template.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "recipes/naming.h"
#include "recipes/plan/conditions.h"
#include "recipes/plan/export_fragment.h"

namespace lares::recipes {
namespace {

using prolog::Atom;
using prolog::Value;

std::vector<std::string> Texts(const Value& list) {
  std::vector<std::string> texts;
  for (const Value& text : list.list()) texts.push_back(text.text());
  return texts;
}

Resource MaybeResource(const rdf::View& view, const Value& iri) {
  return iri.text() == "none" ? Resource{} : MakeResource(view, iri.text());
}

void ReadParameters(const rdf::View& view, const Value& value, SkillTemplate& found) {
  for (const Value& input : value.at("inputs").list()) {
    found.inputs.push_back({input.at("name").text(), input.at("type").text(),
                            input.at("unit").text(), input.at("optional").text() == "true",
                            MakeSentences(view, input.at("sources"))});
  }
  for (const Value& output : value.at("outputs").list()) {
    found.outputs.push_back({output.at("name").text(), output.at("type").text(),
                             MakeResource(view, output.at("property").text())});
  }
}

void ReadOutcomes(const rdf::View& view, const Value& value, SkillTemplate& found) {
  for (const Value& outcome : value.at("outcomes").list()) {
    found.outcomes.push_back(
        {outcome.at("name").text(), MaybeResource(view, outcome.at("means")), {}});
  }
  for (const Value& effect : value.at("manner").at("effects").list()) {
    const prolog::List& parts = effect.compound().arguments;
    for (SkillOutcome& outcome : found.outcomes) {
      if (outcome.name == parts.at(0).text()) outcome.effects.push_back(parts.at(1).text());
    }
  }
}

bool HasParameter(const SkillTemplate& found, const std::string& name) {
  return std::any_of(found.inputs.begin(), found.inputs.end(),
                     [&](const SkillInput& input) { return input.name == name; }) ||
         std::any_of(found.outputs.begin(), found.outputs.end(),
                     [&](const SkillOutput& output) { return output.name == name; });
}

void CheckFluent(const std::string& text, const std::string& what, bool may_be_any,
                 SkillTemplate& found) {
  const std::string place =
      "'" + found.iri.label + "' <" + found.iri.as_written + ">: the " + what + " '" + text + "' ";
  const auto fluent = ParseFluent(text);
  if (!fluent) {
    return found.problems.push_back(
        place +
        "cannot be read: it is a name, with 'not ' before it or an input's name in brackets "
        "after it");
  }
  if (fluent->argument.empty()) return;
  if (fluent->argument == "*") {
    if (!may_be_any || fluent->holds) {
      found.problems.push_back(place + "uses '*', which only an effect that ends something can");
    }
  } else if (!HasParameter(found, fluent->argument)) {
    found.problems.push_back(place + "is about '" + fluent->argument +
                             "', which is no input or output");
  }
}

void CheckConditions(SkillTemplate& found) {
  const std::vector<std::string> preconditions = found.preconditions;
  for (const std::string& text : preconditions) CheckFluent(text, "precondition", false, found);
  const std::vector<SkillOutcome> outcomes = found.outcomes;
  for (const SkillOutcome& outcome : outcomes) {
    std::set<std::string> lasting;
    for (const std::string& text : outcome.effects) {
      CheckFluent(text, "effect", true, found);
      const auto fluent = ParseFluent(text);
      if (!fluent || fluent->argument == "*") continue;
      Fluent opposite = *fluent;
      opposite.holds = !opposite.holds;
      lasting.insert(ToText(*fluent));
      if (lasting.count(ToText(opposite)) > 0) {
        found.problems.push_back("'" + found.iri.label + "' <" + found.iri.as_written +
                                 ">: after '" + outcome.name + "' " + fluent->name +
                                 " both is so and is not");
      }
    }
  }
}

SkillTemplate ToTemplate(const rdf::View& view, const Value& value) {
  SkillTemplate found;
  found.iri = MakeResource(view, value.at("template").text());
  found.comment = value.at("comment").text();
  found.actions = MakeResources(view, value.at("actions"));
  found.skill = value.at("skill").text();
  found.conditions = MakeSentences(view, value.at("conditions"));
  ReadParameters(view, value, found);
  ReadOutcomes(view, value, found);
  const Value& manner = value.at("manner");
  found.retries = manner.at("retries").text();
  found.time_limit_s = manner.at("time_limit").text();
  found.tree_fragment = manner.at("fragment").text();
  found.claims = MakeResources(view, manner.at("claims"));
  found.preconditions = Texts(manner.at("preconditions"));
  found.problems = MakeSentences(view, value.at("problems"));
  found.warnings = MakeSentences(view, value.at("warnings"));
  CheckConditions(found);
  if (!found.tree_fragment.empty()) {
    for (const std::string& problem : TreeFragmentProblems(found.tree_fragment)) {
      found.problems.push_back("'" + found.iri.label + "' <" + found.iri.as_written +
                               ">: its treeFragment: " + problem);
    }
  }
  return found;
}

}  // namespace

std::vector<SkillTemplate> FindTemplates(prolog::EnginePool& engines, const rdf::View& view,
                                         const std::string& graph) {
  const auto answer = engines.Once(view, "template_checks", "described_templates",
                                   {Value{Atom{graph.empty() ? "all" : graph}}});
  if (!answer) throw Error(Code::kInternal, "template_checks:described_templates gave no answer");
  std::vector<SkillTemplate> templates;
  for (const Value& value : answer->list()) templates.push_back(ToTemplate(view, value));
  return templates;
}

}  // namespace lares::recipes
