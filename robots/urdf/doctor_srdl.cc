#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "base/number.h"
#include "base/text.h"
#include "robots/urdf/doctor.h"
#include "robots/urdf/infer.h"
#include "robots/urdf/quote.h"

namespace lares::urdf {
namespace {

using Severity = Finding::Severity;

constexpr std::string_view kLares = "https://w3id.org/lares#";
constexpr std::string_view kType = "http://www.w3.org/1999/02/22-rdf-syntax-ns#type";

// What the SRDL says of one link or joint, by its urdfName.
struct Said {
  bool is_joint = false;
  std::string kind;  // of a joint: "FixedUrdfJoint"
  std::optional<RigidTransform> parent_from_child;
};

class SrdlReader {
 public:
  explicit SrdlReader(const SrdlToCompare& srdl) : srdl_(srdl) {
    for (const rdf::Triple& triple : srdl.graph.triples) {
      values_[triple.subject].emplace_back(triple.predicate, triple.object);
    }
  }

  std::map<std::string, Said> Read(bool joints) const {
    std::map<std::string, Said> all;
    for (const auto& [subject, properties] : values_) {
      const auto name = Value(subject, "urdfName");
      if (!name) continue;
      Said said;
      for (const auto& [predicate, object] : properties) {
        if (srdl_.dictionary.Get(predicate).value != kType) continue;
        const std::string local(LocalName(srdl_.dictionary.Get(object).value));
        if (local.ends_with("UrdfJoint")) said.is_joint = true, said.kind = local;
      }
      if (said.is_joint != joints) continue;
      if (const auto pose = Object(subject, "orientation")) said.parent_from_child = Pose(*pose);
      all.emplace(std::string(srdl_.dictionary.Get(*name).value), said);
    }
    return all;
  }

 private:
  using Properties = std::vector<std::pair<rdf::TermId, rdf::TermId>>;

  std::optional<rdf::TermId> Object(rdf::TermId subject, const std::string& property) const {
    const auto id = srdl_.dictionary.FindIri(std::string(kLares) + property);
    const auto found = values_.find(subject);
    if (!id || found == values_.end()) return std::nullopt;
    for (const auto& [predicate, object] : found->second) {
      if (predicate == *id) return object;
    }
    return std::nullopt;
  }
  std::optional<rdf::TermId> Value(rdf::TermId subject, const std::string& property) const {
    const auto object = Object(subject, property);
    if (!object || srdl_.dictionary.Kind(*object) != rdf::TermKind::kLiteral) return std::nullopt;
    return object;
  }

  std::optional<RigidTransform> Pose(rdf::TermId matrix) const {
    Eigen::Matrix4d entries = Eigen::Matrix4d::Identity();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        const auto entry = Value(matrix, "m" + std::to_string(row) + std::to_string(column));
        const auto number =
            entry ? ToNumber(Trim(srdl_.dictionary.Get(*entry).value)) : std::nullopt;
        if (!number) return std::nullopt;
        entries(row, column) = *number;
      }
    }
    try {
      return FromMatrix(entries, 0.01);
    } catch (const Error&) {
      return std::nullopt;
    }
  }

  const SrdlToCompare& srdl_;
  std::map<rdf::TermId, Properties> values_;
};

std::string Figure(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

std::string KindOf(const Joint& joint) {
  std::string kind(ToString(joint.kind));
  kind[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(kind[0])));
  return kind + "UrdfJoint";
}

}  // namespace

void CompareWithSrdl(const Model& model, const SrdlToCompare& srdl, const CompareOptions& options,
                     const std::string& source, std::vector<Finding>& findings) {
  const SrdlReader reader(srdl);
  std::map<std::string, Said> links = reader.Read(false);
  std::map<std::string, Said> joints = reader.Read(true);
  const auto add = [&](Severity severity, const char* code, int line, const std::string& message,
                       const std::string& remedy) {
    findings.push_back({severity, code, {source, line, 0}, message, remedy});
  };
  const std::string anew = "put the robot anew from this URDF, or mend the older of the two";
  for (const Link& link : model.links) {
    if (links.erase(link.name) > 0) continue;
    add(Severity::kWarning, "link-only-in-urdf", link.line,
        "the link " + Quote(link.name) + " is not in the SRDL of " + Quote(srdl.name), anew);
  }
  for (const Joint& joint : model.joints) {
    const auto found = joints.find(joint.name);
    if (found == joints.end()) {
      add(Severity::kWarning, "joint-only-in-urdf", joint.line,
          "the joint " + Quote(joint.name) + " is not in the SRDL of " + Quote(srdl.name), anew);
      continue;
    }
    const Said said = found->second;
    joints.erase(found);
    if (said.kind != KindOf(joint) && said.kind != "UrdfJoint") {
      add(Severity::kError, "joint-kind-differs", joint.line,
          "the joint " + Quote(joint.name) + " is " + std::string(ToString(joint.kind)) +
              " in the URDF and a " + said.kind + " in the SRDL of " + Quote(srdl.name),
          anew);
    }
    if (!said.parent_from_child) continue;
    const RigidTransform off = Inverse(joint.parent_from_child) * *said.parent_from_child;
    const double distance_m = off.translation_m.norm();
    const double angle_rad = off.rotation.angularDistance(Eigen::Quaterniond::Identity());
    if (distance_m <= options.distance_m && angle_rad <= options.angle_rad) continue;
    add(Severity::kError, "pose-differs", joint.line,
        "the joint " + Quote(joint.name) + " sits " + Figure(distance_m * 1000) + " mm and " +
            Figure(angle_rad * 180 / M_PI) + " degrees elsewhere in the SRDL of " +
            Quote(srdl.name),
        anew);
  }
  for (const auto& [name, said] : links) {
    add(Severity::kWarning, "link-only-in-srdl", 0,
        "the SRDL of " + Quote(srdl.name) + " has a link " + Quote(name) + " that the URDF lacks",
        anew);
  }
  for (const auto& [name, said] : joints) {
    add(Severity::kWarning, "joint-only-in-srdl", 0,
        "the SRDL of " + Quote(srdl.name) + " has a joint " + Quote(name) + " that the URDF lacks",
        anew);
  }
}

}  // namespace lares::urdf
