// Which blank nodes a Turtle text can write without a label.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "ontology/rdf/document.h"

namespace lares::rdf {

struct InlineBlanks {
  // By term index.
  std::vector<bool> is_inline;   // object of just one statement, in its own graph, in no circle
  std::vector<bool> is_unnamed;  // subject only: nothing refers to it
  std::vector<bool> is_list;     // inline, and the head or a cell of a well-formed list
};

InlineBlanks FindInlineBlanks(const Document& document);

}  // namespace lares::rdf
