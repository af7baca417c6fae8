// Faults as one exception type, with a place where there is one.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lares {

// What kind of fault. One table in server/api turns it into an HTTP status, one in server/cli into
// an exit code; nothing else interprets it.
enum class Code {
  kInvalid,             // the input is wrong; asking again does not help
  kNotFound,            // a name that nothing answers to
  kAmbiguous,           // a name that several things answer to; `candidates` lists them
  kConflict,            // somebody else changed it meanwhile, or it exists already
  kPreconditionFailed,  // If-Match did not hold
  kTooLarge,            // a limit on size, depth or count
  kTimeout,             // a limit on time
  kUnsupported,         // a format or option that is not known here
  kForbidden,           // not allowed from there (Host, Origin)
  kUnavailable,         // cannot be answered now (storage full, server stopping)
  kIo,                  // a file or socket failed
  kInternal,            // a broken invariant of ours
};

// "invalid", "not-found", …: stable, used in problem documents, logs and tests.
std::string_view ToString(Code code);

// A place in a text: 1-based, 0 for "not known". `source` is a file name or document id.
struct Place {
  std::string source;
  int line = 0;
  int column = 0;
};

// "recipe.owl:715:6", leaving out what is not known.
std::string ToString(const Place& place);

class Error : public std::runtime_error {
 public:
  Error(Code code, const std::string& message) : std::runtime_error(message), code_(code) {}
  Error(Code code, const std::string& message, Place place)
      : std::runtime_error(message), code_(code), place_(std::move(place)) {}

  Code code() const { return code_; }
  const std::optional<Place>& place() const { return place_; }

  // What the person can do about it, one sentence; empty when there is nothing to say.
  const std::string& hint() const { return hint_; }
  Error& WithHint(std::string hint) {
    hint_ = std::move(hint);
    return *this;
  }

  // The things that an ambiguous name may mean, or the names near an unknown one.
  const std::vector<std::string>& candidates() const { return candidates_; }
  Error& WithCandidates(std::vector<std::string> candidates) {
    candidates_ = std::move(candidates);
    return *this;
  }

  // "recipe.owl:715:6: malformed comment"
  std::string FullMessage() const;

 private:
  Code code_;
  std::optional<Place> place_;
  std::string hint_;
  std::vector<std::string> candidates_;
};

}  // namespace lares
