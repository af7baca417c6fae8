// One expression or axiom as a tree: what functional syntax and OWL/XML have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ontology/rdf/owl_syntax/constructs.h"

namespace lares::rdf {

// Where something was written: a byte of the text or, with `line` set, a line and a column.
struct SourcePoint {
  std::size_t offset = 0;
  int line = 0;
  int column = 0;
};

struct OwlNode {
  enum class Kind : std::uint8_t { kConstruct, kIri, kBlank, kLiteral, kNumber };

  Kind kind = Kind::kConstruct;
  // Of an IRI: the entity that OWL/XML says it is, kNone where only the position tells.
  Construct construct = Construct::kNone;
  std::uint32_t term = 0;  // of all but constructs: index into the document's terms
  SourcePoint point;
  std::vector<OwlNode> annotations;  // of axioms and annotations
  std::vector<OwlNode> arguments;

  static OwlNode Of(Construct construct, std::vector<OwlNode> arguments) {
    OwlNode node;
    node.construct = construct;
    node.arguments = std::move(arguments);
    return node;
  }
  static OwlNode Leaf(Kind kind, std::uint32_t term, SourcePoint point = {}) {
    OwlNode node;
    node.kind = kind;
    node.term = term;
    node.point = point;
    return node;
  }
};

}  // namespace lares::rdf
