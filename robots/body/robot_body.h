// How large a robot is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::robots {

// What a description states of a robot's size, in metres.
struct RobotBody {
  std::string label;
  std::optional<double> footprint_radius_m;  // around the centre of the base
  std::optional<double> footprint_length_m;
  std::optional<double> footprint_width_m;
  std::optional<double> body_height_m;
  std::optional<double> min_footprint_radius_m;  // the true ones may be larger
  std::optional<double> min_body_height_m;
  std::vector<std::string> notes;  // one sentence for each value that was not taken as it stands
};

// From lares:footprintRadius_m, footprintLength_m, footprintWidth_m, bodyHeight_m,
// minFootprintRadius_m and minBodyHeight_m of the robot itself, as documents assert them; nothing
// is inferred. What is no length of a robot (not a number, not more than 0, more than 20 m) is
// passed over and noted; of several values the largest counts.
RobotBody ReadRobotBody(const rdf::View& view, const std::string& robot_iri);

// What of the world is in this body's way: where the description is silent, what is assumed.
struct Clearance {
  double radius_m = 0;  // of the circle that the body turns in; 0 when nothing is known of it
  double low_m = 0;     // above the floor: the robot rolls over what is lower
  double high_m = 0;    // above the floor: the body ends
  std::vector<std::string> reasons;  // a sentence for each choice
};

inline constexpr double kAssumedStep_m = 0.05;   // what a robot rolls over; no term states it
inline constexpr double kAssumedHeight_m = 1.8;  // of a body whose height is not known

// The radius is the stated one or half the footprint's diagonal, whichever is larger (the base's
// centre is taken for the footprint's). Where a robot only states what its size is at least, that
// is the radius, said to be too small perhaps, and the height is kAssumedHeight_m if that is more.
Clearance ClearanceOf(const RobotBody& body);

}  // namespace lares::robots
