// The plan's graph as a planning problem: where it is, is a fact (at-state s); each outcome of each
// state is an action that leads on and changes what the templates say. Which outcome comes is
// nature's choice and here the planner's: a plan that is found shows that the graph can succeed.
#include <algorithm>
#include <sstream>

#include "base/text.h"
#include "recipes/plan/export.h"
#include "recipes/plan/pddl_names.h"
#include "recipes/plan/shape.h"

namespace lares::recipes {
namespace {

// A fact without its truth. Facts of the same name with and without an argument are different ones.
struct Fact {
  std::string name;
  std::string argument;
  friend auto operator<=>(const Fact&, const Fact&) = default;
};
Fact ToFact(const Fluent& fluent) { return {fluent.name, fluent.argument}; }

using Facts = std::map<Fact, bool>;  // and whether they are so

struct Action {
  std::string name;
  std::string comment;
  const State* from = nullptr;
  const State* to = nullptr;
  Facts needs;
  Facts changes;
};

std::string Name(const Fact& fact, PddlNames& predicates) {
  const bool unary = !fact.argument.empty();
  return predicates.Of(fact.name + (unary ? "/1" : "/0"), fact.name);
}

// Everything that the two documents say, under the same names.
class Grounding {
 public:
  explicit Grounding(const Plan& plan) : plan_(plan), ways_(WaysOf(plan)) {
    predicates_.Of("at-state", "at-state");
    predicates_.Of("succeeded", "succeeded");
    for (const State& state : plan.states) {
      if (state.parallel.empty()) StateName(state);
      for (const Fluent& fluent : state.preconditions) Know(fluent);
      for (const Effect& effect : state.effects) Know(effect.fluent);
    }
    for (const Fluent& fluent : plan.assumptions) Know(fluent);
    for (const Fact& fact : facts_) Text(fact);
    for (const State& state : plan.states) AddActions(state);
  }

  std::string Domain();
  std::string Problem();

 private:
  void Know(const Fluent& fluent) {
    if (fluent.argument != "*") facts_.insert(ToFact(fluent));
  }

  const std::string& StateName(const State& state) { return states_.Of(state.id, state.id); }

  std::string Text(const Fact& fact) {
    const std::string name = Name(fact, predicates_);
    if (fact.argument.empty()) return "(" + name + ")";
    return "(" + name + " v-" + values_.Of(fact.argument, LocalName(fact.argument)) + ")";
  }
  std::string Text(const Facts::value_type& fact) {
    return fact.second ? Text(fact.first) : "(not " + Text(fact.first) + ")";
  }

  // "*" stands for every argument that the plan speaks of.
  void Set(const Fluent& fluent, Facts& facts) const {
    if (fluent.argument != "*") {
      facts[ToFact(fluent)] = fluent.holds;
      return;
    }
    for (const Fact& fact : facts_) {
      if (fact.name == fluent.name && !fact.argument.empty()) facts[fact] = fluent.holds;
    }
  }

  void AddActions(const State& state) {
    const auto ways = ways_.find(state.id);
    if (state.kind == State::Kind::kEnd || ways == ways_.end()) return;
    const std::vector<const State*> running = Running(plan_, state);
    for (const auto& [outcome, to] : ways->second) {
      const State* next = FindState(plan_, to);
      if (next == nullptr) continue;
      if (state.kind == State::Kind::kParallel && outcome == "failed") {
        // Whichever fails first; what the others have changed until then is not known, and taken to
        // be nothing.
        for (const State* member : running) {
          AddAction(state, outcome, *next, running, {member}, "__" + member->id);
        }
      } else {
        AddAction(state, outcome, *next, running, running, "");
      }
    }
  }

  void AddAction(const State& state, const std::string& outcome, const State& next,
                 const std::vector<const State*>& running, const std::vector<const State*>& ending,
                 const std::string& suffix) {
    Action action;
    const std::string plain = state.id + "__" + outcome + suffix;
    action.name = actions_names_.Of(plain, plain);
    action.comment = state.id + " ends as " + outcome + (suffix.empty() ? "" : ", by ") +
                     (suffix.empty() ? "" : suffix.substr(2));
    action.from = &state;
    action.to = &next;
    for (const State* each : running) {
      for (const Fluent& fluent : each->preconditions) Set(fluent, action.needs);
    }
    for (const State* each : ending) {
      for (const Effect& effect : each->effects) {
        if (effect.outcome == outcome) Set(effect.fluent, action.changes);
      }
    }
    actions_.push_back(std::move(action));
  }

  std::string Text(const Action& action);

  const Plan& plan_;
  const Ways ways_;
  PddlNames states_;
  PddlNames values_;
  PddlNames predicates_;
  PddlNames actions_names_;
  std::set<Fact> facts_;
  std::vector<Action> actions_;
};

// Comments reach to the end of their line.
std::string OneLine(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return text;
}

std::string TaskName(const Plan& plan) { return PddlName(LocalName(plan.task.iri)); }

std::string Grounding::Text(const Action& action) {
  std::ostringstream out;
  const std::string from = "(at-state s-" + StateName(*action.from) + ")";
  const std::string to = "(at-state s-" + StateName(*action.to) + ")";
  out << "  ; " << OneLine(action.comment) << "\n  (:action " << action.name
      << "\n    :parameters ()\n    :precondition (and " << from;
  for (const auto& fact : action.needs) out << " " << Text(fact);
  out << ")\n    :effect (and";
  if (action.from != action.to) out << " (not " << from << ")";
  out << " " << to;
  if (action.to->success) out << " (succeeded)";
  for (const auto& fact : action.changes) out << " " << Text(fact);
  out << "))\n";
  return out.str();
}

std::string Grounding::Domain() {
  std::ostringstream out;
  out << "; " << OneLine(plan_.task.label + " by " + plan_.robot.label) << "\n(define (domain "
      << TaskName(plan_) << ")\n  (:requirements :strips :typing :negative-preconditions)\n"
      << "  (:types state value - object)\n  (:constants\n";
  for (const State& state : plan_.states) {
    if (state.parallel.empty()) out << "    s-" << StateName(state) << " - state\n";
  }
  std::set<std::string> values;
  std::set<std::string> predicates;
  for (const Fact& fact : facts_) {
    const bool unary = !fact.argument.empty();
    if (unary) values.insert(values_.Of(fact.argument, LocalName(fact.argument)));
    predicates.insert("(" + Name(fact, predicates_) + (unary ? " ?x - value)" : ")"));
  }
  for (const std::string& value : values) out << "    v-" << value << " - value\n";
  out << "  )\n  (:predicates\n    (at-state ?s - state)\n    (succeeded)\n";
  for (const std::string& predicate : predicates) out << "    " << predicate << "\n";
  out << "  )\n";
  for (const Action& action : actions_) out << Text(action);
  out << ")\n";
  return out.str();
}

std::string Grounding::Problem() {
  std::ostringstream out;
  out << "(define (problem " << TaskName(plan_) << "-for-" << PddlName(LocalName(plan_.robot.iri))
      << ")\n  (:domain " << TaskName(plan_) << ")\n  (:init\n";
  if (const State* start = FindState(plan_, plan_.start)) {
    out << "    (at-state s-" << StateName(*start) << ")\n";
  }
  Facts initially;
  for (const Fluent& fluent : plan_.assumptions) Set(fluent, initially);
  for (const auto& [fact, holds] : initially) {
    if (holds) out << "    " << Text(fact) << "\n";
  }
  out << "  )\n  (:goal (succeeded))\n)\n";
  return out.str();
}

}  // namespace

std::string ToPddlDomain(const Plan& plan) { return Grounding(plan).Domain(); }

std::string ToPddlProblem(const Plan& plan) { return Grounding(plan).Problem(); }

}  // namespace lares::recipes
