// What has to be known of a Turtle-like text before a recursive parser sees it.
#pragma once

#include <string_view>

#include "ontology/rdf/reader.h"

namespace lares::rdf {

// Throws, with the place: kTooLarge where [], () and {} nest deeper than options.max_depth, kInvalid
// for a NUL outside of strings (Serd would take it for the end). Strings, IRIs and comments are
// skipped.
void CheckTurtleText(std::string_view text, const ReadOptions& options);

}  // namespace lares::rdf
