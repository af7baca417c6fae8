// Plain XML for tests.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace lares::testing {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<XmlElement> children;
  std::string text;
};
// Well-formed documents without DTD or CDATA; throws std::runtime_error otherwise.
XmlElement ParseXml(const std::string& text);

}  // namespace lares::testing
