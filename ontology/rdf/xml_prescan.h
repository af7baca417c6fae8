// libxml2's pass over RDF/XML: well-formed, bounded, nothing from outside.
#pragma once

#include <cstddef>
#include <functional>
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

// A start tag as libxml2 reports it; its views are good during the call.
struct XmlElement {
  struct Attribute {
    std::string_view prefix, name, value;
  };
  std::string_view space;  // namespace IRI; may be empty
  std::string_view name;   // local
  std::vector<Attribute> attributes;
  std::string_view language;  // xml:lang in scope
  Place place;                // where the tag begins, if `offset` is not known
  std::size_t offset = 0;     // byte of the text where the tag begins; kNoOffset when not known

  static constexpr std::size_t kNoOffset = static_cast<std::size_t>(-1);
};

// What somebody wants to hear of the elements and their text. An Error thrown there ends the pass
// and is thrown by CheckXml.
struct XmlEvents {
  std::function<void(const XmlElement&)> start;
  std::function<void()> end;
  std::function<void(std::string_view)> text;  // in pieces
};

// Throws kInvalid where the text is not well-formed XML with namespaces, kTooLarge where elements
// nest deeper than options.max_depth (256 at most: libxml2's own bound) or entities expand to more
// than options.max_entity_bytes, kUnsupported for anything outside the document. Line and column
// are those of libxml2.
XmlSummary CheckXml(std::string_view bytes, const ReadOptions& options,
                    const XmlEvents* events = nullptr);

}  // namespace lares::rdf
