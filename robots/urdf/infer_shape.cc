#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.h"
#include "robots/urdf/infer.h"

namespace lares::urdf {
namespace {

constexpr double kNearFloor_m = 0.35;  // what begins below counts as standing on the floor
constexpr double kNothing_m = 0.005;   // shapes smaller than this stand for nothing
constexpr int kCircleCorners = 24;

// Corners of a polygon around the unit circle: its sides touch the circle, four of them on the
// axes.
std::vector<Eigen::Vector2d> AroundCircle() {
  std::vector<Eigen::Vector2d> corners;
  constexpr double kHalfSide = M_PI / kCircleCorners;
  for (int i = 0; i < kCircleCorners; ++i) {
    const double angle = (2 * i + 1) * kHalfSide;
    corners.emplace_back(std::cos(angle) / std::cos(kHalfSide),
                         std::sin(angle) / std::cos(kHalfSide));
  }
  return corners;
}

// Points in the base frame: their hull seen from above holds the shape, and none of it is above the
// highest or below the lowest.
std::vector<Eigen::Vector3d> CornersOf(const Shape& shape, const RigidTransform& base_from_shape) {
  std::vector<Eigen::Vector3d> corners;
  if (shape.kind == Shape::Kind::kBox) {
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d corner((i & 1 ? 0.5 : -0.5) * shape.size_m.x(),
                                   (i & 2 ? 0.5 : -0.5) * shape.size_m.y(),
                                   (i & 4 ? 0.5 : -0.5) * shape.size_m.z());
      corners.push_back(base_from_shape * corner);
    }
  } else if (shape.kind == Shape::Kind::kCylinder) {
    for (const Eigen::Vector2d& around : AroundCircle()) {
      for (const double end : {-0.5, 0.5}) {
        const Eigen::Vector3d corner(shape.radius_m * around.x(), shape.radius_m * around.y(),
                                     end * shape.length_m);
        corners.push_back(base_from_shape * corner);
      }
    }
  } else if (shape.kind == Shape::Kind::kSphere) {
    // However the shape is turned, a sphere is not.
    const Eigen::Vector3d& centre_m = base_from_shape.translation_m;
    for (const Eigen::Vector2d& around : AroundCircle()) {
      corners.push_back(centre_m + shape.radius_m * Eigen::Vector3d(around.x(), around.y(), 0));
    }
    corners.push_back(centre_m + shape.radius_m * Eigen::Vector3d::UnitZ());
    corners.push_back(centre_m - shape.radius_m * Eigen::Vector3d::UnitZ());
  }
  return corners;
}

bool IsNothing(const Shape& shape) {
  if (shape.kind == Shape::Kind::kMesh) return true;
  if (shape.kind == Shape::Kind::kBox) return shape.size_m.maxCoeff() < kNothing_m;
  return std::max(shape.radius_m, shape.length_m) < kNothing_m;
}

struct PointsOf {
  std::vector<Eigen::Vector3d> points;  // in the base frame
  bool has_mesh = false;
};

PointsOf ShapesOf(const Link& link, const RigidTransform& base_from_link) {
  PointsOf found;
  const auto add = [&](const std::vector<Shape>& shapes) {
    for (const Shape& shape : shapes) {
      found.has_mesh = found.has_mesh || shape.kind == Shape::Kind::kMesh;
      if (IsNothing(shape)) continue;
      for (const Eigen::Vector3d& corner :
           CornersOf(shape, base_from_link * shape.link_from_shape)) {
        found.points.push_back(corner);
      }
    }
  };
  add(link.collision);
  if (link.collision.empty()) add(link.visual);
  return found;
}

double Cross(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

// Monotone chain (Andrew 1979): counter-clockwise, no point on an edge.
std::vector<Eigen::Vector2d> HullOf(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return {};
  std::vector<Eigen::Vector2d> hull;
  const auto add = [&](const Eigen::Vector2d& point, std::size_t least) {
    while (hull.size() >= least && Cross(hull[hull.size() - 2], hull.back(), point) <= 1e-12) {
      hull.pop_back();
    }
    hull.push_back(point);
  };
  for (const auto& point : points) add(point, 2);
  const std::size_t lower = hull.size() + 1;
  for (auto at = points.rbegin() + 1; at != points.rend(); ++at) add(*at, lower);
  hull.pop_back();
  return hull.size() < 3 ? std::vector<Eigen::Vector2d>{} : hull;
}

RigidTransform BaseFromLink(const Kinematics& kinematics, const Body& body, int link) {
  return Inverse(kinematics.root_from_link[At(body.base_frame)]) *
         kinematics.root_from_link[At(link)];
}

// Links that no arm moves.
std::vector<int> WithoutArms(const Model& model, const Kinematics& kinematics, const Body& body) {
  std::set<int> arm_links;
  for (const Arm& arm : body.arms) {
    for (const int link : LinksBelow(model, arm.base_link)) arm_links.insert(link);
  }
  std::vector<int> links;
  for (const int link : kinematics.order) {
    if (!arm_links.contains(link)) links.push_back(link);
  }
  return links;
}

}  // namespace

double FloorInRoot(const Model& model, const Kinematics& kinematics, const Base& base,
                   int base_frame) {
  if (model.links[At(base_frame)].name.find("footprint") != std::string::npos) {
    return kinematics.root_from_link[At(base_frame)].translation_m.z();
  }
  double lowest = 1e9;
  for (const int wheel : base.wheels) {
    const RigidTransform& root_from_wheel = kinematics.root_from_link[At(wheel)];
    for (const auto& point : ShapesOf(model.links[At(wheel)], root_from_wheel).points) {
      lowest = std::min(lowest, point.z());
    }
  }
  return lowest < 1e8 ? lowest : 0;
}

std::optional<Footprint> InferFootprint(const Model& model, const Kinematics& kinematics,
                                        const Body& body) {
  Footprint footprint;
  std::vector<Eigen::Vector2d> points;
  std::set<std::string> meshes, used;
  for (const int link : WithoutArms(model, kinematics, body)) {
    const bool is_wheel =
        std::find(body.base.wheels.begin(), body.base.wheels.end(), link) != body.base.wheels.end();
    const bool is_base = kinematics.body[At(link)] == kinematics.body[At(body.base.link)];
    if (!is_wheel && !is_base) continue;
    const PointsOf shapes = ShapesOf(model.links[At(link)], BaseFromLink(kinematics, body, link));
    if (shapes.has_mesh) meshes.insert(model.links[At(link)].name);
    double lowest = 1e9;
    for (const auto& point : shapes.points) lowest = std::min(lowest, point.z());
    if (lowest > body.floor_m + kNearFloor_m) continue;
    used.insert(model.links[At(link)].name);
    for (const auto& point : shapes.points) points.push_back(point.head<2>());
  }
  footprint.polygon_m = HullOf(std::move(points));
  if (footprint.polygon_m.empty()) return std::nullopt;
  Eigen::Vector2d least = footprint.polygon_m.front(), most = least;
  for (const Eigen::Vector2d& corner : footprint.polygon_m) {
    least = least.cwiseMin(corner);
    most = most.cwiseMax(corner);
    footprint.radius_m = std::max(footprint.radius_m, corner.norm());
  }
  footprint.length_m = most.x() - least.x();
  footprint.width_m = most.y() - least.y();
  std::vector<std::string> names(used.begin(), used.end());
  if (names.size() > 6) names = {names.begin(), names.begin() + 6}, names.push_back("…");
  footprint.reason = "hull of the shapes near the floor of " + Join(names, ", ");
  footprint.is_lower_bound = !meshes.empty();
  if (footprint.is_lower_bound) {
    footprint.reason += "; meshes are not opened, so that of " +
                        Join({meshes.begin(), meshes.end()}, ", ") +
                        " nothing is in it: the true footprint may be larger";
  }
  return footprint;
}

std::optional<BodyHeight> InferHeight(const Model& model, const Kinematics& kinematics,
                                      const Body& body) {
  double highest = -1e9;
  bool has_mesh = false;
  std::string of;
  for (const int link : WithoutArms(model, kinematics, body)) {
    const RigidTransform base_from_link = BaseFromLink(kinematics, body, link);
    PointsOf shapes = ShapesOf(model.links[At(link)], base_from_link);
    has_mesh = has_mesh || shapes.has_mesh;
    shapes.points.push_back(base_from_link.translation_m);
    for (const auto& point : shapes.points) {
      if (point.z() <= highest) continue;
      highest = point.z();
      of = model.links[At(link)].name;
    }
  }
  BodyHeight height;
  height.height_m = highest - body.floor_m;
  if (!(height.height_m > 0.01)) return std::nullopt;
  height.is_lower_bound = has_mesh || !body.arms.empty() || !body.torsos.empty();
  height.reason = "top of '" + of + "' with all joints at zero";
  if (has_mesh) height.reason += "; meshes are not opened, so it is at least this";
  if (!body.arms.empty()) height.reason += "; arms may reach higher";
  if (!body.torsos.empty()) height.reason += "; a torso may be raised";
  return height;
}

}  // namespace lares::urdf
