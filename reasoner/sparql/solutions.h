// Triples made of solutions: CONSTRUCT and DESCRIBE.
#pragma once

#include <array>
#include <map>
#include <unordered_map>
#include <vector>

#include "ontology/rdf/document.h"
#include "reasoner/sparql/plan.h"
#include "reasoner/sparql/row_set.h"

namespace lares::sparql {

void RunPlan(Context& context, Plan& plan, FunctionRef<bool(Row&)> visit);

// Distinct triples, at most so many.
class TripleCollector {
 public:
  TripleCollector(Context& context, std::size_t most);
  // Whether it is new. Leaves out what is no triple of RDF: a literal as subject, a predicate that
  // is no IRI.
  bool Add(TermId subject, TermId predicate, TermId object);
  rdf::Document ToDocument() const;

 private:
  Context& context_;
  std::size_t most_;
  RowSet triples_;
};

void ConstructInto(TripleCollector& collector, Context& context, Plan& plan);
// Every triple of a resource in the default graph, and those of the blank nodes among its objects.
void DescribeInto(TripleCollector& collector, Context& context, Plan& plan);

}  // namespace lares::sparql
