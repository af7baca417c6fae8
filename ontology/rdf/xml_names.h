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

struct XmlNameForm {
  bool allows_colon = false;  // Name rather than NCName
  bool is_token = false;      // NMTOKEN: any name character may come first
};
// True when all of the UTF-8 `text` is a name of that form.
bool IsXmlName(std::string_view text, const XmlNameForm& form);

// True when XML 1.0 can hold every character of the UTF-8 `text`.
bool IsXmlText(std::string_view text);

}  // namespace lares::rdf
