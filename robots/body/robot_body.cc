#include "robots/body/robot_body.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/number.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::robots {
namespace {

constexpr double kMaxLength_m = 20;

std::string Metres(double length_m) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g m", length_m);
  return text;
}

rdf::TermId Ours(const rdf::View& view, const std::string& name) {
  return view.dictionary().InternIri(std::string(rdf::kLares) + name);
}

std::optional<double> ReadLength(const rdf::View& view, rdf::TermId robot, const std::string& name,
                                 RobotBody& body) {
  std::vector<double> lengths_m;
  view.ForEach(
      {robot, Ours(view, name), {}},
      [&](const rdf::Triple& triple) {
        const std::string text(view.dictionary().Get(triple.object).value);
        const std::optional<double> length_m = ToNumber(text);
        if (length_m && *length_m > 0 && *length_m <= kMaxLength_m) {
          lengths_m.push_back(*length_m);
        } else {
          body.notes.push_back(name + " of " + body.label + " is '" + text.substr(0, 40) +
                               "', which is no length of a robot in metres: passed over");
        }
        return true;
      },
      rdf::Origin::kAsserted);
  if (lengths_m.empty()) return std::nullopt;
  const double largest_m = *std::max_element(lengths_m.begin(), lengths_m.end());
  if (lengths_m.size() > 1) {
    body.notes.push_back(name + " of " + body.label + " is stated " +
                         std::to_string(lengths_m.size()) + " times: the largest, " +
                         Metres(largest_m) + ", is taken");
  }
  return largest_m;
}

void ChooseRadius(const RobotBody& body, Clearance& clearance) {
  std::optional<double> half_diagonal_m;
  if (body.footprint_length_m && body.footprint_width_m) {
    half_diagonal_m = std::hypot(*body.footprint_length_m, *body.footprint_width_m) / 2;
  }
  const double stated_m = body.footprint_radius_m.value_or(0);
  const double by_sides_m = half_diagonal_m.value_or(0);
  const double least_m = body.min_footprint_radius_m.value_or(0);
  clearance.radius_m = std::max({stated_m, by_sides_m, least_m});
  if (clearance.radius_m == 0) {
    clearance.reasons.push_back("the footprint of " + body.label +
                                " is not stated: obstacles are not inflated for it");
  } else if (least_m > std::max(stated_m, by_sides_m)) {
    clearance.reasons.push_back("obstacles are inflated by " + Metres(least_m) +
                                ", which the footprint radius of " + body.label +
                                " is at least: it may be larger");
  } else if (stated_m >= by_sides_m) {
    clearance.reasons.push_back("obstacles are inflated by " + Metres(stated_m) +
                                ", the footprint radius that " + body.label + " states");
  } else {
    clearance.reasons.push_back(
        "obstacles are inflated by " + Metres(by_sides_m) +
        ", half the diagonal of the footprint " + Metres(*body.footprint_length_m) + " × " +
        Metres(*body.footprint_width_m) + " that " + body.label + " states" +
        (stated_m > 0 ? ", for it does not fit into the stated radius of " + Metres(stated_m)
                      : ""));
  }
}

void ChooseHeight(const RobotBody& body, Clearance& clearance) {
  const double least_m = body.min_body_height_m.value_or(0);
  if (body.body_height_m) {
    clearance.high_m = std::max(*body.body_height_m, least_m);
    return;
  }
  clearance.high_m = std::max(kAssumedHeight_m, least_m);
  if (body.min_body_height_m) {
    clearance.reasons.push_back("the height of " + body.label + " is at least " + Metres(least_m) +
                                " and may be larger: " + Metres(clearance.high_m) + " are assumed");
  } else {
    clearance.reasons.push_back("the height of " + body.label +
                                " is not stated: " + Metres(kAssumedHeight_m) + " are assumed");
  }
}

}  // namespace

RobotBody ReadRobotBody(const rdf::View& view, const std::string& robot_iri) {
  const rdf::TermId robot = view.dictionary().InternIri(robot_iri);
  RobotBody body;
  body.label = view.Label(robot);
  body.footprint_radius_m = ReadLength(view, robot, "footprintRadius_m", body);
  body.footprint_length_m = ReadLength(view, robot, "footprintLength_m", body);
  body.footprint_width_m = ReadLength(view, robot, "footprintWidth_m", body);
  body.body_height_m = ReadLength(view, robot, "bodyHeight_m", body);
  body.min_footprint_radius_m = ReadLength(view, robot, "minFootprintRadius_m", body);
  body.min_body_height_m = ReadLength(view, robot, "minBodyHeight_m", body);
  return body;
}

Clearance ClearanceOf(const RobotBody& body) {
  Clearance clearance;
  clearance.reasons = body.notes;
  ChooseRadius(body, clearance);
  clearance.low_m = kAssumedStep_m;
  clearance.reasons.push_back(body.label + " is assumed to roll over what is lower than " +
                              Metres(kAssumedStep_m));
  ChooseHeight(body, clearance);
  // Nothing is as low as the step: a body that is has one layer of the world in its way.
  clearance.high_m = std::max(clearance.high_m, clearance.low_m + 0.01);
  return clearance;
}

}  // namespace lares::robots
