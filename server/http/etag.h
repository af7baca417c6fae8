// Entity tags (RFC 9110 §8.8, §13).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/message.h"

namespace lares::http {

struct EntityTag {
  std::string tag;  // with its quotes
  bool weak = false;
};

// A list as If-Match and If-None-Match carry it; "*" is no tag. Nothing when malformed.
std::optional<std::vector<EntityTag>> ParseEntityTags(std::string_view header);

// If-None-Match against the tag that the resource has now (weak comparison): true means 304 for
// GET and HEAD.
bool NoneMatchHits(std::string_view header, std::string_view etag);

// What a write asks for, in the words of the store: "" (no condition), "*" (must exist), "none"
// (must not exist), or one tag. With several tags in If-Match the one equal to `current` is
// chosen. Throws kInvalid for a malformed header.
std::string WriteCondition(const Request& request, const std::optional<std::string>& current);

}  // namespace lares::http
