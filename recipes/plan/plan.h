// A plan is a value: a state graph of skill calls, made for one robot.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"
#include "recipes/match/match.h"
#include "recipes/resource.h"

namespace lares::recipes {

// One bound argument of a skill.
struct Parameter {
  enum class Source {
    kRecipe,
    kRobot,
    kEnvironment,
    kTemplate,
    kStep
  };                 // kStep: another step's output
  std::string name;  // the template's name for it, a C identifier: "target_pose"
  std::string type;  // "pose", "class", "string", "number", "boolean", "designator", "pose_list"
  std::string unit;  // SI symbol, empty when it has none
  std::string
      value;  // text form: an IRI, a number, "x y z qx qy qz qw" for a pose, a key "{next_pose}"
  std::string frame;  // of poses
  std::string text;   // for people: "Bottle", "in reach of bottle1"
  Source source = Source::kRecipe;
  Resource origin;  // the thing it was taken from
};
std::string_view ToString(Parameter::Source source);

struct State {
  std::string id;  // unique in the plan, [A-Za-z0-9_-]+, from the step's name: "check-if-found"
  std::string label;
  Resource step;               // the recipe's step class; empty for ends
  Resource action;             // the general action that the template serves
  std::string skill;           // what the robot runs: "NavigateToPose"; empty for ends
  std::string skill_template;  // IRI
  int rada_distance = 0;       // from the step to the template's action
  std::vector<Parameter> inputs;
  std::map<std::string, std::string> outputs;  // template's output name → blackboard key
  std::vector<std::string> outcomes;  // "succeeded", "failed", "true", "false", "exhausted"
  enum class Kind { kSkill, kEnd } kind = Kind::kSkill;
  bool success = false;  // of an end
};

struct Transition {
  std::string from;
  std::string outcome;
  std::string to;
  bool added = false;  // not in the recipe: Lares added it
  std::string reason;  // why it was added
};

struct Plan {
  Resource task;
  Resource robot;
  std::string environment;  // id; empty without one
  int environment_version = 0;
  std::string start;
  std::vector<State> states;            // in the order they are first reached; ends last
  std::vector<Transition> transitions;  // every outcome of every skill state has one
  std::vector<std::vector<std::string>> unordered;  // steps that the recipe leaves unordered
  std::vector<std::string> notes;                   // for people: what was added or assumed
  MatchReport match;
};

// A step with several applicable templates at the same distance: a choice for a person.
struct Choice {
  Resource step;
  std::vector<Resource> templates;
};

struct PlanOptions {
  bool strict = false;
  std::map<std::string, std::string> templates;  // step IRI → template IRI: answers to choices
  std::string environment;
  int environment_version = 0;
  std::string environment_iri;  // individual or class of the place; empty when unknown
};

// Either a plan, or why not: a match that is not feasible, choices to be made, or problems of the
// recipe ("transition 'X' leads to 'Y', which is no step of it").
struct PlanResult {
  std::optional<Plan> plan;
  MatchReport match;
  std::vector<Choice> choices;
  std::vector<std::string> problems;
};

// `view` holds the catalogue, the recipe, the robot and, when named, the environment.
PlanResult MakePlan(prolog::EnginePool& engines, const rdf::View& view, const std::string& task_iri,
                    const std::string& robot_iri, const PlanOptions& options = {});

// What a recipe document offers, found when it is put.
struct Task {
  Resource task;
  bool top_level = false;      // not a sub-action of another task of the same document
  bool state_machine = false;  // else a partial order
  std::vector<Resource> steps;
  std::vector<std::string> problems;  // each makes the recipe unusable: refused at put
  std::vector<std::string> warnings;
};
// The tasks that `recipe_graph` (a graph of `view`) describes; problems found are in each.
std::vector<Task> FindTasks(prolog::EnginePool& engines, const rdf::View& view,
                            const std::string& recipe_graph);

// The robots (individuals) that `robot_graph` (a graph of `view`) describes.
// Throws kInvalid for a body that cannot be: joints in a circle (as asserted), matrix entries that
// are no finite numbers, missing or given twice, matrices that turn nothing rightly; each named.
std::vector<Resource> FindRobots(prolog::EnginePool& engines, const rdf::View& view,
                                 const std::string& robot_graph);

// Every state reachable from the start; an end reachable from every state, and from the start one
// that is a success or has gone through everything, without a failure that the recipe says nothing
// of; every outcome led on; every parameter bound, on every path; ids unique. One sentence for each
// violation.
std::vector<std::string> CheckPlan(const Plan& plan);

}  // namespace lares::recipes
