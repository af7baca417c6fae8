// What has to be known of a Turtle-like text before a recursive parser sees it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/document.h"
#include "ontology/rdf/reader.h"

namespace lares::rdf {

// Throws, with the place: kTooLarge where [], () and {} nest deeper than options.max_depth,
// kInvalid for a NUL outside of strings (Serd would take it for the end) and for a graph in Turtle
// (Serd would take it). Strings, IRIs and comments are skipped.
void CheckTurtleText(std::string_view text, Format format, const ReadOptions& options);

// A text with "L" put before each blank node's label.
struct RelabelledText {
  std::string text;
  std::vector<std::size_t> insertions;  // ascending, into `text`

  std::size_t OriginalOffset(std::size_t offset) const;
};

// Serd names blank nodes b1, b2, … itself and gives up on documents that have labels b1 and B1;
// such a document is read with all labels changed alike.
RelabelledText RelabelBlanks(std::string_view text);

}  // namespace lares::rdf
