// Sorting triples by one component at a time: orders follow from one another.
#pragma once

#include <vector>

#include "ontology/triples/graph.h"

namespace lares::rdf {

enum class Component { kSubject, kPredicate, kObject };

inline TermId Get(const Triple& triple, Component component) {
  switch (component) {
    case Component::kSubject:
      return triple.subject;
    case Component::kPredicate:
      return triple.predicate;
    case Component::kObject:
      break;
  }
  return triple.object;
}

// By one component; triples that agree in it keep their order. Linear in long inputs.
void StableSortBy(Component component, std::vector<Triple>& triples);

// By subject, predicate, object; repeated triples once.
void SortAndDeduplicate(std::vector<Triple>& triples);

}  // namespace lares::rdf
