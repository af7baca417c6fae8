// Attributes of the elements of behaviour trees.
#pragma once

#include <string>
#include <string_view>

#include "base/xml_text.h"

namespace lares::recipes {

// ` name="value"`, with a space before it.
inline std::string XmlAttribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + EscapedXml(value, XmlUse::kAttribute) + "\"";
}

}  // namespace lares::recipes
