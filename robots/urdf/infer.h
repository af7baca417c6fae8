// The steps of InferBody.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robots/urdf/body.h"

namespace lares::urdf {

inline std::size_t At(int index) { return static_cast<std::size_t>(index); }

// The words of a name, lower case: "l_wheelFront2" → l, wheel, front, 2.
std::vector<std::string> WordsOf(std::string_view name);
// One of `wanted` is a word of `name`.
bool HasWord(std::string_view name, const std::vector<std::string>& wanted);

Base InferBase(const Model& model, const Kinematics& kinematics);
// The lowest point of the wheels, else zero (the base frame's origin is on the floor), in the root.
double FloorInRoot(const Model& model, const Kinematics& kinematics, const Base& base,
                   int base_frame);

std::vector<Gripper> InferGrippers(const Model& model, const Kinematics& kinematics);
std::vector<Arm> InferArms(const Model& model, const Kinematics& kinematics,
                           std::vector<Gripper>& grippers, const Base& base);
std::vector<BodySensor> InferSensors(const Model& model, const Kinematics& kinematics,
                                     int base_frame);
std::vector<Head> InferHeads(const Model& model, const Kinematics& kinematics, const Body& body);
std::vector<Torso> InferTorsos(const Model& model, const Kinematics& kinematics, const Body& body);

// Both want body.base, body.arms and body.floor_m.
std::optional<Footprint> InferFootprint(const Model& model, const Kinematics& kinematics,
                                        const Body& body);
std::optional<BodyHeight> InferHeight(const Model& model, const Kinematics& kinematics,
                                      const Body& body);

}  // namespace lares::urdf
