#include "ontology/rdf/owl_syntax/constructs.h"

#include <array>
#include <unordered_map>

namespace lares::rdf {
namespace {

using enum Construct;

constexpr std::array<ConstructInfo, static_cast<std::size_t>(kNone)> kTable = {{
    {kClass, "Class", Category::kEntity, "U", Shape::kSpecial, Word::kNone, Word::kOwlClass},
    {kDatatype, "Datatype", Category::kEntity, "U", Shape::kSpecial, Word::kNone,
     Word::kRdfsDatatype},
    {kObjectProperty, "ObjectProperty", Category::kEntity, "U", Shape::kSpecial, Word::kNone,
     Word::kOwlObjectProperty},
    {kDataProperty, "DataProperty", Category::kEntity, "U", Shape::kSpecial, Word::kNone,
     Word::kOwlDatatypeProperty},
    {kAnnotationProperty, "AnnotationProperty", Category::kEntity, "U", Shape::kSpecial,
     Word::kNone, Word::kOwlAnnotationProperty},
    {kNamedIndividual, "NamedIndividual", Category::kEntity, "U", Shape::kSpecial, Word::kNone,
     Word::kOwlNamedIndividual},
    {kAnnotation, "Annotation", Category::kAnnotation, "AV", Shape::kSpecial, Word::kNone,
     Word::kNone},
    {kObjectInverseOf, "ObjectInverseOf", Category::kProperty, "p", Shape::kSpecial,
     Word::kOwlInverseOf, Word::kNone},
    {kObjectPropertyChain, "ObjectPropertyChain", Category::kChain, "PP+", Shape::kSpecial,
     Word::kNone, Word::kNone},
    {kFacetRestriction, "FacetRestriction", Category::kFacet, "UL", Shape::kSpecial, Word::kNone,
     Word::kNone},
    {kObjectProperties, "ObjectProperties", Category::kGroup, "P*", Shape::kSpecial, Word::kNone,
     Word::kNone},
    {kDataProperties, "DataProperties", Category::kGroup, "D*", Shape::kSpecial, Word::kNone,
     Word::kNone},
    {kObjectIntersectionOf, "ObjectIntersectionOf", Category::kClass, "CC+", Shape::kList,
     Word::kOwlIntersectionOf, Word::kOwlClass},
    {kObjectUnionOf, "ObjectUnionOf", Category::kClass, "CC+", Shape::kList, Word::kOwlUnionOf,
     Word::kOwlClass},
    {kObjectComplementOf, "ObjectComplementOf", Category::kClass, "C", Shape::kComplement,
     Word::kOwlComplementOf, Word::kOwlClass},
    {kObjectOneOf, "ObjectOneOf", Category::kClass, "I+", Shape::kList, Word::kOwlOneOf,
     Word::kOwlClass},
    {kObjectSomeValuesFrom, "ObjectSomeValuesFrom", Category::kClass, "PC", Shape::kRestriction,
     Word::kOwlSomeValuesFrom, Word::kOwlRestriction},
    {kObjectAllValuesFrom, "ObjectAllValuesFrom", Category::kClass, "PC", Shape::kRestriction,
     Word::kOwlAllValuesFrom, Word::kOwlRestriction},
    {kObjectHasValue, "ObjectHasValue", Category::kClass, "PI", Shape::kRestriction,
     Word::kOwlHasValue, Word::kOwlRestriction},
    {kObjectHasSelf, "ObjectHasSelf", Category::kClass, "P", Shape::kSpecial, Word::kOwlHasSelf,
     Word::kOwlRestriction},
    {kObjectMinCardinality, "ObjectMinCardinality", Category::kClass, "nPC?", Shape::kCardinality,
     Word::kOwlMinCardinality, Word::kOwlRestriction},
    {kObjectMaxCardinality, "ObjectMaxCardinality", Category::kClass, "nPC?", Shape::kCardinality,
     Word::kOwlMaxCardinality, Word::kOwlRestriction},
    {kObjectExactCardinality, "ObjectExactCardinality", Category::kClass, "nPC?",
     Shape::kCardinality, Word::kOwlCardinality, Word::kOwlRestriction},
    {kDataSomeValuesFrom, "DataSomeValuesFrom", Category::kClass, "D+R", Shape::kRestriction,
     Word::kOwlSomeValuesFrom, Word::kOwlRestriction},
    {kDataAllValuesFrom, "DataAllValuesFrom", Category::kClass, "D+R", Shape::kRestriction,
     Word::kOwlAllValuesFrom, Word::kOwlRestriction},
    {kDataHasValue, "DataHasValue", Category::kClass, "DL", Shape::kRestriction, Word::kOwlHasValue,
     Word::kOwlRestriction},
    {kDataMinCardinality, "DataMinCardinality", Category::kClass, "nDR?", Shape::kCardinality,
     Word::kOwlMinCardinality, Word::kOwlRestriction},
    {kDataMaxCardinality, "DataMaxCardinality", Category::kClass, "nDR?", Shape::kCardinality,
     Word::kOwlMaxCardinality, Word::kOwlRestriction},
    {kDataExactCardinality, "DataExactCardinality", Category::kClass, "nDR?", Shape::kCardinality,
     Word::kOwlCardinality, Word::kOwlRestriction},
    {kDataIntersectionOf, "DataIntersectionOf", Category::kDataRange, "RR+", Shape::kList,
     Word::kOwlIntersectionOf, Word::kRdfsDatatype},
    {kDataUnionOf, "DataUnionOf", Category::kDataRange, "RR+", Shape::kList, Word::kOwlUnionOf,
     Word::kRdfsDatatype},
    {kDataComplementOf, "DataComplementOf", Category::kDataRange, "R", Shape::kComplement,
     Word::kOwlDatatypeComplementOf, Word::kRdfsDatatype},
    {kDataOneOf, "DataOneOf", Category::kDataRange, "L+", Shape::kList, Word::kOwlOneOf,
     Word::kRdfsDatatype},
    {kDatatypeRestriction, "DatatypeRestriction", Category::kDataRange, "tF+", Shape::kSpecial,
     Word::kOwlOnDatatype, Word::kRdfsDatatype},
    {kDeclaration, "Declaration", Category::kAxiom, "E", Shape::kSpecial, Word::kNone, Word::kNone},
    {kSubClassOf, "SubClassOf", Category::kAxiom, "CC", Shape::kTriple, Word::kRdfsSubClassOf,
     Word::kNone},
    {kEquivalentClasses, "EquivalentClasses", Category::kAxiom, "CC+", Shape::kPairs,
     Word::kOwlEquivalentClass, Word::kNone},
    {kDisjointClasses, "DisjointClasses", Category::kAxiom, "CC+", Shape::kPairOrAll,
     Word::kOwlDisjointWith, Word::kOwlAllDisjointClasses},
    {kDisjointUnion, "DisjointUnion", Category::kAxiom, "cCC+", Shape::kSpecial,
     Word::kOwlDisjointUnionOf, Word::kNone},
    {kSubObjectPropertyOf, "SubObjectPropertyOf", Category::kAxiom, "XP", Shape::kSpecial,
     Word::kRdfsSubPropertyOf, Word::kNone},
    {kEquivalentObjectProperties, "EquivalentObjectProperties", Category::kAxiom, "PP+",
     Shape::kPairs, Word::kOwlEquivalentProperty, Word::kNone},
    {kDisjointObjectProperties, "DisjointObjectProperties", Category::kAxiom, "PP+",
     Shape::kPairOrAll, Word::kOwlPropertyDisjointWith, Word::kOwlAllDisjointProperties},
    {kObjectPropertyDomain, "ObjectPropertyDomain", Category::kAxiom, "PC", Shape::kTriple,
     Word::kRdfsDomain, Word::kNone},
    {kObjectPropertyRange, "ObjectPropertyRange", Category::kAxiom, "PC", Shape::kTriple,
     Word::kRdfsRange, Word::kNone},
    {kInverseObjectProperties, "InverseObjectProperties", Category::kAxiom, "PP", Shape::kTriple,
     Word::kOwlInverseOf, Word::kNone},
    {kFunctionalObjectProperty, "FunctionalObjectProperty", Category::kAxiom, "P", Shape::kType,
     Word::kNone, Word::kOwlFunctionalProperty},
    {kInverseFunctionalObjectProperty, "InverseFunctionalObjectProperty", Category::kAxiom, "P",
     Shape::kType, Word::kNone, Word::kOwlInverseFunctionalProperty},
    {kReflexiveObjectProperty, "ReflexiveObjectProperty", Category::kAxiom, "P", Shape::kType,
     Word::kNone, Word::kOwlReflexiveProperty},
    {kIrreflexiveObjectProperty, "IrreflexiveObjectProperty", Category::kAxiom, "P", Shape::kType,
     Word::kNone, Word::kOwlIrreflexiveProperty},
    {kSymmetricObjectProperty, "SymmetricObjectProperty", Category::kAxiom, "P", Shape::kType,
     Word::kNone, Word::kOwlSymmetricProperty},
    {kAsymmetricObjectProperty, "AsymmetricObjectProperty", Category::kAxiom, "P", Shape::kType,
     Word::kNone, Word::kOwlAsymmetricProperty},
    {kTransitiveObjectProperty, "TransitiveObjectProperty", Category::kAxiom, "P", Shape::kType,
     Word::kNone, Word::kOwlTransitiveProperty},
    {kSubDataPropertyOf, "SubDataPropertyOf", Category::kAxiom, "DD", Shape::kTriple,
     Word::kRdfsSubPropertyOf, Word::kNone},
    {kEquivalentDataProperties, "EquivalentDataProperties", Category::kAxiom, "DD+", Shape::kPairs,
     Word::kOwlEquivalentProperty, Word::kNone},
    {kDisjointDataProperties, "DisjointDataProperties", Category::kAxiom, "DD+", Shape::kPairOrAll,
     Word::kOwlPropertyDisjointWith, Word::kOwlAllDisjointProperties},
    {kDataPropertyDomain, "DataPropertyDomain", Category::kAxiom, "DC", Shape::kTriple,
     Word::kRdfsDomain, Word::kNone},
    {kDataPropertyRange, "DataPropertyRange", Category::kAxiom, "DR", Shape::kTriple,
     Word::kRdfsRange, Word::kNone},
    {kFunctionalDataProperty, "FunctionalDataProperty", Category::kAxiom, "D", Shape::kType,
     Word::kNone, Word::kOwlFunctionalProperty},
    {kDatatypeDefinition, "DatatypeDefinition", Category::kAxiom, "tR", Shape::kTriple,
     Word::kOwlEquivalentClass, Word::kNone},
    {kHasKey, "HasKey", Category::kAxiom, "CkK", Shape::kSpecial, Word::kOwlHasKey, Word::kNone},
    {kSameIndividual, "SameIndividual", Category::kAxiom, "II+", Shape::kPairs, Word::kOwlSameAs,
     Word::kNone},
    {kDifferentIndividuals, "DifferentIndividuals", Category::kAxiom, "II+", Shape::kPairOrAll,
     Word::kOwlDifferentFrom, Word::kOwlAllDifferent},
    {kClassAssertion, "ClassAssertion", Category::kAxiom, "CI", Shape::kSpecial, Word::kRdfType,
     Word::kNone},
    {kObjectPropertyAssertion, "ObjectPropertyAssertion", Category::kAxiom, "PII", Shape::kSpecial,
     Word::kNone, Word::kNone},
    {kNegativeObjectPropertyAssertion, "NegativeObjectPropertyAssertion", Category::kAxiom, "PII",
     Shape::kSpecial, Word::kOwlTargetIndividual, Word::kOwlNegativePropertyAssertion},
    {kDataPropertyAssertion, "DataPropertyAssertion", Category::kAxiom, "DIL", Shape::kSpecial,
     Word::kNone, Word::kNone},
    {kNegativeDataPropertyAssertion, "NegativeDataPropertyAssertion", Category::kAxiom, "DIL",
     Shape::kSpecial, Word::kOwlTargetValue, Word::kOwlNegativePropertyAssertion},
    {kAnnotationAssertion, "AnnotationAssertion", Category::kAxiom, "ASV", Shape::kSpecial,
     Word::kNone, Word::kNone},
    {kSubAnnotationPropertyOf, "SubAnnotationPropertyOf", Category::kAxiom, "AA", Shape::kTriple,
     Word::kRdfsSubPropertyOf, Word::kNone},
    {kAnnotationPropertyDomain, "AnnotationPropertyDomain", Category::kAxiom, "AU", Shape::kTriple,
     Word::kRdfsDomain, Word::kNone},
    {kAnnotationPropertyRange, "AnnotationPropertyRange", Category::kAxiom, "AU", Shape::kTriple,
     Word::kRdfsRange, Word::kNone},
}};

constexpr bool AreInOrder() {
  for (std::size_t i = 0; i < kTable.size(); ++i) {
    if (kTable[i].construct != static_cast<Construct>(i)) return false;
  }
  return true;
}
static_assert(AreInOrder());

bool IsMark(char c) { return c == '?' || c == '*' || c == '+'; }

}  // namespace

const ConstructInfo& InfoOf(Construct construct) {
  return kTable[static_cast<std::size_t>(construct)];
}

std::optional<Construct> ConstructNamed(std::string_view name) {
  static const auto* const kNames = [] {
    auto* names = new std::unordered_map<std::string_view, Construct>;
    for (const ConstructInfo& info : kTable) {
      if (info.category != Category::kGroup) names->emplace(info.name, info.construct);
    }
    return names;
  }();
  const auto found = kNames->find(name);
  if (found == kNames->end()) return std::nullopt;
  return found->second;
}

std::string_view DescribeRole(char role) {
  switch (role) {
    case 'C':
      return "a class expression";
    case 'P':
      return "an object property expression";
    case 'D':
      return "a data property";
    case 'A':
      return "an annotation property";
    case 'R':
      return "a data range";
    case 'I':
      return "an individual";
    case 'L':
      return "a literal";
    case 'n':
      return "a number";
    case 'U':
      return "an IRI";
    case 'S':
      return "an IRI or an anonymous individual";
    case 'V':
      return "an IRI, an anonymous individual or a literal";
    case 'E':
      return "an entity such as Class(…)";
    case 'c':
      return "a class";
    case 'p':
      return "an object property";
    case 't':
      return "a datatype";
    case 'F':
      return "a facet and its value";
    case 'X':
      return "an object property expression or a chain of them";
    default:
      return "a list of properties";
  }
}

std::optional<std::string> RolesFor(const ConstructInfo& info, std::size_t count) {
  std::size_t fixed = 0;
  char mark = 0;
  for (const char c : info.roles) {
    if (IsMark(c)) {
      mark = c;
    } else {
      ++fixed;
    }
  }
  if (mark != 0) --fixed;
  if (count < fixed) return std::nullopt;
  const std::size_t repeats = count - fixed;
  if ((mark == 0 && repeats != 0) || (mark == '?' && repeats > 1) || (mark == '+' && repeats < 1)) {
    return std::nullopt;
  }
  std::string roles;
  roles.reserve(count);
  for (std::size_t i = 0; i < info.roles.size(); ++i) {
    if (IsMark(info.roles[i])) continue;
    const bool repeated = i + 1 < info.roles.size() && IsMark(info.roles[i + 1]);
    roles.append(repeated ? repeats : 1, info.roles[i]);
  }
  return roles;
}

std::optional<Construct> FindConstruct(Shape shape, Word predicate, Word type, char role) {
  for (const ConstructInfo& info : kTable) {
    if (info.shape == shape && info.predicate == predicate && info.type == type &&
        info.roles.find(role) != std::string_view::npos) {
      return info.construct;
    }
  }
  return std::nullopt;
}

}  // namespace lares::rdf
