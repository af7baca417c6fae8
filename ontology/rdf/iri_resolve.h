// Relative references made absolute (RFC 3986, 5.2, strict).
#pragma once

#include <string>
#include <string_view>

namespace lares::rdf {

// `reference` against the absolute IRI `base`, written to `out`.
void ResolveIri(std::string_view reference, std::string_view base, std::string& out);

}  // namespace lares::rdf
