// A URDF as a bounded tree of elements that know their lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robots/urdf/limits.h"

namespace lares::urdf {

struct Element {
  struct Attribute {
    std::string name, value;
  };
  std::string prefix;  // what its namespace ends in: "sensor" of <sensor:camera>; mostly empty
  std::string name;    // local
  int line = 0;        // where its tag begins
  std::vector<Attribute> attributes;
  std::string text;  // its own, trimmed
  std::vector<Element> children;

  const std::string* Find(std::string_view attribute) const;  // null when absent
  const Element* Child(std::string_view child) const;         // the first; null when absent
  std::vector<const Element*> Children(std::string_view child) const;
};

// True when the first element is <robot>, whatever comes before it.
bool IsUrdf(std::string_view bytes);

// The root element, <robot>. Throws kInvalid (malformed, another root, elements of xacro or ${…}
// that were not expanded, with the command to run as hint), kTooLarge (naming the limit) and
// kUnsupported (a document type), each with its line. A prefix that is used without being declared
// is taken as it stands.
Element ReadXmlTree(std::string_view bytes, const std::string& source, const Limits& limits = {});

}  // namespace lares::urdf
