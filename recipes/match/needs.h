// What a task needs, and all that this rests on: the same for every robot.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"
#include "recipes/resource.h"

namespace lares::recipes {

// A number that a quantity of a part must keep within; both ends in `unit`.
struct Bound {
  Resource quantity;
  rdf::TermId property{};
  std::string unit;  // "m", "rad", "px", "kg", …
  std::optional<double> least;
  std::optional<double> most;
  Resource stated_by;  // the class or template that requires it
};

// What one subject requires of one class of parts: one part must keep all bounds.
struct BoundGroup {
  std::size_t part = 0;  // node: the class of parts; lares:Robot for the robot itself
  bool of_robot = false;
  std::vector<Bound> bounds;
};

// Any one of these nodes will do.
using Clause = std::vector<std::size_t>;

// A capability or a class of components.
struct NeedNode {
  Resource what;
  bool is_capability = false;
  std::vector<Clause> requirements;  // all of them
  std::vector<std::size_t>
      special_cases;                // capabilities without requirements: one of these will do
  std::vector<std::size_t> groups;  // what it requires in numbers
  std::vector<std::size_t> above;   // the other nodes of which it is a special case
  double cost = 0;                  // of adding one
};

// One step's need, with the chain of classes through which it is inherited.
struct Need {
  Resource step;
  Resource capability;
  std::vector<Resource> inherited_through;  // step's class … the class that states the dependency
};

// A value: it keeps no view. TermIds are those of `dictionary`.
struct Needs {
  std::shared_ptr<const rdf::Dictionary> dictionary;
  struct StepNeed {
    Need need;      // `capability` is empty for a union
    Clause wanted;  // the members of a union that is among those of `wanted` below
  };
  struct StepGroup {
    Resource step;
    std::size_t group = 0;
  };
  Resource task;
  std::vector<StepNeed> steps;
  std::vector<Clause> wanted;  // the most specific of what the steps need
  std::vector<NeedNode> nodes;
  std::vector<BoundGroup> groups;  // each distinct one once
  std::vector<StepGroup> step_groups;
  std::vector<Resource> sought;  // classes of the objects that the steps act on
  // The nodes that something of a class is, whether it is a class of parts or of capabilities.
  std::unordered_map<rdf::TermId, std::vector<std::size_t>> nodes_above;
};

// `view` holds the catalogue and the recipe; it may hold robots. What the documents that describe
// `robot_iri` (empty for none) require does not count. Throws kNotFound when `task_iri` is no task.
Needs FindNeeds(prolog::EnginePool& engines, const rdf::View& view, const std::string& task_iri,
                const std::string& robot_iri = "");

// What every capability that is known rests on, as if one task needed them all.
Needs FindCapabilityNeeds(prolog::EnginePool& engines, const rdf::View& view,
                          const std::string& robot_iri);

}  // namespace lares::recipes
