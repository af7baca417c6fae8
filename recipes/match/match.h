// Matching: what a task needs against what a robot has, with the reasons and the way out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"
#include "recipes/match/needs.h"
#include "recipes/match/profile.h"
#include "recipes/resource.h"

namespace lares::recipes {

enum class Availability {
  kAvailable,     // every dependency is there, or asserted with nothing against it
  kOnMakersWord,  // asserted by the robot's description although a dependency is absent, or a
                  // number that the description does not give
  kDownloadable,  // not the robot's, but on offer: it counts as available
  kDerivable,     // missing now, and available once the other missing things are there
  kInsufficient,  // there, but a number that is required of it is not kept
  kMissing,
};
std::string_view ToString(Availability availability);  // "available", "on-makers-word", …

// Something that can be fetched for any robot: a map, a recognition model.
struct Offer {
  std::string class_iri;  // the class of components that it is
  std::string for_what;   // an object class or an environment, for people
  std::string document;   // "object-model:bottle", "environment:flat/3"
  std::string file;       // the layer's or the file's name
  std::string link;       // path on the server that has it
  std::string sha256;     // of the file; empty where there are several
  std::uint64_t size_bytes = 0;
};

// One bound, and what the robot's best part makes of it. All numbers in `unit`.
struct Measure {
  enum class Verdict { kMet, kUnknown, kInsufficient };
  Resource quantity;
  std::string unit;
  std::optional<double> at_least;
  std::optional<double> at_most;
  std::optional<double> actual;  // nothing when the description does not give it
  Verdict verdict = Verdict::kUnknown;
  double short_by = 0;                     // by how much the end that is not kept is missed
  std::optional<double> short_by_percent;  // of that end; nothing when it is 0
  Resource stated_by;                      // the class that requires it
};

// Why something is or is not there: a tree, one node a capability or a component.
struct Finding {
  enum class Kind { kCapability, kComponent };
  Kind kind = Kind::kCapability;
  Resource what;
  Availability availability = Availability::kMissing;
  bool asserted = false;              // capabilities: the robot's description claims it
  std::vector<Resource> provided_by;  // components: the robot's parts that are it, with `measures`
                                      // the best of them; capabilities: the asserted (sub)class
  std::vector<Finding> dependencies;  // what it needs, each with its own reasons
  std::vector<Measure> measures;      // what is required of the part in numbers
  std::vector<Offer> downloads;       // kDownloadable
  std::string explanation;            // one plain sentence
};

// Numbers that the steps themselves require of a part.
struct StepRequirement {
  std::vector<Resource> steps;
  Finding finding;
};

struct RepairItem {
  Resource what;                // a component, or a bare capability
  std::vector<Measure> bounds;  // what the added part must keep
  double cost = 0;              // relative effort (ontology/requirements.ttl)
  std::string text;             // "a camera with a max range of at least 3 m"
};
struct Repair {
  std::vector<RepairItem> add;  // by label
  double cost = 0;
};

struct Download {
  Resource what;  // what it is fetched for
  Offer offer;
};

struct MatchReport {
  Resource task;
  Resource robot;
  bool feasible = false;
  std::vector<Need> needs;
  std::vector<Finding> capabilities;  // one per distinct capability needed, by label
  std::vector<StepRequirement> requirements;
  std::vector<Download> downloads;        // counted as available
  std::vector<Resource> smallest_repair;  // of the first repair; empty when feasible
  std::vector<Repair> repairs;            // cheapest first, at most three; empty when feasible
  bool repair_is_smallest = true;         // false: the search for a cheaper one was given up
  std::vector<std::string> warnings;      // "on the maker's word", unknown terms, …
};

struct MatchOptions {
  bool strict = false;  // a capability on the maker's word counts as missing
  std::vector<Offer> offers;
};

// `view` holds the catalogue, the recipe and the robot. Throws kNotFound when `task` is no task of
// the view or `robot` no robot.
MatchReport Match(prolog::EnginePool& engines, const rdf::View& view, const std::string& task_iri,
                  const std::string& robot_iri, const MatchOptions& options = {});

// The same from what was found out before; needs no view, only their dictionary to be one.
MatchReport Match(const Needs& needs, const RobotProfile& robot, const MatchOptions& options = {});

}  // namespace lares::recipes
