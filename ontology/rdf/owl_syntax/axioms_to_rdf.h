// OWL 2 axioms as triples (Mapping to RDF Graphs, section 2).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ontology/rdf/document_builder.h"
#include "ontology/rdf/owl_syntax/owl_node.h"

namespace lares::rdf {

// Takes trees whose arguments fit their constructs and whose terms are those of `builder`.
class AxiomsToRdf {
 public:
  explicit AxiomsToRdf(DocumentBuilder& builder) : builder_(builder) {}

  // The document's own: `iri` and `version` are terms.
  void NamelessOntology();
  void Ontology(std::uint32_t iri);
  void Version(std::uint32_t version);
  void Import(std::uint32_t iri);
  void OntologyAnnotation(const OwlNode& annotation);
  // A label of the text as a term; never one of those that this class makes up.
  std::uint32_t Blank(std::string_view label);
  // A literal with rdf:PlainLiteral's "text@tag" taken apart.
  std::uint32_t Literal(std::string_view lexical, std::string_view datatype,
                        std::string_view language);
  void Axiom(const OwlNode& axiom);

 private:
  struct Triple {
    std::uint32_t subject, predicate, object;
  };

  std::uint32_t Iri(Word word);
  std::uint32_t Fresh();
  std::uint32_t TypedNode(Word type);
  Triple Say(std::uint32_t subject, std::uint32_t predicate, std::uint32_t object);
  Triple Say(std::uint32_t subject, Word predicate, std::uint32_t object);
  // The term that stands for an expression; its triples are said.
  std::uint32_t NodeOf(const OwlNode& node);
  std::uint32_t Expression(const OwlNode& node, const ConstructInfo& info);
  std::uint32_t Restriction(const OwlNode& node, const ConstructInfo& info);
  std::uint32_t Cardinality(const OwlNode& node, const ConstructInfo& info);
  std::uint32_t RestrictedDatatype(const OwlNode& node);
  std::uint32_t ListOf(const std::vector<OwlNode>& nodes, std::size_t begin, std::size_t end);
  std::uint32_t ListOf(const std::vector<std::uint32_t>& items);
  void SpecialAxiom(const OwlNode& axiom, const ConstructInfo& info);
  void PropertyAssertion(const OwlNode& axiom);
  void NegativeAssertion(const OwlNode& axiom, const ConstructInfo& info);
  void Key(const OwlNode& axiom);
  // As of the axiom that `triple` alone is.
  void Main(const Triple& triple, const OwlNode& axiom);
  void Annotate(const Triple& triple, const std::vector<OwlNode>& annotations, Word kind);
  void AnnotateNode(std::uint32_t subject, const std::vector<OwlNode>& annotations);

  DocumentBuilder& builder_;
  std::array<std::uint32_t, static_cast<std::size_t>(Word::kCount)> words_{};  // term + 1
  std::uint32_t ontology_ = 0;
  std::size_t made_up_ = 0;
};

}  // namespace lares::rdf
