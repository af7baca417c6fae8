#include "recipes/match/match.h"

#include <algorithm>

#include "base/error.h"
#include "recipes/naming.h"

namespace lares::recipes {

namespace {

using prolog::Value;

Availability ToAvailability(const std::string& name) {
  if (name == "available") return Availability::kAvailable;
  if (name == "on_makers_word") return Availability::kOnMakersWord;
  if (name == "derivable") return Availability::kDerivable;
  return Availability::kMissing;
}

Finding ToFinding(const rdf::View& view, const Value& value) {
  Finding finding;
  finding.kind = value.at("kind").text() == "component" ? Finding::Kind::kComponent
                                                        : Finding::Kind::kCapability;
  finding.what = MakeResource(view, value.at("what").text());
  finding.availability = ToAvailability(value.at("availability").text());
  finding.asserted = value.at("asserted").text() == "true";
  finding.provided_by = MakeResources(view, value.at("provided_by"));
  for (const Value& dependency : value.at("dependencies").list()) {
    finding.dependencies.push_back(ToFinding(view, dependency));
  }
  finding.explanation = MakeSentence(view, value.at("explanation"));
  return finding;
}

Need ToNeed(const rdf::View& view, const Value& value) {
  return {MakeResource(view, value.at("step").text()), MakeResource(view, value.at("what").text()),
          MakeResources(view, value.at("chain"))};
}

bool ByLabel(const Resource& a, const Resource& b) {
  return a.label != b.label ? a.label < b.label : a.iri < b.iri;
}

}  // namespace

std::string_view ToString(Availability availability) {
  switch (availability) {
    case Availability::kAvailable:
      return "available";
    case Availability::kOnMakersWord:
      return "on-makers-word";
    case Availability::kDerivable:
      return "derivable";
    case Availability::kMissing:
      return "missing";
  }
  return "missing";
}

Finding MakeFinding(const rdf::View& view, const Value& value) { return ToFinding(view, value); }

MatchReport Match(prolog::EnginePool& engines, const rdf::View& view, const std::string& task_iri,
                  const std::string& robot_iri, const MatchOptions& options) {
  const auto answer = engines.Once(view, "matching", "match",
                                   {Value{prolog::Atom{task_iri}}, Value{prolog::Atom{robot_iri}},
                                    Value{prolog::Atom{options.strict ? "true" : "false"}}});
  if (!answer) throw Error(Code::kInternal, "matching gave no answer");
  if (const auto* failure = std::get_if<prolog::Compound>(&answer->data)) {
    throw Error(Code::kNotFound, MakeSentence(view, failure->arguments.at(0)));
  }
  MatchReport report;
  report.task = MakeResource(view, task_iri);
  report.robot = MakeResource(view, robot_iri);
  report.feasible = answer->at("feasible").text() == "true";
  for (const Value& need : answer->at("needs").list()) report.needs.push_back(ToNeed(view, need));
  for (const Value& finding : answer->at("capabilities").list()) {
    report.capabilities.push_back(ToFinding(view, finding));
  }
  std::sort(report.capabilities.begin(), report.capabilities.end(),
            [](const Finding& a, const Finding& b) { return ByLabel(a.what, b.what); });
  report.smallest_repair = MakeResources(view, answer->at("repair"));
  std::sort(report.smallest_repair.begin(), report.smallest_repair.end(), ByLabel);
  report.warnings = MakeSentences(view, answer->at("warnings"));
  return report;
}

}  // namespace lares::recipes
