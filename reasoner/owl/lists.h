// RDF lists, and the rules whose length depends on one.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/owl/rule.h"

namespace lares::owl {

// One way to read a list: its members, and the rdf:first and rdf:rest triples that say so.
struct ListReading {
  std::vector<rdf::TermId> members;
  std::vector<rdf::Triple> cells;
};

using ObjectsOf =
    std::function<std::vector<rdf::TermId>(rdf::TermId subject, rdf::TermId predicate)>;

// All readings of the list that begins at `head`: one for a well-formed list; several when a cell
// has several members or continuations (of which at most 64 are given); none when no way reaches
// rdf:nil.
std::vector<ListReading> ReadLists(rdf::TermId head, const Vocabulary& words,
                                   const ObjectsOf& objects_of);

// The data patterns and heads that `rule.list_procedure` writes for one reading of the list:
//   intersection  x a m1 … x a mn → x a subject
//   chain         x0 m1 x1 … xn-1 mn xn → x0 subject xn
//   key           x a subject, y a subject, x mi zi, y mi zi for each i → x owl:sameAs y
// `subject` is what the list belongs to. Empty lists give no data patterns.
Rule WriteRule(const Rule& rule, rdf::TermId subject, const std::vector<rdf::TermId>& members,
               const Vocabulary& words);

}  // namespace lares::owl
