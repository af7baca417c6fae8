// A document as read: terms once, statements as indices into them, nothing interned anywhere yet.
// So a document that fails half-way leaves no trace.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "ontology/rdf/term.h"

namespace lares::rdf {

enum class Format {
  kRdfXml,
  kTurtle,
  kTriG,
  kNTriples,
  kNQuads,
  kJsonLd,
  kOwlFunctional,  // OWL 2 Functional-Style Syntax
  kOwlXml,         // OWL/XML, which is not RDF/XML
};

// "application/rdf+xml", "text/turtle", …
std::string_view MediaType(Format format);
// From a media type (parameters ignored), a file name (".owl", ".rdf", ".ttl", ".trig", ".nt",
// ".nq", ".jsonld", ".ofn", ".owx") or, with neither telling, the first bytes. ".owl" and the media
// types of XML say little: the first bytes tell RDF/XML from OWL's own syntaxes. Throws
// kUnsupported.
Format GuessFormat(std::string_view media_type, std::string_view file_name, std::string_view bytes);

struct Statement {
  std::uint32_t subject = 0;  // index into Document::terms
  std::uint32_t predicate = 0;
  std::uint32_t object = 0;
  std::uint32_t graph = kDefaultGraph;

  static constexpr std::uint32_t kDefaultGraph = UINT32_MAX;
};

// One thing that reading changed (`--recover`) or noticed.
struct Remark {
  enum class Kind { kRepair, kWarning };
  Kind kind = Kind::kWarning;
  Place place;
  std::string message;
};

struct Document {
  std::string base_iri;  // RDF/XML: xml:base of the root; Turtle: the given or the first stated
  Format format = Format::kTurtle;
  std::vector<Term> terms;  // each distinct term once, as written (aliases not applied)
  std::vector<Statement> statements;
  // On request (ReadOptions::record_lines), for each statement the line on which it ends, give or
  // take one; empty otherwise and where the format's reader does not know.
  std::vector<std::uint32_t> lines;
  std::map<std::string, std::string> prefixes;  // prefix without ':' → IRI
  std::vector<std::string> imports;             // objects of owl:imports, as written
  std::vector<Remark> remarks;                  // repairs and warnings, in order of place
};

}  // namespace lares::rdf
