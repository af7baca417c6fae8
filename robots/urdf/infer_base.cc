#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/text.h"
#include "robots/urdf/infer.h"
#include "robots/urdf/quote.h"

namespace lares::urdf {
namespace {

constexpr double kVertical = 0.8;    // cosine with the vertical of a steering axis at least
constexpr double kHorizontal = 0.3;  // of a wheel's axis at most
constexpr double kSame = 0.9;        // cosine of axes that count as one direction
constexpr double kHalfTurn = 3.1;    // radians; what a steered wheel turns at least to go anywhere

bool Contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

// `part` is in `text`, and no "non" stands before it ("nonholonomic", "non_holonomic").
bool Says(std::string_view text, std::string_view part) {
  for (std::size_t at = text.find(part); at != std::string_view::npos;
       at = text.find(part, at + 1)) {
    std::string_view before = text.substr(0, at);
    if (before.ends_with('_') || before.ends_with('-')) before.remove_suffix(1);
    if (!before.ends_with("non")) return true;
  }
  return false;
}

// A plugin that moves the base says how it moves.
std::optional<Base> FromPlugins(const Model& model) {
  struct Known {
    const char* part;
    BaseKind kind;
    const char* what;
  };
  static constexpr Known kKnown[] = {
      {"planar_move", BaseKind::kHolonomic, "moves it in every direction"},
      {"mecanum", BaseKind::kHolonomic, "drives mecanum wheels"},
      {"omni", BaseKind::kHolonomic, "drives omnidirectional wheels"},
      {"holonomic", BaseKind::kHolonomic, "moves it in every direction"},
      {"diff_drive", BaseKind::kDifferential, "drives two sides at different speeds"},
      {"diffdrive", BaseKind::kDifferential, "drives two sides at different speeds"},
      {"differential", BaseKind::kDifferential, "drives two sides at different speeds"},
      {"skid_steer", BaseKind::kDifferential, "drives two sides at different speeds"},
      {"ackermann", BaseKind::kWheeled, "steers as a car does"},
      {"tracked", BaseKind::kTracked, "drives tracks"}};
  for (const Plugin& plugin : model.plugins) {
    const std::string text = ToLower(plugin.file + " " + plugin.name);
    for (const Known& known : kKnown) {
      if (!Says(text, known.part)) continue;
      Base base;
      base.kind = known.kind;
      base.reason = "the simulator's plugin " + plugin.file + " (line " +
                    std::to_string(plugin.line) + ") " + known.what;
      return base;
    }
  }
  return std::nullopt;
}

// A wheel: turns without limits about a level axis, and is round or is named so.
struct Wheel {
  int joint = -1;
  int link = -1;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();  // in the root
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  bool is_named = false;
  int steering = -1;  // joint above it that turns it about the vertical
  bool is_omni = false;
};

bool IsRound(const Link& link) {
  const auto round = [](const Shape& shape) {
    return shape.kind == Shape::Kind::kCylinder || shape.kind == Shape::Kind::kSphere;
  };
  return std::any_of(link.collision.begin(), link.collision.end(), round) ||
         std::any_of(link.visual.begin(), link.visual.end(), round);
}

bool IsNamed(const Model& model, const Joint& joint, const char* word) {
  return HasWord(joint.name, {word}) || HasWord(model.links[At(joint.child)].name, {word}) ||
         Contains(ToLower(joint.name), word) ||
         Contains(ToLower(model.links[At(joint.child)].name), word);
}

// The joint above, when it turns about the vertical and belongs to the wheel.
int SteeringAbove(const Model& model, const Kinematics& kinematics, const Joint& wheel) {
  for (int above = model.links[At(wheel.parent)].parent_joint; above >= 0;) {
    const Joint& joint = model.joints[At(above)];
    if (Moves(joint)) {
      const bool upright = std::abs(AxisInRoot(model, kinematics, above).z()) > kVertical;
      const bool belongs = joint.kind == Joint::Kind::kContinuous ||
                           kinematics.moving_below[At(joint.child)] == 1 ||
                           IsNamed(model, joint, "caster") || IsNamed(model, joint, "steer") ||
                           IsNamed(model, joint, "swivel");
      return Turns(joint) && upright && belongs ? above : -1;
    }
    above = model.links[At(joint.parent)].parent_joint;
  }
  return -1;
}

std::vector<Wheel> FindWheels(const Model& model, const Kinematics& kinematics) {
  std::vector<Wheel> wheels;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    Wheel wheel;
    wheel.joint = static_cast<int>(i);
    wheel.link = joint.child;
    wheel.axis = AxisInRoot(model, kinematics, wheel.joint);
    wheel.centre_m = kinematics.root_from_link[At(joint.child)].translation_m;
    wheel.is_named = IsNamed(model, joint, "wheel");
    if (!Turns(joint) || std::abs(wheel.axis.z()) > kHorizontal) continue;
    if (!wheel.is_named &&
        !(joint.kind == Joint::Kind::kContinuous && IsRound(model.links[At(joint.child)]))) {
      continue;
    }
    wheel.steering = SteeringAbove(model, kinematics, joint);
    // Rollers turn on the rim of the wheel that carries them.
    for (const int child : model.links[At(joint.child)].child_joints) {
      wheel.is_omni = wheel.is_omni || Turns(model.joints[At(child)]);
    }
    wheels.push_back(wheel);
  }
  const bool any_named =
      std::any_of(wheels.begin(), wheels.end(), [](const Wheel& wheel) { return wheel.is_named; });
  const double lowest = std::accumulate(
      wheels.begin(), wheels.end(), 1e9,
      [](double low, const Wheel& wheel) { return std::min(low, wheel.centre_m.z()); });
  std::erase_if(wheels, [&](const Wheel& wheel) {
    return any_named ? !wheel.is_named : wheel.centre_m.z() > lowest + 0.1;
  });
  return wheels;
}

std::vector<std::string> NamesOf(const Model& model, const std::vector<Wheel>& wheels) {
  std::vector<std::string> names;
  for (const Wheel& wheel : wheels) {
    if (names.size() == 4) {
      names.push_back("…");
      break;
    }
    names.push_back(Quote(model.links[At(wheel.link)].name));
  }
  return names;
}

// The directions that the axes of wheels point to, opposite ones being the same.
std::size_t DirectionsOf(const std::vector<Wheel>& wheels) {
  std::vector<Eigen::Vector3d> directions;
  for (const Wheel& wheel : wheels) {
    const bool is_known = std::any_of(
        directions.begin(), directions.end(),
        [&](const Eigen::Vector3d& known) { return std::abs(known.dot(wheel.axis)) > kSame; });
    if (!is_known) directions.push_back(wheel.axis);
  }
  return directions.size();
}

bool StandsOnBothSides(const std::vector<Wheel>& wheels) {
  double least = 0, most = 0;
  for (const Wheel& wheel : wheels) {
    const double side = wheel.centre_m.dot(wheels.front().axis);
    least = &wheel == &wheels.front() ? side : std::min(least, side);
    most = &wheel == &wheels.front() ? side : std::max(most, side);
  }
  return most - least > 0.02;
}

int CarrierOf(const Model& model, const Wheel& wheel) {
  const int joint = wheel.steering >= 0 ? wheel.steering : wheel.joint;
  return model.joints[At(joint)].parent;
}

// The wheels by what they do for the motion.
struct Wheels {
  std::vector<Wheel> fixed;    // roll in one direction of the base
  std::vector<Wheel> steered;  // are turned about the vertical
  std::vector<Wheel> passive;  // castors: turn as the base goes
};

// Castors turn without limits and nothing drives them. What turns between limits is steered, for it
// could not follow; where transmissions are written, those that drive it decide.
Wheels SortWheels(const Model& model, const std::vector<Wheel>& wheels) {
  Wheels sorted;
  for (const Wheel& wheel : wheels) {
    if (wheel.steering < 0) {
      const bool caster = IsNamed(model, model.joints[At(wheel.joint)], "caster");
      (caster ? sorted.passive : sorted.fixed).push_back(wheel);
      continue;
    }
    const Joint& steering = model.joints[At(wheel.steering)];
    const bool steered = model.says_what_is_driven ? steering.actuated
                                                   : steering.kind == Joint::Kind::kRevolute &&
                                                         !IsNamed(model, steering, "caster");
    (steered ? sorted.steered : sorted.passive).push_back(wheel);
  }
  return sorted;
}

// Whether a wheel rolls sideways as well: by rollers on its rim, or by its name.
bool IsOmni(const Model& model, const Wheel& wheel) {
  return wheel.is_omni || IsNamed(model, model.joints[At(wheel.joint)], "mecanum") ||
         IsNamed(model, model.joints[At(wheel.joint)], "omni");
}

// Whether the wheel can be turned into every direction; rolling backwards counts.
bool TurnsAllAround(const Model& model, const Wheel& wheel) {
  const Joint& steering = model.joints[At(wheel.steering)];
  return !steering.lower || *steering.upper - *steering.lower > kHalfTurn;
}

// Bases with steered wheels: every one, or those that are not roll sideways as well; else a car.
std::optional<Base> FromSteering(const Model& model, const Wheels& wheels) {
  if (wheels.steered.empty()) return std::nullopt;
  const auto omni = [&](const Wheel& wheel) { return IsOmni(model, wheel); };
  const auto all_around = [&](const Wheel& wheel) { return TurnsAllAround(model, wheel); };
  const std::string steered = Join(NamesOf(model, wheels.steered), ", ");
  Base base;
  if (!std::all_of(wheels.fixed.begin(), wheels.fixed.end(), omni)) {
    base.kind = BaseKind::kWheeled;
    base.reason = steered + " are steered and " + Join(NamesOf(model, wheels.fixed), ", ") +
                  " are not, as on a car: it cannot move sideways";
    return base;
  }
  if (wheels.steered.size() < 2) return std::nullopt;
  if (!std::all_of(wheels.steered.begin(), wheels.steered.end(), all_around)) {
    base.kind = BaseKind::kWheeled;
    base.reason = "the joints that steer " + steered + " turn less than half a turn";
    return base;
  }
  base.kind = BaseKind::kHolonomic;
  base.reason = std::to_string(wheels.steered.size()) + " wheels, " + steered +
                ", are turned about the vertical by driven joints of their own";
  return base;
}

std::optional<Base> FromWheels(const Model& model, const std::vector<Wheel>& all) {
  const Wheels wheels = SortWheels(model, all);
  if (auto base = FromSteering(model, wheels)) return base;
  const std::vector<Wheel>& fixed = wheels.fixed;
  if (fixed.size() < 2) return std::nullopt;
  Base base;
  const std::string passive = Join(NamesOf(model, wheels.passive), ", ");
  const std::string names = Join(NamesOf(model, fixed), ", ");
  const bool rollers =
      std::all_of(fixed.begin(), fixed.end(), [](const Wheel& wheel) { return wheel.is_omni; });
  const bool omni = std::all_of(fixed.begin(), fixed.end(),
                                [&](const Wheel& wheel) { return IsOmni(model, wheel); });
  const std::size_t directions = DirectionsOf(fixed);
  if (fixed.size() >= 3 && (directions >= 2 || omni)) {
    base.kind = BaseKind::kHolonomic;
    base.reason = std::to_string(fixed.size()) + " wheels, " + names +
                  (directions >= 2 ? ", whose axes point in " + std::to_string(directions) +
                                         " directions of the floor"
                   : rollers ? ", carry rollers on their rims"
                             : ", are named as omnidirectional");
    return base;
  }
  if (directions == 1 && StandsOnBothSides(fixed)) {
    base.kind = BaseKind::kDifferential;
    base.reason = std::to_string(fixed.size()) + " wheels, " + names +
                  ", turn about parallel axes on both sides" +
                  (passive.empty() ? "" : "; " + passive + " only follow");
    return base;
  }
  return std::nullopt;
}

std::optional<Base> FromTracks(const Model& model) {
  std::vector<std::string> names;
  for (const Link& link : model.links) {
    if (HasWord(link.name, {"track", "tracks", "crawler"})) names.push_back(Quote(link.name));
  }
  if (names.size() < 2) return std::nullopt;
  Base base;
  base.kind = BaseKind::kTracked;
  base.reason = "the links " + Join(names, ", ") + " are named as tracks";
  return base;
}

// A base whose motion in the plane is written as joints at the root: one planar joint, or two that
// slide across each other and one that turns. Slides alone are a gantry.
std::optional<Base> FromPlanarJoints(const Model& model, const Kinematics& kinematics) {
  std::vector<Eigen::Vector3d> slides;
  bool turns = false;
  for (int link = model.root; model.links[At(link)].child_joints.size() == 1;) {
    const int above = model.links[At(link)].child_joints.front();
    const Joint& joint = model.joints[At(above)];
    Base base;
    base.kind = BaseKind::kHolonomic;
    base.link = joint.child;
    link = joint.child;
    if (!Moves(joint)) continue;
    if (joint.kind == Joint::Kind::kPlanar) {
      base.reason = "the planar joint " + Quote(joint.name) + " carries all of it";
      return base;
    }
    const Eigen::Vector3d axis = AxisInRoot(model, kinematics, above);
    const bool slides_level =
        joint.kind == Joint::Kind::kPrismatic && std::abs(axis.z()) < kHorizontal;
    const bool turns_upright = Turns(joint) && std::abs(axis.z()) > kVertical;
    if (!slides_level && !turns_upright) return std::nullopt;
    turns = turns || turns_upright;
    const bool is_known = std::any_of(slides.begin(), slides.end(), [&](const auto& known) {
      return std::abs(known.dot(axis)) > kSame;
    });
    if (slides_level && !is_known) slides.push_back(axis);
    if (slides.size() < 2 || !turns) continue;
    base.reason = "two sliding joints and a turning one at the root, the last " +
                  Quote(joint.name) + ", move all of it in the plane";
    return base;
  }
  return std::nullopt;
}

Base WithoutWheels(const Model& model) {
  Base base;
  base.link = model.root;
  const std::string root = model.links[At(model.root)].name;
  const bool moves = std::any_of(model.joints.begin(), model.joints.end(), Moves);
  if (root == "world" || root == "map") {
    base.kind = BaseKind::kFixed;
    base.reason = "the root link is " + Quote(root) + ", and nothing below it drives";
  } else if (moves && (HasWord(root, {"world", "table", "mount", "stand"}) ||
                       HasWord(model.name, {"arm", "manipulator"}))) {
    base.kind = BaseKind::kFixed;
    base.reason = "there are no wheels or tracks, and " + Quote(root) + " is named as a mounting";
  } else {
    base.reason = "no wheels, tracks, planar joint or driving plugin were found";
  }
  return base;
}

}  // namespace

std::string_view ToString(BaseKind kind) {
  constexpr std::string_view kNames[] = {"unknown",   "fixed",   "differential",
                                         "holonomic", "tracked", "wheeled"};
  return kNames[static_cast<std::size_t>(kind)];
}

Base InferBase(const Model& model, const Kinematics& kinematics) {
  const std::vector<Wheel> wheels = FindWheels(model, kinematics);
  std::optional<Base> base = FromPlugins(model);
  if (!base) base = FromPlanarJoints(model, kinematics);
  if (!base) base = FromWheels(model, wheels);
  if (!base) base = FromTracks(model);
  if (!base) base = WithoutWheels(model);
  for (const Wheel& wheel : wheels) base->wheels.push_back(wheel.link);
  if (base->kind == BaseKind::kUnknown && !wheels.empty()) {
    base->reason = "the wheels " + Join(NamesOf(model, wheels), ", ") +
                   " stand in no arrangement that tells how they drive";
  }
  if (!wheels.empty()) {
    base->link = CarrierOf(model, wheels.front());
  } else if (base->link < 0) {
    const int base_link = model.FindLink("base_link");
    base->link = base_link >= 0 ? base_link : model.root;
  }
  return *base;
}

}  // namespace lares::urdf
