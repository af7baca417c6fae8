// What the process says to its caller when it ends: the one table.
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace lares::cli {

enum class ExitCode {
  kOk = 0,
  kInternal = 1,
  kUsage = 2,
  kRefused = 3,
  kNoSuchName = 4,
  kConflict = 5,
  kNoServer = 6,
  kNoPlan = 7,
  kUnavailable = 8,
  kFindings = 9,
};

// Thrown when a check has found something, after it was printed.
class FindingsError : public Error {
 public:
  explicit FindingsError(const std::string& message) : Error(Code::kInvalid, message) {}
};

// Thrown by `lares plan diff` after it has printed what differs.
class DifferError : public Error {
 public:
  explicit DifferError(const std::string& message) : Error(Code::kInvalid, message) {}
};

struct ExitMeaning {
  ExitCode code;
  std::string_view meaning;
  std::vector<std::string_view> problems;  // the problem codes that end so
};
const std::vector<ExitMeaning>& ExitMeanings();

// For the code of a problem document; kInternal for one that is not known.
ExitCode ExitCodeOf(std::string_view problem_code);
ExitCode ExitCodeOf(const std::exception& error);

// For `lares help exit-codes`.
std::string ExitCodesText();

}  // namespace lares::cli
