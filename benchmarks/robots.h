// Robots by the dozen: our models with parts left out, added and changed in their numbers.
#pragma once

#include <cstdint>
#include <string>

namespace lares::bench {

// A description in Turtle of `<https://example.org/robots/robotN#…>`; equal for equal seeds.
std::string VariedRobot(const std::string& model, std::uint32_t seed);

}  // namespace lares::bench
