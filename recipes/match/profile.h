// What of a robot's description matching looks at.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"
#include "recipes/resource.h"

namespace lares::recipes {

// A value: it keeps no view. TermIds are those of the dictionary it was described with.
struct RobotProfile {
  // Of several values that the description gives, the span of them.
  struct Quantity {
    rdf::TermId property{};
    double least = 0;
    double most = 0;
  };
  struct Part {
    Resource what;
    std::vector<Quantity> quantities;
  };
  struct Typed {
    rdf::TermId type{};
    std::vector<std::size_t> parts;  // of the class `type`, by IRI
  };
  Resource robot;
  std::vector<Part> parts;     // with the parts of parts, by IRI
  Part self;                   // the robot as a whole
  std::vector<Typed> by_type;  // each class that some part is of, also those above its own
  // A capability that the description claims.
  struct Claim {
    Resource what;
    rdf::TermId term{};
    std::vector<rdf::TermId> above;  // itself and all that it is a special case of, sorted
  };
  std::vector<Claim> claims;
};

// `view` holds the catalogue and the robot's description. Throws kNotFound when `robot_iri` is no
// robot.
RobotProfile DescribeRobot(prolog::EnginePool& engines, const rdf::View& view,
                           const std::string& robot_iri);

}  // namespace lares::recipes
