// What every write is checked for, before anything is written.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lares::store {

// Throws kPreconditionFailed when `if_match` ("" none, "*" exists, "none" does not exist, else an
// etag) does not hold for `what`, whose etag is `current` (nothing: it does not exist).
void CheckIfMatch(const std::string& if_match, const std::optional<std::string>& current,
                  const std::string& what);

// Throws kInvalid, naming `what`, unless `id` is an IsIdentifier.
void CheckId(std::string_view id, std::string_view what);

// Throws kInvalid, naming `what`, unless `text` is UTF-8 without NUL.
void CheckText(std::string_view text, std::string_view what);

}  // namespace lares::store
