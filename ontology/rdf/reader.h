// Reading RDF: RDF/XML (libxml2's reader, then Raptor), Turtle, TriG, N-Triples, N-Quads (Serd),
// JSON-LD (our own), and OWL 2's functional syntax and OWL/XML as the triples they map to.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "ontology/rdf/document.h"

namespace lares::rdf {

struct ReadOptions {
  std::string source;    // file name or id for error places
  std::string base_iri;  // for relative IRIs where the document states no base
  // Namespaces that `recover` may take an undeclared entity for, beside rdf, rdfs, owl, xsd and the
  // document's own prefixes: prefix → IRI.
  std::map<std::string, std::string> known_namespaces;
  bool record_lines = false;  // fill Document::lines; slower
  bool recover = false;       // repair the known faults of RDF/XML, listing each as a remark
  std::size_t max_bytes = 256u << 20;  // of the document
  std::size_t max_statements = 20'000'000;
  std::size_t max_term_bytes = 16u << 20;    // of one literal or IRI
  int max_depth = 256;                       // XML element nesting; Turtle nesting of [] and ()
  std::size_t max_entity_bytes = 16u << 20;  // all text that entity references expand to
};

// The whole document, or an Error with source, line and column: kInvalid (malformed), kTooLarge (a
// limit), kUnsupported. Never touches the network or any other file; external entities, DTD
// subsets from outside and XInclude are refused. Terms are checked: IRIs have no spaces or control
// characters, text is UTF-8. A relative IRI where no base is known is an error, so give one. The
// Turtle family is read strictly (N-Triples: one statement to a line). RDF/XML nests 256 elements
// at most, whatever max_depth says: libxml2's own bound. Columns count characters.
//
// JSON-LD 1.1 with the contexts that stand in the document; one by IRI is an error, and so is the
// same key twice. What its standard has left out (names without a meaning, IRIs that are none) is
// left out with a warning for each of the first 100.
//
// With `recover`, RDF/XML may have: malformed comments ("<!-x-->", "--" inside), references to
// undefined entities whose namespace is known (built-in prefixes and the document's own xmlns), and
// rdf:resource where rdf:about belongs or beside content. Each repair is a Remark with its place.
// Thread-safe.
Document ReadRdf(std::string_view bytes, Format format, const ReadOptions& options);

}  // namespace lares::rdf
