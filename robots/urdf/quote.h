// Names as messages show them.
#pragma once

#include <string>

namespace lares::urdf {

inline std::string Quote(const std::string& name) { return "'" + name + "'"; }

}  // namespace lares::urdf
