#include "base/error.h"

namespace lares {

std::string_view ToString(Code code) {
  switch (code) {
    case Code::kInvalid:
      return "invalid";
    case Code::kNotFound:
      return "not-found";
    case Code::kAmbiguous:
      return "ambiguous";
    case Code::kConflict:
      return "conflict";
    case Code::kPreconditionFailed:
      return "precondition-failed";
    case Code::kTooLarge:
      return "too-large";
    case Code::kTimeout:
      return "timeout";
    case Code::kUnsupported:
      return "unsupported";
    case Code::kForbidden:
      return "forbidden";
    case Code::kUnavailable:
      return "unavailable";
    case Code::kIo:
      return "io";
    case Code::kInternal:
      return "internal";
  }
  return "internal";
}

std::string ToString(const Place& place) {
  std::string text = place.source;
  for (int number : {place.line, place.column}) {
    if (number <= 0) break;
    if (!text.empty()) text += ':';
    text += std::to_string(number);
  }
  return text;
}

std::string Error::FullMessage() const {
  if (!place_) return what();
  const std::string where = ToString(*place_);
  return where.empty() ? what() : where + ": " + what();
}

}  // namespace lares
