#include "reasoner/profile/document_index.h"

#include <algorithm>
#include <set>

#include "ontology/rdf/vocabulary.h"

namespace lares::profile {
namespace {

std::string WordOf(const rdf::Term& term) {
  if (term.kind != rdf::TermKind::kIri) return {};
  const std::pair<std::string_view, std::string_view> kSpaces[] = {
      {rdf::kRdf, "rdf:"}, {rdf::kRdfs, "rdfs:"}, {rdf::kOwl, "owl:"}, {rdf::kXsd, "xsd:"}};
  for (const auto& [space, prefix] : kSpaces) {
    if (term.value.starts_with(space)) return std::string(prefix) + term.value.substr(space.size());
  }
  return {};
}

// OWL 2 Profiles, 4.2.1.
constexpr std::string_view kDatatypes[] = {"rdfs:Literal",
                                           "rdf:PlainLiteral",
                                           "rdf:XMLLiteral",
                                           "rdf:langString",
                                           "xsd:decimal",
                                           "xsd:integer",
                                           "xsd:string",
                                           "xsd:nonNegativeInteger",
                                           "xsd:nonPositiveInteger",
                                           "xsd:positiveInteger",
                                           "xsd:long",
                                           "xsd:negativeInteger",
                                           "xsd:int",
                                           "xsd:short",
                                           "xsd:byte",
                                           "xsd:unsignedLong",
                                           "xsd:unsignedInt",
                                           "xsd:unsignedShort",
                                           "xsd:boolean",
                                           "xsd:unsignedByte",
                                           "xsd:float",
                                           "xsd:double",
                                           "xsd:token",
                                           "xsd:normalizedString",
                                           "xsd:language",
                                           "xsd:Name",
                                           "xsd:NCName",
                                           "xsd:NMTOKEN",
                                           "xsd:hexBinary",
                                           "xsd:base64Binary",
                                           "xsd:anyURI",
                                           "xsd:dateTime",
                                           "xsd:dateTimeStamp"};
constexpr std::string_view kOtherDatatypes[] = {"owl:real", "owl:rational"};

// RDF 1.1, RDF Schema 1.1 and OWL 2 RDF-Based Semantics (tables 3.1–3.3), with OWL 1's two.
constexpr std::string_view kWords[] = {
    "rdf:type",
    "rdf:Property",
    "rdf:List",
    "rdf:first",
    "rdf:rest",
    "rdf:nil",
    "rdf:value",
    "rdf:subject",
    "rdf:predicate",
    "rdf:object",
    "rdf:Statement",
    "rdf:Seq",
    "rdf:Bag",
    "rdf:Alt",
    "rdf:HTML",
    "rdf:JSON",
    "rdf:langRange",
    "rdfs:Resource",
    "rdfs:Class",
    "rdfs:Datatype",
    "rdfs:Container",
    "rdfs:ContainerMembershipProperty",
    "rdfs:member",
    "rdfs:label",
    "rdfs:comment",
    "rdfs:seeAlso",
    "rdfs:isDefinedBy",
    "rdfs:subClassOf",
    "rdfs:subPropertyOf",
    "rdfs:domain",
    "rdfs:range",
    "owl:AllDifferent",
    "owl:AllDisjointClasses",
    "owl:AllDisjointProperties",
    "owl:Annotation",
    "owl:AnnotationProperty",
    "owl:AsymmetricProperty",
    "owl:Axiom",
    "owl:Class",
    "owl:DataRange",
    "owl:DatatypeProperty",
    "owl:DeprecatedClass",
    "owl:DeprecatedProperty",
    "owl:FunctionalProperty",
    "owl:InverseFunctionalProperty",
    "owl:IrreflexiveProperty",
    "owl:NamedIndividual",
    "owl:NegativePropertyAssertion",
    "owl:Nothing",
    "owl:ObjectProperty",
    "owl:Ontology",
    "owl:OntologyProperty",
    "owl:ReflexiveProperty",
    "owl:Restriction",
    "owl:SymmetricProperty",
    "owl:Thing",
    "owl:TransitiveProperty",
    "owl:allValuesFrom",
    "owl:annotatedProperty",
    "owl:annotatedSource",
    "owl:annotatedTarget",
    "owl:assertionProperty",
    "owl:backwardCompatibleWith",
    "owl:bottomDataProperty",
    "owl:bottomObjectProperty",
    "owl:cardinality",
    "owl:complementOf",
    "owl:datatypeComplementOf",
    "owl:deprecated",
    "owl:differentFrom",
    "owl:disjointUnionOf",
    "owl:disjointWith",
    "owl:distinctMembers",
    "owl:equivalentClass",
    "owl:equivalentProperty",
    "owl:hasKey",
    "owl:hasSelf",
    "owl:hasValue",
    "owl:imports",
    "owl:incompatibleWith",
    "owl:intersectionOf",
    "owl:inverseOf",
    "owl:maxCardinality",
    "owl:maxQualifiedCardinality",
    "owl:members",
    "owl:minCardinality",
    "owl:minQualifiedCardinality",
    "owl:onClass",
    "owl:onDataRange",
    "owl:onDatatype",
    "owl:onProperties",
    "owl:onProperty",
    "owl:oneOf",
    "owl:priorVersion",
    "owl:propertyChainAxiom",
    "owl:propertyDisjointWith",
    "owl:qualifiedCardinality",
    "owl:sameAs",
    "owl:someValuesFrom",
    "owl:sourceIndividual",
    "owl:targetIndividual",
    "owl:targetValue",
    "owl:topDataProperty",
    "owl:topObjectProperty",
    "owl:unionOf",
    "owl:versionIRI",
    "owl:versionInfo",
    "owl:withRestrictions",
};

}  // namespace

const std::vector<std::string>& KnownWords() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> all;
    all.insert(all.end(), std::begin(kWords), std::end(kWords));
    all.insert(all.end(), std::begin(kDatatypes), std::end(kDatatypes));
    all.insert(all.end(), std::begin(kOtherDatatypes), std::end(kOtherDatatypes));
    std::sort(all.begin(), all.end());
    return all;
  }();
  return words;
}

// XSD has further datatypes and facets, and RDF numbers its members: rdf:_1, rdf:_2, …
bool IsKnownWord(std::string_view word) {
  if (word.starts_with("xsd:") || word.starts_with("rdf:_")) return true;
  return std::binary_search(KnownWords().begin(), KnownWords().end(), word);
}

bool IsRlDatatype(std::string_view word) {
  return std::find(std::begin(kDatatypes), std::end(kDatatypes), word) != std::end(kDatatypes);
}

bool IsDatatypeWord(std::string_view word) {
  return word.starts_with("xsd:") || IsRlDatatype(word) || word == "owl:real" ||
         word == "owl:rational" || word == "rdf:JSON" || word == "rdf:HTML";
}

DocumentIndex::DocumentIndex(const rdf::Document& document) : document_(document) {
  words_.reserve(document.terms.size());
  for (const rdf::Term& term : document.terms) words_.push_back(WordOf(term));
  begins_.resize(document.terms.size() + 1);
  for (const rdf::Statement& statement : document.statements) ++begins_[statement.subject + 1];
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  by_subject_.resize(document.statements.size());
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  for (std::uint32_t i = 0; i < document.statements.size(); ++i) {
    by_subject_[next[document.statements[i].subject]++] = i;
  }
}

std::span<const std::uint32_t> DocumentIndex::About(std::uint32_t subject) const {
  return std::span(by_subject_).subspan(begins_[subject], begins_[subject + 1] - begins_[subject]);
}

std::vector<std::uint32_t> DocumentIndex::About(std::uint32_t subject,
                                                std::string_view word) const {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t index : About(subject)) {
    if (Word(Statement(index).predicate) == word) found.push_back(index);
  }
  return found;
}

std::optional<std::uint32_t> DocumentIndex::Object(std::uint32_t subject,
                                                   std::string_view word) const {
  for (const std::uint32_t index : About(subject)) {
    if (Word(Statement(index).predicate) == word) return Statement(index).object;
  }
  return std::nullopt;
}

bool DocumentIndex::HasType(std::uint32_t subject, std::string_view word) const {
  for (const std::uint32_t index : About(subject)) {
    const rdf::Statement& statement = Statement(index);
    if (Word(statement.predicate) == "rdf:type" && Word(statement.object) == word) return true;
  }
  return false;
}

std::optional<std::vector<std::uint32_t>> DocumentIndex::List(std::uint32_t head) const {
  std::vector<std::uint32_t> members;
  std::set<std::uint32_t> seen;
  while (Word(head) != "rdf:nil") {
    const auto first = About(head, "rdf:first");
    const auto rest = About(head, "rdf:rest");
    if (first.size() != 1 || rest.size() != 1 || !seen.insert(head).second) return std::nullopt;
    members.push_back(Statement(first[0]).object);
    head = Statement(rest[0]).object;
  }
  return members;
}

}  // namespace lares::profile
