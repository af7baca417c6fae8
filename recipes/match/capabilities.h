// Everything that a robot can do, and what keeps it from the rest.
#pragma once

#include <string>
#include <vector>

#include "recipes/match/match.h"

namespace lares::recipes {

struct CapabilityReport {
  Resource robot;
  std::vector<Finding> capabilities;  // every capability that is known, by label
};

// `view` holds the catalogue and the robot. Throws kNotFound when `robot` is no robot of the view.
CapabilityReport Capabilities(prolog::EnginePool& engines, const rdf::View& view,
                              const std::string& robot_iri, const MatchOptions& options = {});

}  // namespace lares::recipes
