// OWL 2's own syntaxes, read as the triples they map to. ReadRdf chooses between them.
#pragma once

#include <string_view>

#include "ontology/rdf/document.h"
#include "ontology/rdf/reader.h"

namespace lares::rdf {

// `bytes` are UTF-8 without byte order mark. Rules (DLSafeRule) are left out with a warning.
Document ReadOwlFunctional(std::string_view bytes, const ReadOptions& options);

// With libxml2's checks and limits, as RDF/XML.
Document ReadOwlXml(std::string_view bytes, const ReadOptions& options);

// True for a label that SPARQL 1.0 allows after "_:", and then some: no ASCII beside letters,
// digits, '_', '-' and '.', first neither '-' nor '.', last not '.'.
bool IsNodeLabel(std::string_view label);

}  // namespace lares::rdf
