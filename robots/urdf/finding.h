// What is wrong with a robot's description, where, and what to do about it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace lares::urdf {

struct Finding {
  enum class Severity { kError, kWarning, kNote };
  Severity severity = Severity::kError;
  std::string code;  // stable: "two-roots", "no-inertia", …
  Place place;
  std::string message;  // one sentence
  std::string remedy;   // what to do; may be empty
};

std::string_view ToString(Finding::Severity severity);  // "error", "warning", "note"

bool HasErrors(const std::vector<Finding>& findings);

// The first error of `findings`, the others counted, as an Error kInvalid with place and hint.
Error ToError(const std::vector<Finding>& findings);

}  // namespace lares::urdf
