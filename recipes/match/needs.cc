#include "recipes/match/needs.h"

#include <algorithm>

#include "base/error.h"
#include "ontology/rdf/vocabulary.h"
#include "recipes/naming.h"

namespace lares::recipes {

namespace {

using prolog::Atom;
using prolog::Value;

// Reads one answer of needs/3.
class Reader {
 public:
  Reader(const rdf::View& view, const Value& answer) : view_(view), answer_(answer) {}

  Needs Read(const std::string& task_iri) {
    needs_.dictionary = view_.shared_dictionary();
    needs_.task = MakeResource(view_, task_iri);
    NumberNodes();
    for (const Value& node : answer_.at("nodes").list()) ReadNode(node);
    for (const Value& wanted : answer_.at("wanted").list())
      needs_.wanted.push_back(ToClause(wanted));
    for (const Value& need : answer_.at("steps").list()) ReadStep(need);
    for (const Value& step : answer_.at("groups").list()) {
      needs_.step_groups.push_back(
          {MakeResource(view_, step.at("step").text()), ReadGroup(step.at("group"))});
    }
    needs_.sought = MakeResources(view_, answer_.at("sought"));
    FindSpecialCases();
    return std::move(needs_);
  }

 private:
  // Nodes are in the order of their IRIs, so that equal needs are equal however they were found.
  void NumberNodes() {
    std::vector<std::string> classes;
    for (const Value& node : answer_.at("nodes").list()) classes.push_back(node.at("class").text());
    std::sort(classes.begin(), classes.end());
    for (const std::string& iri : classes) {
      index_.emplace(iri, needs_.nodes.size());
      needs_.nodes.emplace_back().what = MakeResource(view_, iri);
    }
  }

  std::size_t IndexOf(const std::string& iri) const { return index_.at(iri); }

  Clause ToClause(const Value& requirement) const {
    const auto* any = std::get_if<prolog::Compound>(&requirement.data);
    if (any == nullptr) return {IndexOf(requirement.text())};
    Clause clause;
    for (const Value& member : any->arguments.at(0).list())
      clause.push_back(IndexOf(member.text()));
    return clause;
  }

  void ReadNode(const Value& value) {
    NeedNode& node = needs_.nodes[IndexOf(value.at("class").text())];
    node.is_capability = value.at("kind").text() == "capability";
    node.cost = value.at("cost").number();
    for (const Value& requirement : value.at("requirements").list()) {
      node.requirements.push_back(ToClause(requirement));
    }
    for (const Value& special : value.at("special_cases").list()) {
      node.special_cases.push_back(IndexOf(special.text()));
    }
    for (const Value& group : value.at("groups").list()) node.groups.push_back(ReadGroup(group));
  }

  std::optional<double> ToEnd(const Value& value) const {
    if (std::holds_alternative<Atom>(value.data)) return {};
    return value.number();
  }

  std::size_t ReadGroup(const Value& value) {
    BoundGroup group;
    group.part = IndexOf(value.at("part").text());
    group.of_robot = value.at("part").text() == std::string(rdf::kLares) + "Robot";
    for (const Value& bound : value.at("bounds").list()) {
      const std::string& quantity = bound.at("quantity").text();
      group.bounds.push_back({MakeResource(view_, quantity), view_.dictionary().InternIri(quantity),
                              bound.at("unit").text(), ToEnd(bound.at("least")),
                              ToEnd(bound.at("most")),
                              MakeResource(view_, bound.at("stated_by").text())});
    }
    return KeepGroup(std::move(group));
  }

  // The same bounds of two subjects are one group: one part meets both.
  std::size_t KeepGroup(BoundGroup group) {
    const auto same = [](const Bound& a, const Bound& b) {
      return a.property == b.property && a.least == b.least && a.most == b.most;
    };
    for (std::size_t i = 0; i < needs_.groups.size(); ++i) {
      const BoundGroup& other = needs_.groups[i];
      if (other.part == group.part && std::equal(other.bounds.begin(), other.bounds.end(),
                                                 group.bounds.begin(), group.bounds.end(), same)) {
        return i;
      }
    }
    needs_.groups.push_back(std::move(group));
    return needs_.groups.size() - 1;
  }

  void ReadStep(const Value& value) {
    const Value& what = value.at("what");
    Needs::StepNeed step;
    step.need.step = MakeResource(view_, value.at("step").text());
    // What something more special is needed for anyway is no node of its own.
    if (std::holds_alternative<Atom>(what.data)) {
      step.need.capability = MakeResource(view_, what.text());
    } else if (IsWanted(what)) {
      step.wanted = ToClause(what);
    }
    step.need.inherited_through = MakeResources(view_, value.at("chain"));
    needs_.steps.push_back(std::move(step));
  }

  bool IsWanted(const Value& requirement) const {
    const prolog::List& wanted = answer_.at("wanted").list();
    return std::find(wanted.begin(), wanted.end(), requirement) != wanted.end();
  }

  void FindSpecialCases() {
    const rdf::TermId sub_class =
        view_.dictionary().InternIri(std::string(rdf::kRdfs) + "subClassOf");
    for (std::size_t i = 0; i < needs_.nodes.size(); ++i) {
      const rdf::TermId node = view_.dictionary().InternIri(needs_.nodes[i].what.iri);
      std::vector<rdf::TermId> below = view_.Subjects(sub_class, node);
      below.push_back(node);
      std::sort(below.begin(), below.end());
      below.erase(std::unique(below.begin(), below.end()), below.end());
      for (const rdf::TermId one : below) needs_.nodes_above[one].push_back(i);
    }
    for (std::size_t i = 0; i < needs_.nodes.size(); ++i) {
      const rdf::TermId node = view_.dictionary().InternIri(needs_.nodes[i].what.iri);
      for (const std::size_t above : needs_.nodes_above[node]) {
        if (above != i) needs_.nodes[i].above.push_back(above);
      }
    }
  }

  const rdf::View& view_;
  const Value& answer_;
  Needs needs_;
  std::unordered_map<std::string, std::size_t> index_;
};

}  // namespace

Needs FindNeeds(prolog::EnginePool& engines, const rdf::View& view, const std::string& task_iri,
                const std::string& robot_iri) {
  const std::string robot = robot_iri.empty() ? "none" : robot_iri;
  const auto answer =
      engines.Once(view, "matching", "needs", {Value{Atom{task_iri}}, Value{Atom{robot}}});
  if (!answer) throw Error(Code::kInternal, "matching:needs gave no answer");
  if (const auto* failure = std::get_if<prolog::Compound>(&answer->data)) {
    throw Error(Code::kNotFound, MakeSentence(view, failure->arguments.at(0)));
  }
  return Reader(view, *answer).Read(task_iri);
}

Needs FindCapabilityNeeds(prolog::EnginePool& engines, const rdf::View& view,
                          const std::string& robot_iri) {
  const auto answer = engines.Once(view, "matching", "capability_needs", {Value{Atom{robot_iri}}});
  if (!answer) throw Error(Code::kInternal, "matching:capability_needs gave no answer");
  return Reader(view, *answer).Read(std::string(rdf::kLares) + "Capability");
}

}  // namespace lares::recipes
