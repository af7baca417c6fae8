#include "ontology/rdf/owl_syntax/rdf_to_axioms.h"

#include <map>
#include <utility>

#include "ontology/rdf/owl_syntax/expressions.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

using enum Construct;
using Kind = OwlNode::Kind;
constexpr int kDeepestAnnotation = 200;

[[noreturn]] void Refuse(std::string why) { throw Unwritable{std::move(why)}; }

class AxiomReader {
 public:
  explicit AxiomReader(const Document& document)
      : graph_(document), kinds_(FindTermKinds(graph_)), expressions_(graph_, kinds_) {}

  AxiomsOfDocument Read();

 private:
  void FindOntology();
  void ReadStatement(std::uint32_t index);
  // By the predicate; nothing for a triple that is a part of something else.
  std::optional<OwlNode> AxiomOf(std::uint32_t index);
  std::optional<OwlNode> OfType(std::uint32_t index);
  std::optional<OwlNode> Characteristic(const Statement& s, Word type);
  std::optional<OwlNode> OfNode(const Statement& s, Word type);
  std::optional<OwlNode> OfProperties(const Statement& s, Word predicate);
  std::optional<OwlNode> OfNames(const Statement& s);
  OwlNode EquivalentClasses(const Statement& s);
  OwlNode Domain(const Statement& s);
  OwlNode Range(const Statement& s);
  OwlNode Key(const Statement& s);
  OwlNode Negative(std::uint32_t node);
  OwlNode Members(std::uint32_t node, Word type);
  bool ReadHeader(const Statement& s, std::uint32_t index);

  bool Is(std::uint32_t term, std::uint8_t kind) const { return (kinds_[term] & kind) != 0; }
  bool IsOnlyAnnotation(std::uint32_t property) const {
    return Is(property, kIsAnnotationProperty) &&
           !Is(property, kIsObjectProperty | kIsDataProperty);
  }
  bool IsData(std::uint32_t property) const {
    return Is(property, kIsDataProperty) && !Is(property, kIsObjectProperty);
  }
  // One for each annotated copy of the axiom that `triple` is; one empty one when there is none.
  std::vector<std::vector<OwlNode>> AnnotationSets(const Statement& triple, Word kind, int depth);
  std::vector<OwlNode> AnnotationsOf(std::uint32_t node, int depth);
  OwlNode ValueOf(std::uint32_t term) const;

  OwlGraph graph_;
  std::vector<std::uint8_t> kinds_;
  Expressions expressions_;
  std::optional<std::uint32_t> ontology_;
  // Of an axiom represented by a node: its annotations, set by AxiomOf.
  std::optional<std::vector<OwlNode>> node_annotations_;
  AxiomsOfDocument found_;
};

AxiomsOfDocument AxiomReader::Read() {
  FindOntology();
  std::map<std::uint32_t, std::string> reasons;
  for (std::uint32_t i = 0; i < graph_.statements().size(); ++i) {
    if (graph_.IsUsed(i)) continue;
    try {
      ReadStatement(i);
      graph_.Commit();
    } catch (const Unwritable& unwritable) {
      graph_.Rollback();
      reasons.emplace(i, unwritable.why);
    }
  }
  for (std::uint32_t i = 0; i < graph_.statements().size(); ++i) {
    if (graph_.IsUsed(i)) continue;
    const auto reason = reasons.find(i);
    found_.left_out.push_back({graph_.statements()[i], reason == reasons.end()
                                                           ? "it is part of no axiom"
                                                           : reason->second});
  }
  return std::move(found_);
}

void AxiomReader::FindOntology() {
  for (std::uint32_t i = 0; i < graph_.statements().size(); ++i) {
    const Statement& s = graph_.statements()[i];
    if (graph_.word(s.predicate) != Word::kRdfType || graph_.word(s.object) != Word::kOwlOntology) {
      continue;
    }
    ontology_ = s.subject;
    if (graph_.IsIri(s.subject)) found_.ontology.iri = s.subject;
    graph_.Use(i);
    return graph_.Commit();
  }
}

void AxiomReader::ReadStatement(std::uint32_t index) {
  const Statement& s = graph_.statements()[index];
  if (ReadHeader(s, index)) return;
  node_annotations_.reset();
  auto axiom = AxiomOf(index);
  if (!axiom) return graph_.Rollback();
  graph_.Use(index);
  if (node_annotations_) {
    axiom->annotations = std::move(*node_annotations_);
    found_.ontology.axioms.push_back(std::move(*axiom));
    return;
  }
  std::vector<std::vector<OwlNode>> sets = AnnotationSets(s, Word::kOwlAxiom, 0);
  for (std::vector<OwlNode>& annotations : sets) {
    OwlNode copy = *axiom;
    copy.annotations = std::move(annotations);
    found_.ontology.axioms.push_back(std::move(copy));
  }
}

// Version, imports and annotations of the ontology itself.
bool AxiomReader::ReadHeader(const Statement& s, std::uint32_t index) {
  if (!ontology_ || s.subject != *ontology_) return false;
  const Word predicate = graph_.word(s.predicate);
  if (predicate == Word::kOwlImports || predicate == Word::kOwlVersionIRI) {
    if (!graph_.IsIri(s.object)) Refuse("an ontology imports and is a version of IRIs only");
    if (predicate == Word::kOwlImports) {
      found_.ontology.imports.push_back(s.object);
    } else if (found_.ontology.version || !found_.ontology.iri) {
      Refuse("only an ontology with a name has a version, and only one");
    } else {
      found_.ontology.version = s.object;
    }
    graph_.Use(index);
    return true;
  }
  const bool is_annotation =
      Is(s.predicate, kIsAnnotationProperty) || !IsReserved(graph_.term(s.predicate).value);
  if (!is_annotation || Is(s.predicate, kIsObjectProperty | kIsDataProperty) ||
      !graph_.AnnotatedBy(s, Word::kOwlAxiom).empty()) {
    return false;
  }
  graph_.Use(index);
  for (auto& nested : AnnotationSets(s, Word::kOwlAnnotation, 0)) {
    OwlNode annotation =
        OwlNode::Of(kAnnotation, {expressions_.Entity(s.predicate), ValueOf(s.object)});
    annotation.annotations = std::move(nested);
    found_.ontology.annotations.push_back(std::move(annotation));
  }
  return true;
}

OwlNode AxiomReader::ValueOf(std::uint32_t term) const {
  return graph_.IsLiteral(term) ? expressions_.Literal(term) : expressions_.Individual(term);
}

// --- annotations ---

std::vector<std::vector<OwlNode>> AxiomReader::AnnotationSets(const Statement& triple, Word kind,
                                                              int depth) {
  if (depth > kDeepestAnnotation) Refuse("annotations of annotations nest too deep");
  std::vector<std::vector<OwlNode>> sets;
  for (const std::uint32_t node : graph_.AnnotatedBy(triple, kind)) {
    sets.push_back(AnnotationsOf(node, depth + 1));
    if (sets.back().empty()) Refuse("an annotated axiom without an annotation");
  }
  if (sets.empty()) sets.emplace_back();
  return sets;
}

std::vector<OwlNode> AxiomReader::AnnotationsOf(std::uint32_t node, int depth) {
  std::vector<OwlNode> annotations;
  for (const std::uint32_t index : graph_.About(node)) {
    const Statement& s = graph_.statements()[index];
    const Word predicate = graph_.word(s.predicate);
    const bool is_frame = predicate == Word::kOwlAnnotatedSource ||
                          predicate == Word::kOwlAnnotatedProperty ||
                          predicate == Word::kOwlAnnotatedTarget ||
                          (predicate == Word::kRdfType && IsReserved(graph_.term(s.object).value));
    if (!is_frame && IsReserved(graph_.term(s.predicate).value) &&
        !Is(s.predicate, kIsAnnotationProperty)) {
      continue;  // a part of what is annotated, or nothing
    }
    graph_.Use(index);
    if (is_frame) continue;
    for (auto& nested : AnnotationSets(s, Word::kOwlAnnotation, depth)) {
      OwlNode annotation =
          OwlNode::Of(kAnnotation, {expressions_.Entity(s.predicate), ValueOf(s.object)});
      annotation.annotations = std::move(nested);
      annotations.push_back(std::move(annotation));
    }
  }
  return annotations;
}

// --- axioms ---

std::optional<OwlNode> AxiomReader::AxiomOf(std::uint32_t index) {
  const Statement& s = graph_.statements()[index];
  const Word predicate = graph_.word(s.predicate);
  switch (predicate) {
    case Word::kRdfType:
      return OfType(index);
    case Word::kRdfsSubClassOf:
      return OwlNode::Of(kSubClassOf,
                         {expressions_.Class(s.subject), expressions_.Class(s.object)});
    case Word::kOwlDisjointWith:
      return OwlNode::Of(kDisjointClasses,
                         {expressions_.Class(s.subject), expressions_.Class(s.object)});
    case Word::kOwlEquivalentClass:
      return EquivalentClasses(s);
    case Word::kOwlDisjointUnionOf: {
      std::vector<OwlNode> classes = expressions_.Classes(s.object);
      if (classes.size() < 2) Refuse("a disjoint union of fewer than two classes");
      classes.insert(classes.begin(), expressions_.Entity(s.subject));
      return OwlNode::Of(kDisjointUnion, std::move(classes));
    }
    case Word::kOwlIntersectionOf:
    case Word::kOwlUnionOf:
    case Word::kOwlComplementOf:
    case Word::kOwlOneOf:
      if (!graph_.IsIri(s.subject) || Is(s.subject, kIsDatatype)) return std::nullopt;
      return expressions_.DefinitionOf(s.subject, index);
    case Word::kOwlHasKey:
      return Key(s);
    case Word::kOwlSameAs:
      return OwlNode::Of(kSameIndividual,
                         {expressions_.Individual(s.subject), expressions_.Individual(s.object)});
    case Word::kOwlDifferentFrom:
      return OwlNode::Of(kDifferentIndividuals,
                         {expressions_.Individual(s.subject), expressions_.Individual(s.object)});
    case Word::kRdfsSubPropertyOf:
    case Word::kOwlPropertyChainAxiom:
    case Word::kOwlEquivalentProperty:
    case Word::kOwlPropertyDisjointWith:
    case Word::kOwlInverseOf:
    case Word::kRdfsDomain:
    case Word::kRdfsRange:
      return OfProperties(s, predicate);
    default:
      return OfNames(s);
  }
}

std::optional<OwlNode> AxiomReader::OfType(std::uint32_t index) {
  const Statement& s = graph_.statements()[index];
  const Word type = graph_.word(s.object);
  for (const Construct entity :
       {kClass, kDatatype, kObjectProperty, kDataProperty, kAnnotationProperty, kNamedIndividual}) {
    if (InfoOf(entity).type != type) continue;
    if (!graph_.IsIri(s.subject)) return std::nullopt;
    return OwlNode::Of(kDeclaration, {OwlNode::Of(entity, {expressions_.Entity(s.subject)})});
  }
  if (auto axiom = Characteristic(s, type)) return axiom;
  if (graph_.IsBlank(s.subject) && graph_.role(s.subject) == BlankRole::kAxiom) {
    return OfNode(s, type);
  }
  const bool is_redundant =
      (type == Word::kRdfsClass && Is(s.subject, kIsClass | kIsDatatype)) ||
      (type == Word::kRdfProperty &&
       Is(s.subject, kIsObjectProperty | kIsDataProperty | kIsAnnotationProperty));
  if (is_redundant && graph_.IsIri(s.subject)) {
    graph_.Use(index);
    graph_.Commit();
    return std::nullopt;
  }
  const bool is_class = !graph_.IsIri(s.object) || type == Word::kOwlThing ||
                        type == Word::kOwlNothing || !IsReserved(graph_.term(s.object).value);
  if (!is_class) {
    if (graph_.IsIri(s.subject)) {
      Refuse("<" + graph_.term(s.object).value +
             "> is of the reserved vocabulary and no OWL class");
    }
    return std::nullopt;
  }
  return OwlNode::Of(kClassAssertion,
                     {expressions_.Class(s.object), expressions_.Individual(s.subject)});
}

std::optional<OwlNode> AxiomReader::Characteristic(const Statement& s, Word type) {
  if (type == Word::kOwlFunctionalProperty && IsData(s.subject)) {
    return OwlNode::Of(kFunctionalDataProperty, {expressions_.DataProperty(s.subject)});
  }
  const auto construct = FindConstruct(Shape::kType, Word::kNone, type, 'P');
  if (type == Word::kNone || !construct) return std::nullopt;
  return OwlNode::Of(*construct, {expressions_.ObjectProperty(s.subject)});
}

std::optional<OwlNode> AxiomReader::OfNode(const Statement& s, Word type) {
  OwlNode axiom =
      type == Word::kOwlNegativePropertyAssertion ? Negative(s.subject) : Members(s.subject, type);
  node_annotations_ = AnnotationsOf(s.subject, 1);
  return axiom;
}

OwlNode AxiomReader::Members(std::uint32_t node, Word type) {
  std::optional<std::uint32_t> list;
  for (const std::uint32_t index : graph_.About(node)) {
    const Statement& s = graph_.statements()[index];
    const Word predicate = graph_.word(s.predicate);
    if (predicate != Word::kOwlMembers && predicate != Word::kOwlDistinctMembers) continue;
    if (list) Refuse("an axiom with two lists of members");
    list = s.object;
    graph_.Use(index);
  }
  if (!list) Refuse("an axiom without members");
  std::vector<OwlNode> members;
  Construct construct = kDisjointClasses;
  if (type == Word::kOwlAllDisjointClasses) {
    members = expressions_.Classes(*list);
  } else if (type == Word::kOwlAllDifferent) {
    members = expressions_.Individuals(*list);
    construct = kDifferentIndividuals;
  } else {
    bool are_data = true;
    const std::vector<std::uint32_t> items = expressions_.Items(*list);
    for (const std::uint32_t item : items) are_data = are_data && IsData(item);
    for (const std::uint32_t item : items) {
      members.push_back(are_data ? expressions_.DataProperty(item)
                                 : expressions_.ObjectProperty(item));
    }
    construct = are_data ? kDisjointDataProperties : kDisjointObjectProperties;
  }
  if (members.size() < 2) Refuse("an axiom with fewer than two members");
  return OwlNode::Of(construct, std::move(members));
}

OwlNode AxiomReader::Negative(std::uint32_t node) {
  std::map<Word, std::uint32_t> parts;
  for (const std::uint32_t index : graph_.About(node)) {
    const Statement& s = graph_.statements()[index];
    const Word predicate = graph_.word(s.predicate);
    if (predicate < Word::kOwlSourceIndividual || predicate > Word::kOwlTargetValue) continue;
    if (!parts.emplace(predicate, s.object).second) Refuse("a negative assertion of two things");
    graph_.Use(index);
  }
  const auto get = [&](Word word) {
    const auto part = parts.find(word);
    if (part == parts.end())
      Refuse("a negative assertion lacks <" + std::string(IriOf(word)) + ">");
    return part->second;
  };
  OwlNode source = expressions_.Individual(get(Word::kOwlSourceIndividual));
  const std::uint32_t property = get(Word::kOwlAssertionProperty);
  if (parts.size() != 3) Refuse("a negative assertion of two things");
  if (parts.count(Word::kOwlTargetValue) != 0) {
    return OwlNode::Of(kNegativeDataPropertyAssertion,
                       {expressions_.DataProperty(property), std::move(source),
                        expressions_.Literal(parts[Word::kOwlTargetValue])});
  }
  return OwlNode::Of(kNegativeObjectPropertyAssertion,
                     {expressions_.ObjectProperty(property), std::move(source),
                      expressions_.Individual(get(Word::kOwlTargetIndividual))});
}

OwlNode AxiomReader::EquivalentClasses(const Statement& s) {
  const bool is_datatype = graph_.IsIri(s.subject) && !Is(s.subject, kIsClass) &&
                           (Is(s.subject, kIsDatatype) || expressions_.IsRange(s.object));
  if (is_datatype) {
    return OwlNode::Of(kDatatypeDefinition,
                       {expressions_.Entity(s.subject), expressions_.Range(s.object)});
  }
  std::vector<OwlNode> classes = {expressions_.Class(s.subject), expressions_.Class(s.object)};
  // A chain through an expression is one axiom with more classes: the expression is written once.
  for (std::uint32_t last = s.object; graph_.IsBlank(last);) {
    std::optional<std::uint32_t> next;
    for (const std::uint32_t index : graph_.About(last)) {
      const Statement& more = graph_.statements()[index];
      if (graph_.word(more.predicate) != Word::kOwlEquivalentClass || graph_.IsUsed(index))
        continue;
      if (next || !graph_.AnnotatedBy(more, Word::kOwlAxiom).empty() ||
          !graph_.AnnotatedBy(s, Word::kOwlAxiom).empty()) {
        return OwlNode::Of(kEquivalentClasses, std::move(classes));
      }
      next = index;
    }
    if (!next || graph_.statements()[*next].object == s.object) break;
    graph_.Use(*next);
    last = graph_.statements()[*next].object;
    classes.push_back(expressions_.Class(last));
  }
  return OwlNode::Of(kEquivalentClasses, std::move(classes));
}

std::optional<OwlNode> AxiomReader::OfProperties(const Statement& s, Word predicate) {
  if (predicate == Word::kRdfsDomain) return Domain(s);
  if (predicate == Word::kRdfsRange) return Range(s);
  if (predicate == Word::kOwlInverseOf) {
    if (graph_.IsBlank(s.subject)) return std::nullopt;
    return OwlNode::Of(kInverseObjectProperties, {expressions_.ObjectProperty(s.subject),
                                                  expressions_.ObjectProperty(s.object)});
  }
  if (predicate == Word::kOwlPropertyChainAxiom) {
    std::vector<OwlNode> chain;
    for (const std::uint32_t item : expressions_.Items(s.object)) {
      chain.push_back(expressions_.ObjectProperty(item));
    }
    if (chain.size() < 2) Refuse("a property chain of fewer than two links");
    return OwlNode::Of(kSubObjectPropertyOf, {OwlNode::Of(kObjectPropertyChain, std::move(chain)),
                                              expressions_.ObjectProperty(s.subject)});
  }
  const bool is_sub = predicate == Word::kRdfsSubPropertyOf;
  if (is_sub && IsOnlyAnnotation(s.subject) && IsOnlyAnnotation(s.object)) {
    return OwlNode::Of(kSubAnnotationPropertyOf,
                       {expressions_.Entity(s.subject), expressions_.Entity(s.object)});
  }
  const bool are_data = IsData(s.subject) && IsData(s.object);
  const bool is_equivalent = predicate == Word::kOwlEquivalentProperty;
  const Construct data = is_sub          ? kSubDataPropertyOf
                         : is_equivalent ? kEquivalentDataProperties
                                         : kDisjointDataProperties;
  const Construct object = is_sub          ? kSubObjectPropertyOf
                           : is_equivalent ? kEquivalentObjectProperties
                                           : kDisjointObjectProperties;
  if (are_data) {
    return OwlNode::Of(data,
                       {expressions_.DataProperty(s.subject), expressions_.DataProperty(s.object)});
  }
  return OwlNode::Of(
      object, {expressions_.ObjectProperty(s.subject), expressions_.ObjectProperty(s.object)});
}

OwlNode AxiomReader::Domain(const Statement& s) {
  if (IsOnlyAnnotation(s.subject)) {
    return OwlNode::Of(kAnnotationPropertyDomain,
                       {expressions_.Entity(s.subject), expressions_.Entity(s.object)});
  }
  if (IsData(s.subject)) {
    return OwlNode::Of(kDataPropertyDomain,
                       {expressions_.DataProperty(s.subject), expressions_.Class(s.object)});
  }
  return OwlNode::Of(kObjectPropertyDomain,
                     {expressions_.ObjectProperty(s.subject), expressions_.Class(s.object)});
}

OwlNode AxiomReader::Range(const Statement& s) {
  if (IsOnlyAnnotation(s.subject)) {
    return OwlNode::Of(kAnnotationPropertyRange,
                       {expressions_.Entity(s.subject), expressions_.Entity(s.object)});
  }
  const bool is_data =
      IsData(s.subject) || (Is(s.subject, kIsDataProperty) && expressions_.IsRange(s.object));
  if (is_data) {
    return OwlNode::Of(kDataPropertyRange,
                       {expressions_.DataProperty(s.subject), expressions_.Range(s.object)});
  }
  return OwlNode::Of(kObjectPropertyRange,
                     {expressions_.ObjectProperty(s.subject), expressions_.Class(s.object)});
}

OwlNode AxiomReader::Key(const Statement& s) {
  std::vector<OwlNode> object_properties, data_properties;
  for (const std::uint32_t item : expressions_.Items(s.object)) {
    if (IsData(item)) {
      data_properties.push_back(expressions_.DataProperty(item));
    } else {
      object_properties.push_back(expressions_.ObjectProperty(item));
    }
  }
  if (object_properties.empty() && data_properties.empty()) Refuse("a key without a property");
  return OwlNode::Of(kHasKey, {expressions_.Class(s.subject),
                               OwlNode::Of(kObjectProperties, std::move(object_properties)),
                               OwlNode::Of(kDataProperties, std::move(data_properties))});
}

// Assertions, about individuals or by annotation properties.
std::optional<OwlNode> AxiomReader::OfNames(const Statement& s) {
  const std::string& predicate = graph_.term(s.predicate).value;
  if (graph_.IsBlank(s.subject) &&
      (graph_.role(s.subject) != BlankRole::kIndividual || predicate.starts_with(kXsd))) {
    return std::nullopt;
  }
  const bool is_annotation = Is(s.predicate, kIsAnnotationProperty);
  if (IsReserved(predicate) && !is_annotation && kinds_[s.predicate] == 0) {
    Refuse("<" + predicate + "> is of the reserved vocabulary and no property of an ontology");
  }
  const bool is_literal = graph_.IsLiteral(s.object);
  const bool is_object = Is(s.predicate, kIsObjectProperty);
  const bool is_data = Is(s.predicate, kIsDataProperty);
  const bool is_unknown = !is_annotation && !is_object && !is_data;
  const bool is_of_individual = graph_.IsBlank(s.subject) || Is(s.subject, kIsIndividual);
  if (is_literal ? is_data || (is_unknown && is_of_individual) : false) {
    return OwlNode::Of(kDataPropertyAssertion,
                       {expressions_.DataProperty(s.predicate), expressions_.Individual(s.subject),
                        expressions_.Literal(s.object)});
  }
  if (!is_literal && (is_object || (is_unknown && is_of_individual))) {
    return OwlNode::Of(kObjectPropertyAssertion,
                       {expressions_.ObjectProperty(s.predicate),
                        expressions_.Individual(s.subject), expressions_.Individual(s.object)});
  }
  if (!is_annotation && !is_unknown) {
    Refuse(std::string("the value of ") + (is_object ? "an object" : "a data") +
           " property that is " + (is_literal ? "a literal" : "no literal"));
  }
  return OwlNode::Of(kAnnotationAssertion, {expressions_.Entity(s.predicate),
                                            expressions_.Individual(s.subject), ValueOf(s.object)});
}

}  // namespace

AxiomsOfDocument AxiomsOf(const Document& document) {
  try {
    return AxiomReader(document).Read();
  } catch (const Unwritable& unwritable) {
    throw Error(Code::kTooLarge, unwritable.why);
  }
}

}  // namespace lares::rdf
