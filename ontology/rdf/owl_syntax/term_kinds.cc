#include "ontology/rdf/owl_syntax/term_kinds.h"

#include <deque>
#include <utility>

namespace lares::rdf {
namespace {

constexpr std::uint8_t kAnyProperty = kIsObjectProperty | kIsDataProperty | kIsAnnotationProperty;

using Kinds = std::vector<std::uint8_t>;

std::uint8_t KindOfType(Word type) {
  switch (type) {
    case Word::kOwlClass:
      return kIsClass;
    case Word::kRdfsDatatype:
      return kIsDatatype;
    case Word::kOwlObjectProperty:
    case Word::kOwlInverseFunctionalProperty:
    case Word::kOwlReflexiveProperty:
    case Word::kOwlIrreflexiveProperty:
    case Word::kOwlSymmetricProperty:
    case Word::kOwlAsymmetricProperty:
    case Word::kOwlTransitiveProperty:
      return kIsObjectProperty;
    case Word::kOwlDatatypeProperty:
      return kIsDataProperty;
    case Word::kOwlAnnotationProperty:
      return kIsAnnotationProperty;
    case Word::kOwlNamedIndividual:
    case Word::kOwlThing:
    case Word::kOwlNothing:
      return kIsIndividual;
    default:
      return 0;
  }
}

void MarkBuiltIn(const OwlGraph& graph, Kinds& kinds) {
  for (std::uint32_t i = 0; i < kinds.size(); ++i) {
    if (!graph.IsIri(i)) continue;
    const Word word = graph.word(i);
    if (word == Word::kOwlThing || word == Word::kOwlNothing) kinds[i] |= kIsClass;
    if (word == Word::kOwlTopObjectProperty || word == Word::kOwlBottomObjectProperty) {
      kinds[i] |= kIsObjectProperty;
    }
    if (word == Word::kOwlTopDataProperty || word == Word::kOwlBottomDataProperty) {
      kinds[i] |= kIsDataProperty;
    }
    if (IsBuiltInAnnotation(word)) kinds[i] |= kIsAnnotationProperty;
    if (IsBuiltInDatatype(graph.term(i).value)) kinds[i] |= kIsDatatype;
  }
}

void MarkTypes(const OwlGraph& graph, Kinds& kinds) {
  for (const Statement& s : graph.statements()) {
    if (graph.word(s.predicate) != Word::kRdfType) continue;
    kinds[s.subject] |= KindOfType(graph.word(s.object));
    if (!graph.IsIri(s.object) || !IsReserved(graph.term(s.object).value)) {
      kinds[s.subject] |= kIsIndividual;
      kinds[s.object] |= kIsClass;
    }
  }
}

// What a restriction says of its property.
std::uint8_t KindByRestriction(OwlGraph& graph, const Kinds& kinds, std::uint32_t restriction) {
  std::uint8_t kind = 0;
  for (const std::uint32_t index : graph.About(restriction)) {
    const Statement& s = graph.statements()[index];
    switch (graph.word(s.predicate)) {
      case Word::kOwlOnClass:
      case Word::kOwlHasSelf:
        kind |= kIsObjectProperty;
        break;
      case Word::kOwlOnDataRange:
        kind |= kIsDataProperty;
        break;
      case Word::kOwlHasValue:
        kind |= graph.IsLiteral(s.object) ? kIsDataProperty : kIsObjectProperty;
        break;
      case Word::kOwlSomeValuesFrom:
      case Word::kOwlAllValuesFrom:
        if (IsDataRange(graph, kinds, s.object)) {
          kind |= kIsDataProperty;
        } else if (graph.IsBlank(s.object) || (kinds[s.object] & kIsClass) != 0) {
          kind |= kIsObjectProperty;
        }
        break;
      default:
        break;
    }
  }
  return kind;
}

void MarkByUse(OwlGraph& graph, Kinds& kinds) {
  for (const Statement& s : graph.statements()) {
    switch (graph.word(s.predicate)) {
      case Word::kRdfsSubClassOf:
      case Word::kOwlDisjointWith:
        kinds[s.subject] |= kIsClass;
        kinds[s.object] |= kIsClass;
        break;
      case Word::kOwlInverseOf:
        kinds[s.subject] |= kIsObjectProperty;
        kinds[s.object] |= kIsObjectProperty;
        break;
      case Word::kOwlPropertyChainAxiom:
        kinds[s.subject] |= kIsObjectProperty;
        break;
      case Word::kOwlOnProperty:
        if ((kinds[s.object] & kAnyProperty) == 0) {
          kinds[s.object] |= KindByRestriction(graph, kinds, s.subject);
        }
        break;
      case Word::kRdfsRange:
        if ((kinds[s.subject] & kAnyProperty) != 0) break;
        if (IsDataRange(graph, kinds, s.object)) {
          kinds[s.subject] |= kIsDataProperty;
        } else if (graph.IsBlank(s.object) || (kinds[s.object] & kIsClass) != 0) {
          kinds[s.subject] |= kIsObjectProperty;
        }
        break;
      default:
        break;
    }
  }
}

// From properties of a known kind to those they are related to.
void Spread(const OwlGraph& graph, Kinds& kinds) {
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> related;
  for (const Statement& s : graph.statements()) {
    const Word predicate = graph.word(s.predicate);
    if (predicate != Word::kRdfsSubPropertyOf && predicate != Word::kOwlEquivalentProperty &&
        predicate != Word::kOwlPropertyDisjointWith) {
      continue;
    }
    related[s.subject].push_back(s.object);
    related[s.object].push_back(s.subject);
  }
  std::deque<std::uint32_t> known;
  for (const auto& [term, others] : related) {
    if ((kinds[term] & kAnyProperty) != 0) known.push_back(term);
  }
  while (!known.empty()) {
    const std::uint32_t term = known.front();
    known.pop_front();
    for (const std::uint32_t other : related[term]) {
      if ((kinds[other] & kAnyProperty) != 0) continue;
      kinds[other] |= kinds[term] & kAnyProperty;
      known.push_back(other);
    }
  }
}

}  // namespace

bool IsDataRange(OwlGraph& graph, const Kinds& kinds, std::uint32_t term) {
  if (graph.IsIri(term)) return (kinds[term] & (kIsDatatype | kIsClass)) == kIsDatatype;
  if (graph.IsLiteral(term)) return false;
  for (const std::uint32_t index : graph.About(term)) {
    const Statement& s = graph.statements()[index];
    switch (graph.word(s.predicate)) {
      case Word::kRdfType:
        if (graph.word(s.object) == Word::kRdfsDatatype ||
            graph.word(s.object) == Word::kOwlDataRange) {
          return true;
        }
        break;
      case Word::kOwlOnDatatype:
      case Word::kOwlDatatypeComplementOf:
        return true;
      default:
        break;
    }
  }
  return false;
}

Kinds FindTermKinds(OwlGraph& graph) {
  Kinds kinds(graph.document().terms.size());
  MarkBuiltIn(graph, kinds);
  MarkTypes(graph, kinds);
  MarkByUse(graph, kinds);
  Spread(graph, kinds);
  return kinds;
}

}  // namespace lares::rdf
