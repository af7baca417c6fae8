// Prefixes that a Turtle text can use, and IRIs shortened by them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace lares::rdf {

class PrefixTable {
 public:
  // `prefixes` that Turtle can spell, and rdf, rdfs, owl and xsd where they are free.
  explicit PrefixTable(const std::map<std::string, std::string>& prefixes);

  // "owl:Class"; empty when no prefix shortens `iri`.
  std::string Shorten(std::string_view iri);
  // The lines that declare: all of the document's, of the others those used.
  std::string Declarations() const;

 private:
  std::map<std::string, std::string, std::less<>> declared_;      // prefix → namespace
  std::map<std::string, std::string, std::less<>> of_namespace_;  // the first prefix wins
  std::set<std::string, std::less<>> unused_;                     // not the document's own
};

}  // namespace lares::rdf
