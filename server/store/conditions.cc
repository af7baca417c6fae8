#include "server/store/conditions.h"

#include "base/error.h"
#include "base/text.h"

namespace lares::store {

void CheckIfMatch(const std::string& if_match, const std::optional<std::string>& current,
                  const std::string& what) {
  const bool holds = if_match.empty() || (if_match == "*"      ? current.has_value()
                                          : if_match == "none" ? !current.has_value()
                                                               : current == if_match);
  if (holds) return;
  throw Error(Code::kPreconditionFailed,
              what + (current ? " is at " + *current : std::string(" does not exist")) +
                  (if_match == "none" ? ", though it should not exist yet"
                   : if_match == "*"  ? ", though it should"
                                      : ", not at " + if_match))
      .WithHint("read its current state, then put again with that etag");
}

void CheckId(std::string_view id, std::string_view what) {
  if (IsIdentifier(id)) return;
  throw Error(Code::kInvalid, std::string(what) + " '" + std::string(id.substr(0, 200)) +
                                  "' is not 1–128 of A–Z a–z 0–9 . _ - not beginning with . or -");
}

void CheckText(std::string_view text, std::string_view what) {
  if (!IsUtf8(text)) throw Error(Code::kInvalid, std::string(what) + " is not UTF-8");
  if (text.find('\0') != std::string_view::npos) {
    throw Error(Code::kInvalid, std::string(what) + " has the character NUL");
  }
}

}  // namespace lares::store
