// Text inside XML.
#pragma once

#include <string>
#include <string_view>

namespace lares {

// UTF-8 `text` as character data, or as the value of an attribute in double quotes: what a reader
// gets back is the text, but for control characters that XML 1.0 has no way to write, which become
// U+FFFD.
enum class XmlUse { kText, kAttribute };
std::string EscapedXml(std::string_view text, XmlUse use);

}  // namespace lares
