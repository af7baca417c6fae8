#include "recipes/plan/plan.h"

#include "base/error.h"
#include "base/text.h"
#include "recipes/naming.h"
#include "recipes/plan/parameters.h"

namespace lares::recipes {

namespace {

using prolog::Atom;
using prolog::Value;

Value Boolean(bool value) { return Value{Atom{value ? "true" : "false"}}; }
bool IsTrue(const Value& value) { return value.text() == "true"; }

Value PlanningOptions(const PlanOptions& options) {
  prolog::List answers;
  for (const auto& [step, skill_template] : options.templates) {
    answers.push_back(
        Value{prolog::Compound{"-", {Value{Atom{step}}, Value{Atom{skill_template}}}}});
  }
  prolog::List offers;
  for (const Offer& offer : options.offers) offers.push_back(Value{Atom{offer.class_iri}});
  return Value{prolog::Dict{{"strict", Boolean(options.strict)},
                            {"answers", Value{std::move(answers)}},
                            {"offers", Value{std::move(offers)}},
                            {"environment", Value{Atom{options.environment}}}}};
}

State ToState(const rdf::View& view, const Value& value) {
  State state;
  state.id = value.at("id").text();
  state.step = MakeResource(view, value.at("step").text());
  state.label = state.step.label;
  state.action = MakeResource(view, value.at("action").text());
  state.skill = value.at("skill").text();
  state.skill_template = value.at("template").text();
  state.rada_distance = static_cast<int>(value.at("distance").integer());
  for (const Value& input : value.at("inputs").list()) {
    state.inputs.push_back(ToParameter(view, input));
  }
  for (const Value& output : value.at("outputs").list()) {
    const prolog::List& pair = output.compound().arguments;
    state.outputs.emplace(pair.at(0).text(), pair.at(1).text());
  }
  for (const Value& outcome : value.at("outcomes").list()) {
    state.outcomes.push_back(outcome.text());
  }
  return state;
}

State ToEnd(const Value& value) {
  State state;
  state.id = value.compound().arguments.at(0).text();
  state.label = state.id;
  state.kind = State::Kind::kEnd;
  state.success = IsTrue(value.compound().arguments.at(1));
  return state;
}

Transition ToTransition(const rdf::View& view, const Value& value) {
  return {value.at("from").text(), value.at("outcome").text(), value.at("to").text(),
          IsTrue(value.at("added")), MakeSentence(view, value.at("reason"))};
}

// Matrices that are no poses become problems; there is no plan then.
void ReadStates(const rdf::View& view, const Value& value, Plan& plan,
                std::vector<std::string>& problems) {
  for (const Value& state : value.at("states").list()) {
    try {
      plan.states.push_back(ToState(view, state));
    } catch (const Error& error) {
      if (error.code() != Code::kInvalid) throw;
      const Resource step = MakeResource(view, state.at("step").text());
      problems.push_back("'" + step.label + "' <" + step.as_written + ">: " + error.what());
    }
  }
  for (const Value& end : value.at("ends").list()) plan.states.push_back(ToEnd(end));
}

Plan ReadPlan(const rdf::View& view, const Value& value, std::vector<std::string>& problems) {
  Plan plan;
  plan.start = value.at("start").text();
  ReadStates(view, value, plan, problems);
  for (const Value& transition : value.at("transitions").list()) {
    plan.transitions.push_back(ToTransition(view, transition));
  }
  for (const Value& group : value.at("unordered").list()) {
    std::vector<std::string>& steps = plan.unordered.emplace_back();
    for (const Resource& step : MakeResources(view, group)) steps.push_back(step.label);
  }
  plan.notes = MakeSentences(view, value.at("notes"));
  return plan;
}

std::vector<Choice> ReadChoices(const rdf::View& view, const Value& choices) {
  std::vector<Choice> found;
  for (const Value& choice : choices.list()) {
    const prolog::List& parts = choice.compound().arguments;
    found.push_back({MakeResource(view, parts.at(0).text()), MakeResources(view, parts.at(1))});
  }
  return found;
}

Task ToTask(const rdf::View& view, const Value& value) {
  return {MakeResource(view, value.at("task").text()), IsTrue(value.at("top_level")),
          IsTrue(value.at("state_machine")),           MakeResources(view, value.at("steps")),
          MakeSentences(view, value.at("problems")),   MakeSentences(view, value.at("warnings"))};
}

Value Ask(prolog::EnginePool& engines, const rdf::View& view, const std::string& module,
          const std::string& predicate, const std::vector<Value>& inputs) {
  auto answer = engines.Once(view, module, predicate, inputs);
  if (!answer) throw Error(Code::kInternal, module + ":" + predicate + " gave no answer");
  return *std::move(answer);
}

}  // namespace

PlanResult MakePlan(prolog::EnginePool& engines, const rdf::View& view, const std::string& task_iri,
                    const std::string& robot_iri, const PlanOptions& options) {
  PlanResult result;
  result.match = options.match != nullptr
                     ? *options.match
                     : Match(engines, view, task_iri, robot_iri, {options.strict, options.offers});
  if (!result.match.feasible) return result;
  const Value value = Ask(engines, view, "planning", "plan",
                          {Value{Atom{task_iri}}, Value{Atom{robot_iri}}, PlanningOptions(options),
                           Value{Atom{options.environment_iri}}});
  if (value.find("start") == nullptr) {
    result.choices = ReadChoices(view, value.at("choices"));
    result.problems = MakeSentences(view, value.at("problems"));
    return result;
  }
  Plan plan = ReadPlan(view, value, result.problems);
  plan.task = result.match.task;
  plan.robot = result.match.robot;
  plan.environment = options.environment;
  plan.environment_version = options.environment_version;
  plan.match = result.match;
  if (!result.problems.empty()) return result;
  result.problems = CheckPlan(plan);
  if (result.problems.empty()) result.plan = std::move(plan);
  return result;
}

std::vector<Task> FindTasks(prolog::EnginePool& engines, const rdf::View& view,
                            const std::string& recipe_graph) {
  const Value tasks = Ask(engines, view, "recipe_checks", "tasks", {Value{Atom{recipe_graph}}});
  std::vector<Task> found;
  for (const Value& task : tasks.list()) found.push_back(ToTask(view, task));
  return found;
}

std::vector<Resource> FindRobots(prolog::EnginePool& engines, const rdf::View& view,
                                 const std::string& robot_graph) {
  const std::vector<Value> graph{Value{Atom{robot_graph}}};
  const auto problems = MakeSentences(view, Ask(engines, view, "bodies", "robot_problems", graph));
  if (!problems.empty()) throw Error(Code::kInvalid, Join(problems, "; "));
  return MakeResources(view, Ask(engines, view, "bodies", "robots", graph));
}

}  // namespace lares::recipes
