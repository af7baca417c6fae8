// Media types, and what a client accepts.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lares::http {

struct MediaType {
  std::string type;                               // "text/turtle", lower case
  std::map<std::string, std::string> parameters;  // names in lower case, quotes taken off
};

// Nothing when malformed.
std::optional<MediaType> ParseMediaType(std::string_view text);

// The one of `offered` (best first) that an Accept header likes most; the first for an empty
// header; nothing when none is acceptable. A malformed header accepts everything.
std::optional<std::string> ChooseMediaType(std::string_view accept,
                                           const std::vector<std::string>& offered);

// From the extension, for files that are served or sent: ".owl" → "application/rdf+xml".
std::string MediaTypeOfFile(std::string_view file_name);

}  // namespace lares::http
