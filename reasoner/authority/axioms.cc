#include "reasoner/authority/axioms.h"

#include <string>

#include "ontology/rdf/vocabulary.h"

namespace lares::authority {

AxiomTable::AxiomTable(rdf::Dictionary& dictionary) : dictionary_(dictionary) {
  const auto rdf_word = [&](const char* word) {
    return dictionary.InternIri(std::string(rdf::kRdf) + word);
  };
  const auto rdfs_word = [&](const char* word) {
    return dictionary.InternIri(std::string(rdf::kRdfs) + word);
  };
  const auto owl_word = [&](const char* word) {
    return dictionary.InternIri(std::string(rdf::kOwl) + word);
  };
  type = rdf_word("type");
  first = rdf_word("first");
  rest = rdf_word("rest");
  nil = rdf_word("nil");
  union_of = owl_word("unionOf");
  thing = owl_word("Thing");
  sub_class_of = rdfs_word("subClassOf");
  on_property = owl_word("onProperty");
  some_values_from = owl_word("someValuesFrom");
  has_value = owl_word("hasValue");
  equivalent_class = owl_word("equivalentClass");
  intersection_of = owl_word("intersectionOf");
  for (const char* word : {"subClassOf", "subPropertyOf", "domain", "range"}) {
    by_predicate_[rdfs_word(word)] = Weight::kSubject;
  }
  // The words of expressions count where their subject has a name: it then means the expression.
  for (const char* word : {"hasKey",
                           "propertyChainAxiom",
                           "intersectionOf",
                           "oneOf",
                           "onProperty",
                           "onProperties",
                           "someValuesFrom",
                           "allValuesFrom",
                           "hasValue",
                           "hasSelf",
                           "cardinality",
                           "minCardinality",
                           "maxCardinality",
                           "qualifiedCardinality",
                           "minQualifiedCardinality",
                           "maxQualifiedCardinality",
                           "onClass",
                           "onDataRange",
                           "onDatatype",
                           "withRestrictions",
                           "datatypeComplementOf"}) {
    by_predicate_[owl_word(word)] = Weight::kSubject;
    expression_parts_.insert(owl_word(word));
  }
  for (const char* word : {"unionOf", "complementOf"}) expression_parts_.insert(owl_word(word));
  for (const char* word : {"equivalentClass", "equivalentProperty", "inverseOf", "sameAs"}) {
    by_predicate_[owl_word(word)] = Weight::kBoth;
  }
  for (const char* word : {"disjointWith", "propertyDisjointWith", "complementOf"}) {
    by_predicate_[owl_word(word)] = Weight::kExclusion;
  }
  by_predicate_[owl_word("members")] = Weight::kMembers;
  for (const char* word : {"unionOf", "disjointUnionOf"}) {
    by_predicate_[owl_word(word)] = Weight::kUnion;
  }
  class_kinds_ = {owl_word("Class"), rdfs_word("Class"), rdfs_word("Datatype"),
                  owl_word("DataRange")};
  property_kinds_ = {owl_word("ObjectProperty"), owl_word("DatatypeProperty"),
                     owl_word("AnnotationProperty"), rdf_word("Property")};
  for (const char* word :
       {"FunctionalProperty", "InverseFunctionalProperty", "TransitiveProperty",
        "SymmetricProperty", "AsymmetricProperty", "ReflexiveProperty", "IrreflexiveProperty"}) {
    characteristics_.insert(owl_word(word));
  }
}

Weight AxiomTable::WeightOf(const rdf::Triple& triple) const {
  if (triple.predicate == type) {
    if (class_kinds_.count(triple.object) + property_kinds_.count(triple.object) != 0) {
      return Weight::kDeclaration;
    }
    return characteristics_.count(triple.object) != 0 ? Weight::kSubject : Weight::kNone;
  }
  const auto found = by_predicate_.find(triple.predicate);
  return found == by_predicate_.end() ? Weight::kNone : found->second;
}

bool AxiomTable::IsBuiltIn(rdf::TermId term) const {
  const rdf::TermView view = dictionary_.Get(term);
  if (view.kind != rdf::TermKind::kIri) return false;
  for (const std::string_view space : {rdf::kRdf, rdf::kRdfs, rdf::kOwl, rdf::kXsd}) {
    if (view.value.starts_with(space)) return true;
  }
  return false;
}

}  // namespace lares::authority
