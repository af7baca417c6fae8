// A document's statements as the reverse mapping walks them: each once, by subject, with a mark for
// those that an axiom has used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "ontology/rdf/document.h"
#include "ontology/rdf/owl_syntax/words.h"

namespace lares::rdf {

// Why a triple is no part of an axiom. Never leaves the folder.
struct Unwritable {
  std::string why;
};

// What the statements about a blank node make it.
enum class BlankRole : std::uint8_t {
  kIndividual,
  kExpression,  // of a class, data range or property
  kList,
  kAnnotated,  // owl:Axiom, owl:Annotation
  kAxiom,      // owl:AllDisjointClasses and the like
  kOntology,
};

class OwlGraph {
 public:
  // `document` outlives this. Statements in named graphs are not looked at.
  explicit OwlGraph(const Document& document);

  const Document& document() const { return document_; }
  const std::vector<Statement>& statements() const { return statements_; }
  // Indices into statements(), in their order. Counts against the budget: throws Unwritable when
  // expressions that share nodes would make the whole many times larger than the document.
  std::span<const std::uint32_t> About(std::uint32_t subject);

  const Term& term(std::uint32_t index) const { return document_.terms[index]; }
  Word word(std::uint32_t index) const { return words_[index]; }
  bool IsIri(std::uint32_t index) const { return term(index).kind == TermKind::kIri; }
  bool IsBlank(std::uint32_t index) const { return term(index).kind == TermKind::kBlank; }
  bool IsLiteral(std::uint32_t index) const { return term(index).kind == TermKind::kLiteral; }
  BlankRole role(std::uint32_t blank) const { return roles_[blank]; }

  // The nodes that say owl:annotatedSource and so on of this triple and have the type `kind`
  // (kOwlAxiom or kOwlAnnotation).
  const std::vector<std::uint32_t>& AnnotatedBy(const Statement& triple, Word kind) const;

  // Marks are kept only by Commit().
  void Use(std::uint32_t statement) { pending_.push_back(statement); }
  void Commit();
  void Rollback() { pending_.clear(); }
  bool IsUsed(std::uint32_t statement) const { return used_[statement]; }

 private:
  struct TripleHash {
    std::size_t operator()(const Statement& s) const;
  };
  struct TripleEqual {
    bool operator()(const Statement& a, const Statement& b) const {
      return a.subject == b.subject && a.predicate == b.predicate && a.object == b.object;
    }
  };
  using Annotated =
      std::unordered_map<Statement, std::vector<std::uint32_t>, TripleHash, TripleEqual>;

  void CollectStatements();
  void IndexBySubject();
  void FindRoles();
  void FindAnnotated();

  const Document& document_;
  std::vector<Statement> statements_;
  std::vector<Word> words_;          // by term
  std::vector<BlankRole> roles_;     // by term
  std::vector<std::uint32_t> ends_;  // by term: where its statements end in about_
  std::vector<std::uint32_t> about_;
  Annotated annotated_axioms_, annotated_annotations_;
  std::vector<bool> used_;
  std::vector<std::uint32_t> pending_;
  std::size_t budget_ = 0;
};

}  // namespace lares::rdf
