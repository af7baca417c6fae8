// One function for each syntax; WriteRdf checks the document and chooses among them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/document.h"

namespace lares::rdf {

// A label for each blank node, "" for other terms: as in the document when `fits` them all, else
// new ones.
std::vector<std::string> BlankLabels(const Document& document, bool (*fits)(std::string_view));

// N-Triples or, with graphs, N-Quads.
std::string WriteLines(const Document& document);
// Turtle or, with graphs, TriG.
std::string WriteTurtle(const Document& document);
std::string WriteRdfXml(const Document& document);
std::string WriteJsonLd(const Document& document);

}  // namespace lares::rdf
