#include "robots/urdf/finding.h"

#include <algorithm>

namespace lares::urdf {
namespace {

bool IsError(const Finding& finding) { return finding.severity == Finding::Severity::kError; }

}  // namespace

std::string_view ToString(Finding::Severity severity) {
  switch (severity) {
    case Finding::Severity::kError:
      return "error";
    case Finding::Severity::kWarning:
      return "warning";
    case Finding::Severity::kNote:
      return "note";
  }
  return "error";
}

bool HasErrors(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(), IsError);
}

Error ToError(const std::vector<Finding>& findings) {
  const auto first = std::find_if(findings.begin(), findings.end(), IsError);
  if (first == findings.end()) return Error(Code::kInternal, "no finding is an error");
  const auto more = std::count_if(first + 1, findings.end(), IsError);
  std::string message = first->message;
  if (more > 0)
    message += " (and " + std::to_string(more) + " more: lares robot doctor lists them)";
  Error error(Code::kInvalid, message, first->place);
  if (!first->remedy.empty()) error.WithHint(first->remedy);
  return error;
}

}  // namespace lares::urdf
