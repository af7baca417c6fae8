#include "ontology/rdf/owl_syntax/owl_graph.h"

#include <optional>
#include <unordered_set>

namespace lares::rdf {
namespace {

// Of a node that is part of an expression, whatever its types.
bool IsStructural(Word predicate) {
  return predicate >= Word::kOwlIntersectionOf && predicate <= Word::kOwlInverseOf;
}

std::optional<BlankRole> RoleOfType(Word type) {
  switch (type) {
    case Word::kOwlAxiom:
    case Word::kOwlAnnotation:
      return BlankRole::kAnnotated;
    case Word::kOwlAllDisjointClasses:
    case Word::kOwlAllDisjointProperties:
    case Word::kOwlAllDifferent:
    case Word::kOwlNegativePropertyAssertion:
      return BlankRole::kAxiom;
    case Word::kOwlOntology:
      return BlankRole::kOntology;
    case Word::kOwlClass:
    case Word::kOwlRestriction:
    case Word::kOwlDataRange:
    case Word::kRdfsDatatype:
      return BlankRole::kExpression;
    case Word::kRdfList:
      return BlankRole::kList;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::size_t OwlGraph::TripleHash::operator()(const Statement& s) const {
  std::size_t hash = s.subject;
  hash = hash * 0x9E3779B97F4A7C15ull + s.predicate;
  hash = (hash ^ (hash >> 29)) * 0xBF58476D1CE4E5B9ull + s.object;
  return hash ^ (hash >> 32);
}

OwlGraph::OwlGraph(const Document& document) : document_(document) {
  words_.reserve(document.terms.size());
  for (const Term& term : document.terms) {
    words_.push_back(term.kind == TermKind::kIri ? WordOf(term.value) : Word::kNone);
  }
  CollectStatements();
  IndexBySubject();
  FindRoles();
  FindAnnotated();
  used_.resize(statements_.size());
  budget_ = 16 * statements_.size() + 4096;
}

void OwlGraph::CollectStatements() {
  std::unordered_set<Statement, TripleHash, TripleEqual> seen;
  seen.reserve(document_.statements.size());
  for (const Statement& statement : document_.statements) {
    if (statement.graph != Statement::kDefaultGraph) continue;
    if (seen.insert(statement).second) statements_.push_back(statement);
  }
}

void OwlGraph::IndexBySubject() {
  ends_.assign(document_.terms.size() + 1, 0);
  for (const Statement& statement : statements_) ++ends_[statement.subject + 1];
  for (std::size_t i = 1; i < ends_.size(); ++i) ends_[i] += ends_[i - 1];
  about_.resize(statements_.size());
  std::vector<std::uint32_t> next(ends_.begin(), ends_.end() - 1);
  for (std::uint32_t i = 0; i < statements_.size(); ++i) {
    about_[next[statements_[i].subject]++] = i;
  }
}

void OwlGraph::FindRoles() {
  roles_.assign(document_.terms.size(), BlankRole::kIndividual);
  for (const Statement& statement : statements_) {
    if (!IsBlank(statement.subject)) continue;
    const Word predicate = word(statement.predicate);
    BlankRole& role = roles_[statement.subject];
    if (predicate == Word::kRdfType) {
      // A list may be typed too, and says so better by its parts.
      if (const auto told = RoleOfType(word(statement.object))) role = *told;
    } else if (IsStructural(predicate)) {
      role = BlankRole::kExpression;
    } else if (predicate == Word::kRdfFirst || predicate == Word::kRdfRest) {
      role = BlankRole::kList;
    }
  }
}

void OwlGraph::FindAnnotated() {
  for (std::uint32_t node = 0; node + 1 < ends_.size(); ++node) {
    if (!IsBlank(node) || role(node) != BlankRole::kAnnotated) continue;
    Statement triple;
    int sources = 0, properties = 0, targets = 0;
    Word kind = Word::kNone;
    for (std::uint32_t i = ends_[node]; i < ends_[node + 1]; ++i) {
      const Statement& statement = statements_[about_[i]];
      switch (word(statement.predicate)) {
        case Word::kOwlAnnotatedSource:
          triple.subject = statement.object;
          ++sources;
          break;
        case Word::kOwlAnnotatedProperty:
          triple.predicate = statement.object;
          ++properties;
          break;
        case Word::kOwlAnnotatedTarget:
          triple.object = statement.object;
          ++targets;
          break;
        case Word::kRdfType:
          kind = word(statement.object);
          break;
        default:
          break;
      }
    }
    if (sources != 1 || properties != 1 || targets != 1) continue;
    (kind == Word::kOwlAxiom ? annotated_axioms_ : annotated_annotations_)[triple].push_back(node);
  }
}

std::span<const std::uint32_t> OwlGraph::About(std::uint32_t subject) {
  const std::size_t count = ends_[subject + 1] - ends_[subject];
  if (count + 1 > budget_) {
    budget_ = 0;
    throw Unwritable{"expressions are shared so often that writing them out is too long"};
  }
  budget_ -= count + 1;
  return {about_.data() + ends_[subject], count};
}

const std::vector<std::uint32_t>& OwlGraph::AnnotatedBy(const Statement& triple, Word kind) const {
  static const std::vector<std::uint32_t> kNobody;
  const Annotated& annotated = kind == Word::kOwlAxiom ? annotated_axioms_ : annotated_annotations_;
  const auto found = annotated.find(triple);
  return found == annotated.end() ? kNobody : found->second;
}

void OwlGraph::Commit() {
  for (const std::uint32_t statement : pending_) used_[statement] = true;
  pending_.clear();
}

}  // namespace lares::rdf
