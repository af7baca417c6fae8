// Matching: what a task needs against what a robot has, with the reasons.
#pragma once

#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"
#include "reasoner/prolog/value.h"
#include "recipes/resource.h"

namespace lares::recipes {

enum class Availability {
  kAvailable,     // every dependency is there, or asserted with nothing against it
  kOnMakersWord,  // asserted by the robot's description although a dependency is absent
  kDerivable,     // missing now, and available once the other missing things are there
  kMissing,
};
std::string_view ToString(Availability availability);  // "available", "on-makers-word", …

// Why something is or is not there: a tree, one node a capability or a component.
struct Finding {
  enum class Kind { kCapability, kComponent };
  Kind kind = Kind::kCapability;
  Resource what;
  Availability availability = Availability::kMissing;
  bool asserted = false;              // capabilities: the robot's description claims it
  std::vector<Resource> provided_by;  // components: the robot's parts that are it;
                                      // capabilities: the asserted (sub)class
  std::vector<Finding> dependencies;  // what it needs, each with its own reasons
  std::string explanation;            // one plain sentence
};

// One step's need, with the chain of classes through which it is inherited.
struct Need {
  Resource step;
  Resource capability;
  std::vector<Resource> inherited_through;  // step's class … the class that states the dependency
};

struct MatchReport {
  Resource task;
  Resource robot;
  bool feasible = false;
  std::vector<Need> needs;
  std::vector<Finding> capabilities;  // one per distinct capability needed, by label
  std::vector<Resource>
      smallest_repair;  // components (or bare capabilities) to add; empty when feasible
  std::vector<std::string> warnings;  // "on the maker's word", unknown terms, …
};

struct MatchOptions {
  bool strict = false;  // a capability on the maker's word counts as missing
};

// A finding as the rules return it.
Finding MakeFinding(const rdf::View& view, const prolog::Value& value);

// `view` holds the catalogue, the recipe and the robot. Throws kNotFound when `task` is no task of
// the view or `robot` no robot.
MatchReport Match(prolog::EnginePool& engines, const rdf::View& view, const std::string& task_iri,
                  const std::string& robot_iri, const MatchOptions& options = {});

}  // namespace lares::recipes
