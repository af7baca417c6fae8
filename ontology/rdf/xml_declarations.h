// What an XML document declares, found without a parser that would stop at its faults.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace lares::rdf {

struct XmlDeclarations {
  std::map<std::string, std::string, std::less<>> entities;
  // Prefix → namespace; nothing for a prefix that the document binds to two.
  std::map<std::string, std::optional<std::string>, std::less<>> prefixes;

  // `text` with declared entities expanded; nothing when one is not declared.
  std::optional<std::string> Expand(std::string_view text, int depth = 0) const;
};

// Of `text`, and rdf, rdfs, owl and xsd where it does not bind these prefixes itself.
XmlDeclarations CollectDeclarations(std::string_view text);

}  // namespace lares::rdf
