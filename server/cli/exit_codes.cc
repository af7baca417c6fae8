#include "server/cli/exit_codes.h"

#include <algorithm>

#include "base/error.h"
#include "server/cli/remote.h"
#include "server/http/client.h"

namespace lares::cli {

const std::vector<ExitMeaning>& ExitMeanings() {
  static const std::vector<ExitMeaning> meanings = {
      {ExitCode::kOk, "it was done", {}},
      {ExitCode::kInternal,
       "a file or connection failed, or Lares itself did; lares plan diff: the plans differ",
       {"io", "internal"}},
      {ExitCode::kUsage, "the command line was wrong", {}},
      {ExitCode::kRefused,
       "the input was refused: malformed, contradictory, too large, not supported, not allowed",
       {"invalid",
        "too-large",
        "unsupported",
        "forbidden",
        "bad-request",
        "method-not-allowed",
        "not-acceptable",
        "length-unknown",
        "uri-too-long",
        "range-not-satisfiable",
        "headers-too-large",
        "goal-error",
        "idempotency-key-reused",
        "tus-version",
        "checksum-mismatch",
        "foreign-term",
        "contradiction",
        "token-missing",
        "token-invalid",
        "token-expired",
        "token-revoked",
        "role-too-low"}},
      {ExitCode::kNoSuchName,
       "a name that nothing, or more than one thing, answers to",
       {"not-found", "ambiguous"}},
      {ExitCode::kConflict,
       "somebody else changed it meanwhile, or it exists already",
       {"conflict", "merge-conflict", "precondition-failed", "request-in-progress",
        "upload-locked"}},
      {ExitCode::kNoServer, "no server answers", {}},
      {ExitCode::kNoPlan,
       "not possible for this robot, or a person has to choose first",
       {"not-feasible", "choice-needed", "recipe-unusable"}},
      {ExitCode::kUnavailable,
       "the server cannot do it now: storage full, stopping, out of time, or a token's limit",
       {"unavailable", "timeout", "request-timeout", "too-many-requests", "too-many-bytes",
        "too-many-queries"}},
      {ExitCode::kFindings, "a check found something", {}},
  };
  return meanings;
}

ExitCode ExitCodeOf(std::string_view problem_code) {
  for (const ExitMeaning& meaning : ExitMeanings()) {
    const auto& codes = meaning.problems;
    if (std::find(codes.begin(), codes.end(), problem_code) != codes.end()) return meaning.code;
  }
  return ExitCode::kInternal;
}

ExitCode ExitCodeOf(const std::exception& error) {
  if (dynamic_cast<const http::NoServerError*>(&error) != nullptr) return ExitCode::kNoServer;
  if (dynamic_cast<const FindingsError*>(&error) != nullptr) return ExitCode::kFindings;
  if (dynamic_cast<const DifferError*>(&error) != nullptr) return ExitCode::kInternal;  // as diff
  if (const auto* remote = dynamic_cast<const RemoteError*>(&error)) {
    return ExitCodeOf(remote->problem_code());
  }
  if (const auto* fault = dynamic_cast<const Error*>(&error)) {
    return ExitCodeOf(ToString(fault->code()));
  }
  return ExitCode::kInternal;
}

std::string ExitCodesText() {
  std::string text = "Exit codes:\n";
  for (const ExitMeaning& meaning : ExitMeanings()) {
    text += "  " + std::to_string(static_cast<int>(meaning.code)) + "  " +
            std::string(meaning.meaning) + "\n";
  }
  return text;
}

}  // namespace lares::cli
