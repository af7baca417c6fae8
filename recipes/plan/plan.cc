#include "recipes/plan/plan.h"

#include <algorithm>

#include "base/error.h"
#include "base/number.h"
#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "recipes/naming.h"
#include "recipes/plan/conditions.h"
#include "recipes/plan/parallel.h"
#include "recipes/plan/parameters.h"
#include "recipes/plan/request.h"
#include "recipes/plan/resume.h"
#include "recipes/plan/shape.h"

namespace lares::recipes {

namespace {

using prolog::Atom;
using prolog::Value;

Value Boolean(bool value) { return Value{Atom{value ? "true" : "false"}}; }
bool IsTrue(const Value& value) { return value.text() == "true"; }

Value Texts(const std::vector<std::string>& texts) {
  prolog::List list;
  for (const std::string& text : texts) list.push_back(Value{Atom{text}});
  return Value{std::move(list)};
}

Value PlanningOptions(const rdf::View& view, const PlanOptions& options) {
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
                            {"environment", Value{Atom{options.environment}}},
                            {"layers", Texts(options.layers)},
                            {"given", ToGiven(view, options.set)}}};
}

// A template that stands in the catalogue was checked when it was put: what cannot be read there is
// a fault of it, and told as one.
double NumberFrom(const std::string& text, double largest, const std::string& what) {
  if (text.empty()) return 0;
  const auto number = ToNumber(text);
  if (number && *number >= 0 && *number <= largest) return *number;
  throw Error(Code::kInvalid, what + " of its skill template is '" + text + "'");
}

Fluent ToFluent(const std::string& text, const State& state) {
  const auto fluent = ParseFluent(text);
  if (!fluent) throw Error(Code::kInvalid, "its skill template's condition '" + text + "'");
  return Ground(*fluent, state);
}

void ReadManner(const rdf::View& view, const Value& manner, State& state) {
  state.retries =
      static_cast<int>(NumberFrom(manner.at("retries").text(), kMaxRetries, "retryCount"));
  state.time_limit_s = NumberFrom(manner.at("time_limit").text(), kMaxTimeLimit_s, "timeLimit_s");
  state.tree_fragment = manner.at("fragment").text();
  state.claims = MakeResources(view, manner.at("claims"));
  for (const Value& text : manner.at("preconditions").list()) {
    state.preconditions.push_back(ToFluent(text.text(), state));
  }
  for (const Value& effect : manner.at("effects").list()) {
    const prolog::List& parts = effect.compound().arguments;
    state.effects.push_back({parts.at(0).text(), ToFluent(parts.at(1).text(), state)});
  }
  // What ends for any argument ends before something new begins.
  std::stable_partition(state.effects.begin(), state.effects.end(),
                        [](const Effect& effect) { return effect.fluent.argument == "*"; });
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
  ReadManner(view, value.at("manner"), state);
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

Setting ToSetting(const rdf::View& view, const Value& value) {
  return {value.at("name").text(),
          value.at("type").text(),
          value.at("unit").text(),
          value.at("value").text(),
          MakeSentence(view, value.at("text")),
          IsTrue(value.at("default")),
          ""};
}

// One setting for each name, however many steps it was for.
void ReadOverridden(const rdf::View& view, const Value& overridden, Plan& plan) {
  for (const Value& each : overridden.list()) {
    const prolog::List& parts = each.compound().arguments;
    const std::string name = parts.at(0).text();
    const bool is_known = std::any_of(plan.settings.begin(), plan.settings.end(),
                                      [&](const Setting& setting) { return setting.name == name; });
    if (is_known) continue;
    const Parameter now = ToParameter(view, parts.at(1));
    Setting setting{name, now.type, now.unit, now.value, now.text, false, ""};
    if (std::holds_alternative<prolog::Dict>(parts.at(2).data)) {
      setting.was = ToParameter(view, parts.at(2)).text;
    }
    plan.settings.push_back(std::move(setting));
  }
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
    for (const Resource& step : MakeResources(view, group.at("steps"))) {
      steps.push_back(step.label);
    }
  }
  plan.notes = MakeSentences(view, value.at("notes"));
  for (const Value& setting : value.at("settings").list()) {
    plan.settings.push_back(ToSetting(view, setting));
  }
  ReadOverridden(view, value.at("overridden"), plan);
  std::sort(plan.settings.begin(), plan.settings.end(),
            [](const Setting& a, const Setting& b) { return a.name < b.name; });
  return plan;
}

// How many parts of `kind` the robot has.
int PartsOf(const rdf::View& view, const std::string& robot_iri, const std::string& kind) {
  const rdf::Dictionary& dictionary = view.dictionary();
  const auto type = dictionary.FindIri(std::string(rdf::kRdf) + "type");
  const auto part_of = dictionary.FindIri(std::string(rdf::kLares) + "subComponent");
  const auto robot = dictionary.FindIri(robot_iri);
  const auto wanted = dictionary.FindIri(kind);
  if (!type || !part_of || !robot || !wanted) return 0;
  int count = 0;
  for (const rdf::TermId part : view.Subjects(*type, *wanted)) {
    count += view.Contains({*robot, *part_of, part}) ? 1 : 0;
  }
  return count;
}

std::vector<std::vector<std::string>> UnorderedStates(const Value& value) {
  std::vector<std::vector<std::string>> groups;
  for (const Value& group : value.at("unordered").list()) {
    std::vector<std::string>& ids = groups.emplace_back();
    for (const Value& id : group.at("ids").list()) ids.push_back(id.text());
  }
  return groups;
}

// What the steps that are done have brought about, in the order of the plan that was.
std::vector<Fluent> BroughtAbout(const Plan& plan, const std::vector<std::string>& done) {
  std::vector<Fluent> fluents;
  for (const State& state : plan.states) {
    if (std::find(done.begin(), done.end(), state.id) == done.end()) continue;
    for (const Effect& effect : state.effects) {
      if (effect.outcome == "succeeded") fluents.push_back(effect.fluent);
    }
  }
  return fluents;
}

// Everything that is done with a plan once the rules have made it.
void Finish(const rdf::View& view, const PlanOptions& options,
            const std::vector<std::vector<std::string>>& unordered, Plan& plan,
            std::vector<std::string>& problems) {
  const std::vector<Fluent> brought_about = BroughtAbout(plan, options.done);
  if (!options.from.empty() || !options.done.empty()) Resume(plan, options.from, options.done);
  if (!options.sequential) {
    RunSideBySide(plan, unordered,
                  [&](const std::string& kind) { return PartsOf(view, plan.robot.iri, kind); });
  }
  problems = CheckPlan(plan);
  if (!problems.empty()) return;
  Simulation simulation = Simulate(plan, brought_about);
  plan.assumptions = std::move(simulation.assumptions);
  problems = std::move(simulation.problems);
  if (!simulation.complete) {
    plan.notes.push_back(
        "what the steps need was not followed through every way: there are too many");
  }
}

std::vector<Choice> ReadChoices(const rdf::View& view, const Value& choices) {
  std::vector<Choice> found;
  for (const Value& choice : choices.list()) {
    const prolog::List& parts = choice.compound().arguments;
    found.push_back({MakeResource(view, parts.at(0).text()), MakeResources(view, parts.at(1))});
  }
  return found;
}

std::string TextOrNone(const Value& value) {
  const std::string text = value.text();
  return text == "none" ? "" : text;
}

Declared ToDeclared(const rdf::View& view, const Value& value) {
  Declared declared{value.at("name").text(),
                    value.at("type").text(),
                    value.at("unit").text(),
                    MakeResource(view, TextOrNone(value.at("below"))),
                    "",
                    IsTrue(value.at("optional"))};
  declared.default_text = MakeSentence(view, value.at("default_text"));
  return declared;
}

Task ToTask(const rdf::View& view, const Value& value) {
  Task task;
  task.task = MakeResource(view, value.at("task").text());
  task.top_level = IsTrue(value.at("top_level"));
  task.state_machine = IsTrue(value.at("state_machine"));
  task.steps = MakeResources(view, value.at("steps"));
  for (const Value& parameter : value.at("parameters").list()) {
    task.parameters.push_back(ToDeclared(view, parameter));
  }
  task.problems = MakeSentences(view, value.at("problems"));
  task.warnings = MakeSentences(view, value.at("warnings"));
  return task;
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
  const Reading reading =
      options.reading != nullptr ? *options.reading : ReadRecipe(engines, view, task_iri);
  const Value value = Ask(engines, view, "planning", "plan",
                          {Value{reading.record}, Value{Atom{robot_iri}},
                           PlanningOptions(view, options), Value{Atom{options.environment_iri}}});
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
  Finish(view, options, UnorderedStates(value), plan, result.problems);
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

std::vector<std::string> FindSuspicions(prolog::EnginePool& engines, const rdf::View& view,
                                        const std::string& recipe_graph) {
  return MakeSentences(view,
                       Ask(engines, view, "suspicions", "suspicions", {Value{Atom{recipe_graph}}}));
}

std::vector<Resource> FindRobots(prolog::EnginePool& engines, const rdf::View& view,
                                 const std::string& robot_graph) {
  const std::vector<Value> graph{Value{Atom{robot_graph}}};
  const auto problems = MakeSentences(view, Ask(engines, view, "bodies", "robot_problems", graph));
  if (!problems.empty()) throw Error(Code::kInvalid, Join(problems, "; "));
  return MakeResources(view, Ask(engines, view, "bodies", "robots", graph));
}

}  // namespace lares::recipes
