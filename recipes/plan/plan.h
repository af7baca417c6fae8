// A plan is a value: a state graph of skill calls, made for one robot.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"
#include "recipes/match/match.h"
#include "recipes/plan/reading.h"
#include "recipes/resource.h"

namespace lares::recipes {

// One bound argument of a skill.
struct Parameter {
  enum class Source {
    kRecipe,
    kRobot,
    kEnvironment,
    kTemplate,
    kStep,     // another step's output
    kRequest,  // whoever asked for the plan
  };
  std::string name;  // the template's name for it, a C identifier: "target_pose"
  // "pose", "class", "string", "number", "boolean", "designator", "pose_list", "class_list",
  // "designator_list"
  std::string type;
  std::string unit;  // SI symbol, empty when it has none
  // Text form: an IRI, a number, "x y z qx qy qz qw" for a pose, a key "{next_pose}"; of lists of
  // IRIs with spaces between.
  std::string value;
  std::string frame;  // of poses
  std::string text;   // for people: "Bottle", "in reach of bottle1"
  Source source = Source::kRecipe;
  Resource origin;  // the thing it was taken from
};
std::string_view ToString(Parameter::Source source);

// Something that may be so while a plan runs: "holding(…#cup1)" is {"holding", "…#cup1", true}.
struct Fluent {
  std::string name;      // a C identifier
  std::string argument;  // a bound value, "*" for any (in effects that end something); may be empty
  bool holds = true;     // else it is what must not be so, or no longer is
  friend bool operator==(const Fluent&, const Fluent&) = default;
};
std::string ToText(const Fluent& fluent);  // "not holding(cup1)", long IRIs by their local names

// What is so after a skill has ended with an outcome.
struct Effect {
  std::string outcome;
  Fluent fluent;
};

constexpr double kMaxRetries = 100;
constexpr double kMaxTimeLimit_s = 7 * 24 * 3600;

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
  // kParallel runs its members side by side: "succeeded" when each has, "failed" as soon as one
  // has, the others being stopped. Members are skill states that only it leads to: they have no
  // transitions of their own.
  enum class Kind { kSkill, kParallel, kEnd } kind = Kind::kSkill;
  bool success = false;              // of an end
  std::vector<std::string> members;  // of kParallel: ids
  std::string parallel;              // of a member: the id of what runs it
  int retries = 0;                   // further attempts while the outcome is "failed"
  double time_limit_s = 0;           // of one attempt, which fails then; 0: none
  // The template's own BehaviorTree.CPP decorators around the skill, "<Skill/>" standing for it;
  // empty: made from retries and time_limit_s.
  std::string tree_fragment;
  std::vector<Resource> claims;  // kinds of parts that nothing else may use meanwhile
  std::vector<Fluent> preconditions;
  std::vector<Effect> effects;
};

struct Transition {
  std::string from;
  std::string outcome;
  std::string to;
  bool added = false;  // not in the recipe: Lares added it
  std::string reason;  // why it was added
};

// A value that the recipe leaves to whoever asks for a plan.
struct Setting {
  std::string name;
  std::string type;        // as of Parameter, and "class_list", "designator_list"
  std::string unit;        // SI symbol, empty when it has none
  std::string value;       // text form; lists are separated by spaces
  std::string text;        // for people
  bool is_default = true;  // nobody asked for another value
  std::string was;         // text of the default that it overrides; empty without one
};

// A parameter that a recipe declares.
struct Declared {
  std::string name;
  std::string type;
  std::string unit;
  Resource below;            // what is above every value; empty when it is not said
  std::string default_text;  // for people; empty without one
  bool optional = false;
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
  std::vector<Setting> settings;    // the recipe's parameters and overridden constants, by name
  std::vector<Fluent> assumptions;  // what must be so at the start
  std::vector<std::string> done;    // ids of states of the plan that was, for one made anew
  std::vector<std::string> given;   // keys that those have created
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
  std::string environment_iri;      // individual or class of the place; empty when unknown
  std::vector<std::string> layers;  // kinds of layers that the environment has: "octomap"
  // Parameters of the recipe, or inputs of its skills: name → value as written.
  std::map<std::string, std::string> set;
  bool sequential = false;             // nothing side by side
  std::vector<Offer> offers;           // what can be downloaded: it counts as the robot's
  const MatchReport* match = nullptr;  // where it was found before
  const Reading* reading = nullptr;    // where the task was read before
  // A plan made anew: where to go on (empty: where the first step that is not done begins) and
  // which states are done already, by the ids of the plan that was.
  std::string from;
  std::vector<std::string> done;
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
  std::vector<Declared> parameters;
  std::vector<std::string> problems;  // each makes the recipe unusable: refused at put
  std::vector<std::string> warnings;
};
// The tasks that `recipe_graph` (a graph of `view`) describes; problems found are in each.
std::vector<Task> FindTasks(prolog::EnginePool& engines, const rdf::View& view,
                            const std::string& recipe_graph);

// What the author of `recipe_graph` probably did not mean: misspelt vocabulary, swapped roles,
// individuals where classes belong. One sentence each, with the IRIs as written.
std::vector<std::string> FindSuspicions(prolog::EnginePool& engines, const rdf::View& view,
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
