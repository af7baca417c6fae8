// One function for each parser library; ReadRdf chooses among them.
#pragma once

#include <string_view>

#include "ontology/rdf/document.h"
#include "ontology/rdf/reader.h"

namespace lares::rdf {

// Turtle, TriG, N-Triples, N-Quads. `bytes` are UTF-8 without byte order mark.
Document ReadWithSerd(std::string_view bytes, Format format, const ReadOptions& options);

// RDF/XML, with libxml2's pass first.
Document ReadRdfXml(std::string_view bytes, const ReadOptions& options);

// JSON-LD. `bytes` are UTF-8 without byte order mark.
Document ReadJsonLd(std::string_view bytes, const ReadOptions& options);

}  // namespace lares::rdf
