// The foreign predicates of module rdf_edge, on which rules/rdf_view.pl stands.
#pragma once

namespace lares::prolog {

// Once per process, with an attached engine.
void RegisterRdfPredicates();

// Choice points of rdf/3 and its like that now hold a view, in all engines. For tests.
int LiveChoicePoints();

}  // namespace lares::prolog
