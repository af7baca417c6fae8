// XML inside literals.
#pragma once

#include <string_view>

namespace lares::rdf {

// True when `text` may stand between a start tag and its end tag: what rdf:XMLLiteral allows.
// Entities are not expanded; nothing is fetched.
bool IsXmlFragment(std::string_view text);

}  // namespace lares::rdf
