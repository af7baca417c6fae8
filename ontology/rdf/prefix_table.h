// Prefixes that a Turtle text can use, and IRIs shortened by them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lares::rdf {

class PrefixTable {
 public:
  // `prefixes` that Turtle can spell, and rdf, rdfs, owl and xsd where they are free.
  explicit PrefixTable(const std::map<std::string, std::string>& prefixes);

  // "owl:Class"; empty when no prefix shortens `iri`.
  std::string Shorten(std::string_view iri);
  // The lines that declare: all of the document's, of the others those used.
  std::string Declarations() const;
  // The same as pairs of prefix and namespace.
  std::vector<std::pair<std::string, std::string>> Used() const;

 private:
  std::map<std::string, std::string, std::less<>> declared_;      // prefix → namespace
  std::map<std::string, std::string, std::less<>> of_namespace_;  // the first prefix wins
  std::set<std::string, std::less<>> unused_;                     // not the document's own
};

}  // namespace lares::rdf
