#include "server/http/etag.h"

#include "base/error.h"
#include "base/text.h"
#include "server/http/content_coding.h"

namespace lares::http {

std::optional<std::vector<EntityTag>> ParseEntityTags(std::string_view header) {
  std::vector<EntityTag> tags;
  std::string_view rest = Trim(header);
  while (!rest.empty()) {
    EntityTag tag;
    if (rest.starts_with("W/")) {
      tag.weak = true;
      rest.remove_prefix(2);
    }
    if (!rest.starts_with('"')) return std::nullopt;
    const std::size_t close = rest.find('"', 1);
    if (close == std::string_view::npos) return std::nullopt;
    tag.tag = std::string(rest.substr(0, close + 1));
    tags.push_back(std::move(tag));
    rest = Trim(rest.substr(close + 1));
    if (rest.empty()) break;
    if (!rest.starts_with(',')) return std::nullopt;
    rest = Trim(rest.substr(1));
  }
  if (tags.empty()) return std::nullopt;
  return tags;
}

bool NoneMatchHits(std::string_view header, std::string_view etag) {
  if (header.empty() || etag.empty()) return false;
  if (Trim(header) == "*") return true;
  const auto tags = ParseEntityTags(header);
  if (!tags) return false;
  for (const EntityTag& tag : *tags) {
    if (tag.tag == etag) return true;
  }
  return false;
}

std::string WriteCondition(const Request& request, const std::optional<std::string>& current) {
  const std::string if_none_match = request.headers.GetList("If-None-Match");
  const std::string if_match = request.headers.GetList("If-Match");
  if (!if_none_match.empty()) {
    if (Trim(if_none_match) != "*" || !if_match.empty()) {
      throw Error(Code::kInvalid,
                  "for a write, If-None-Match takes only '*', and not together "
                  "with If-Match");
    }
    return "none";
  }
  if (if_match.empty()) return "";
  if (Trim(if_match) == "*") return "*";
  const auto tags = ParseEntityTags(if_match);
  if (!tags) {
    throw Error(Code::kInvalid, "If-Match is no list of entity tags: " + if_match)
        .WithHint("send the ETag as it was received, with its quotes");
  }
  // A weak tag never satisfies If-Match, so it is passed on in a form that no ETag has.
  std::string chosen = "\"\"";
  for (const EntityTag& tag : *tags) {
    if (tag.weak) continue;
    chosen = IdentityTag(tag.tag);  // whichever form of it was received
    if (current && chosen == *current) break;
  }
  return chosen;
}

}  // namespace lares::http
