// Names that XML allows.
#pragma once

#include <cstddef>
#include <string_view>

namespace lares::rdf {

// Where the longest ending of `iri` that is an XML name without colon begins; the length of `iri`
// when there is none.
std::size_t XmlNameStart(std::string_view iri);

// True for such a name in ASCII.
bool IsAsciiXmlName(std::string_view name);

// True when XML 1.0 can hold every character of the UTF-8 `text`.
bool IsXmlText(std::string_view text);

}  // namespace lares::rdf
