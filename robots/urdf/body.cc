#include "robots/urdf/body.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "base/text.h"
#include "robots/urdf/infer.h"

namespace lares::urdf {
namespace {

int FindBaseFrame(const Model& model, const std::string& wanted) {
  if (wanted.empty()) {
    for (const char* name : {"base_footprint", "base_link"}) {
      if (const int link = model.FindLink(name); link >= 0) return link;
    }
    return model.root;
  }
  if (const int link = model.FindLink(wanted); link >= 0) return link;
  std::vector<std::string> names;
  for (const Link& link : model.links) names.push_back(link.name);
  throw Error(Code::kNotFound, "the robot has no link '" + wanted + "' to be its base frame")
      .WithCandidates(SimilarNames(wanted, names));
}

double MassOf(const Model& model) {
  double mass = 0;
  for (const Link& link : model.links) mass += link.inertial ? link.inertial->mass_kg : 0;
  return mass;
}

void AddNotes(const Model& model, Body& body) {
  const auto note = [&](const std::string& text) { body.notes.push_back(text); };
  if (body.base.kind == BaseKind::kUnknown)
    note("how the base drives is not known: " + body.base.reason);
  if (!body.footprint) {
    note(
        "no footprint: no box, cylinder or sphere stands near the floor, and meshes are not "
        "opened");
  }
  if (body.sensors.empty()) note("no sensors: the URDF has none, and no link is named as one");
  if (std::any_of(body.grippers.begin(), body.grippers.end(), [&](const Gripper& gripper) {
        const auto index = &gripper - body.grippers.data();
        return std::none_of(body.arms.begin(), body.arms.end(),
                            [&](const Arm& arm) { return arm.gripper == index; });
      })) {
    note("a gripper sits on fewer than three joints: it has no arm");
  }
  if (MassOf(model) <= 0) note("no link has a mass");
}

}  // namespace

std::vector<std::string> WordsOf(std::string_view name) {
  std::vector<std::string> words(1);
  char before = '\0';
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool camel = std::isupper(byte) && std::islower(static_cast<unsigned char>(before));
    const bool digit_edge = std::isdigit(byte) != std::isdigit(static_cast<unsigned char>(before));
    if (!std::isalnum(byte) || camel || (digit_edge && before != '\0')) words.emplace_back();
    if (std::isalnum(byte)) words.back() += static_cast<char>(std::tolower(byte));
    before = c;
  }
  std::erase(words, "");
  return words;
}

bool HasWord(std::string_view name, const std::vector<std::string>& wanted) {
  const std::vector<std::string> words = WordsOf(name);
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  });
}

Body InferBody(const Model& model, const Kinematics& kinematics, const std::string& base_frame) {
  Body body;
  body.base_frame = FindBaseFrame(model, base_frame);
  body.mass_kg = MassOf(model);
  body.base = InferBase(model, kinematics);
  body.floor_m = FloorInRoot(model, kinematics, body.base, body.base_frame) -
                 kinematics.root_from_link[At(body.base_frame)].translation_m.z();
  body.grippers = InferGrippers(model, kinematics);
  body.arms = InferArms(model, kinematics, body.grippers, body.base);
  body.sensors = InferSensors(model, kinematics, body.base_frame);
  body.heads = InferHeads(model, kinematics, body);
  body.torsos = InferTorsos(model, kinematics, body);
  body.footprint = InferFootprint(model, kinematics, body);
  body.height = InferHeight(model, kinematics, body);
  AddNotes(model, body);
  return body;
}

}  // namespace lares::urdf
