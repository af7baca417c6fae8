// Terms as people write them.
#pragma once

#include <string>

#include "ontology/rdf/aliases.h"
#include "ontology/triples/view.h"

namespace lares::server {

// The term that `text` means in `view`: <iri>, a whole IRI, prefix:name (rdf, rdfs, owl, xsd,
// lares), a literal or a blank node as Turtle writes them, "a" for rdf:type; otherwise a name of
// ours, the local name of an IRI that the view mentions, or a label. Aliases are followed. Throws
// kInvalid (malformed), kNotFound with similar names, kAmbiguous with the candidates.
rdf::TermId ResolveTerm(const rdf::View& view, const rdf::AliasTable& aliases,
                        const std::string& text);

}  // namespace lares::server
