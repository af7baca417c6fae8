// XML text, as the behaviour trees need it.
#pragma once

#include <string>
#include <string_view>

namespace lares::recipes {

// For attribute values in double quotes and for text. Control characters that XML 1.0 has no way to
// write are left out.
std::string EscapedXml(std::string_view text);
// ` name="value"`, with a space before it.
std::string XmlAttribute(std::string_view name, std::string_view value);

}  // namespace lares::recipes
