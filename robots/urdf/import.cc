#include "robots/urdf/import.h"

namespace lares::urdf {

Imported Import(std::string_view bytes, const std::string& source, const std::string& base_frame,
                const Limits& limits) {
  Imported imported;
  imported.model = ReadUrdf(bytes, source, limits);
  imported.kinematics = MakeKinematics(imported.model);
  imported.body = InferBody(imported.model, imported.kinematics, base_frame);
  return imported;
}

}  // namespace lares::urdf
