// From the bytes of a URDF to an SRDL document, in one step.
#pragma once

#include <string>
#include <string_view>

#include "robots/urdf/body.h"
#include "robots/urdf/kinematics.h"
#include "robots/urdf/limits.h"
#include "robots/urdf/model.h"
#include "robots/urdf/srdl.h"

namespace lares::urdf {

struct Imported {
  Model model;
  Kinematics kinematics;
  Body body;
};

// Reads and concludes. Throws as ReadUrdf and InferBody.
Imported Import(std::string_view bytes, const std::string& source,
                const std::string& base_frame = "", const Limits& limits = {});

}  // namespace lares::urdf
