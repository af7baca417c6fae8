// libxml2's pass over RDF/XML: well-formed, bounded, nothing from outside.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/document.h"
#include "ontology/rdf/reader.h"

namespace lares::rdf {

// A property attribute with a language in scope, which Raptor forgets. `line` is where its tag
// ends.
struct TaggedAttribute {
  int line = 0;
  std::string predicate;
  std::string value;
  std::string language;
};

struct XmlSummary {
  std::string base_iri;          // xml:base of the root element, without its fragment; may be empty
  std::vector<Remark> warnings;  // what libxml2 finds odd but legal
  std::vector<TaggedAttribute> tagged_attributes;  // by line, predicate, value
};

// Throws kInvalid where the text is not well-formed XML with namespaces, kTooLarge where elements
// nest deeper than options.max_depth (256 at most: libxml2's own bound) or entities expand to more
// than options.max_entity_bytes, kUnsupported for anything outside the document. Line and column
// are those of libxml2.
XmlSummary CheckXml(std::string_view bytes, const ReadOptions& options);

}  // namespace lares::rdf
