#include "ontology/rdf/owl_syntax/expressions.h"

#include <array>
#include <optional>
#include <string>

#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

using enum Construct;
using Kind = OwlNode::Kind;
constexpr int kDeepest = 500;  // by recursion

[[noreturn]] void Refuse(std::string why) { throw Unwritable{std::move(why)}; }

class Deeper {
 public:
  explicit Deeper(int& depth) : depth_(depth) {
    if (++depth_ > kDeepest) {
      --depth_;
      Refuse("an expression nests too deep, or is part of itself");
    }
  }
  ~Deeper() { --depth_; }
  Deeper(const Deeper&) = delete;
  Deeper& operator=(const Deeper&) = delete;

 private:
  int& depth_;
};

bool IsTypeOfExpression(Word type) {
  return type == Word::kOwlClass || type == Word::kOwlRestriction || type == Word::kRdfsClass ||
         type == Word::kRdfsDatatype || type == Word::kOwlDataRange;
}

bool IsCardinalityOf(const Term& term) {
  static constexpr std::array<std::string_view, 4> kIntegers = {"nonNegativeInteger", "integer",
                                                                "int", "positiveInteger"};
  if (term.kind != TermKind::kLiteral || term.value.empty() ||
      term.value.find_first_not_of("0123456789") != std::string::npos ||
      !term.datatype.starts_with(kXsd)) {
    return false;
  }
  const std::string_view type = std::string_view(term.datatype).substr(kXsd.size());
  for (const std::string_view integer : kIntegers) {
    if (type == integer) return true;
  }
  return false;
}

}  // namespace

// The structural triples about one node: each predicate at most once.
struct Expressions::Parts {
  struct Part {
    Word predicate;
    std::uint32_t object, statement;
  };
  std::vector<Part> parts;
  bool is_data = false;  // by its type

  std::optional<std::uint32_t> Find(Word predicate) const {
    for (const Part& part : parts) {
      if (part.predicate == predicate) return part.object;
    }
    return std::nullopt;
  }
  std::uint32_t Get(Word predicate) const {
    if (const auto object = Find(predicate)) return *object;
    Refuse("an expression lacks <" + std::string(IriOf(predicate)) + ">");
  }
  void Use(OwlGraph& graph, Word predicate) const {
    for (const Part& part : parts) {
      if (part.predicate == predicate) graph.Use(part.statement);
    }
  }
};

Expressions::Parts Expressions::PartsOf(std::uint32_t node) {
  if (graph_.role(node) != BlankRole::kExpression) Refuse("a blank node is no class or data range");
  Parts parts;
  for (const std::uint32_t index : graph_.About(node)) {
    const Statement& s = graph_.statements()[index];
    const Word predicate = graph_.word(s.predicate);
    if (predicate == Word::kRdfType) {
      const Word type = graph_.word(s.object);
      if (!IsTypeOfExpression(type)) continue;
      if (type == Word::kRdfsDatatype || type == Word::kOwlDataRange) parts.is_data = true;
      graph_.Use(index);
    } else if (predicate >= Word::kOwlIntersectionOf && predicate <= Word::kOwlWithRestrictions) {
      if (parts.Find(predicate))
        Refuse("an expression has two of <" + std::string(IriOf(predicate)) + ">");
      parts.parts.push_back({predicate, s.object, index});
      graph_.Use(index);
    }
  }
  return parts;
}

OwlNode Expressions::Entity(std::uint32_t term) const {
  if (!graph_.IsIri(term)) Refuse(Quoted(graph_.term(term).value) + " is no IRI");
  return OwlNode::Leaf(Kind::kIri, term);
}

OwlNode Expressions::Literal(std::uint32_t term) const {
  if (!graph_.IsLiteral(term)) Refuse(Quoted(graph_.term(term).value) + " is no literal");
  return OwlNode::Leaf(Kind::kLiteral, term);
}

OwlNode Expressions::Individual(std::uint32_t term) const {
  if (graph_.IsIri(term)) return Entity(term);
  if (graph_.IsLiteral(term)) Refuse(Quoted(graph_.term(term).value) + " is no individual");
  if (graph_.role(term) != BlankRole::kIndividual) Refuse("a blank node is no individual");
  return OwlNode::Leaf(Kind::kBlank, term);
}

OwlNode Expressions::ObjectProperty(std::uint32_t term) {
  if (!graph_.IsBlank(term)) return Entity(term);
  std::optional<std::uint32_t> inverse;
  for (const std::uint32_t index : graph_.About(term)) {
    const Statement& s = graph_.statements()[index];
    const Word predicate = graph_.word(s.predicate);
    if (predicate == Word::kOwlInverseOf) {
      if (inverse) Refuse("a blank node is the inverse of two properties");
      inverse = s.object;
    } else if (predicate != Word::kRdfType || graph_.word(s.object) != Word::kOwlObjectProperty) {
      continue;
    }
    graph_.Use(index);
  }
  if (!inverse) Refuse("a blank node is no property");
  return OwlNode::Of(kObjectInverseOf, {Entity(*inverse)});
}

std::vector<std::uint32_t> Expressions::Items(std::uint32_t list) {
  std::vector<std::uint32_t> items;
  while (graph_.word(list) != Word::kRdfNil) {
    if (!graph_.IsBlank(list)) Refuse("a list does not end with rdf:nil");
    std::optional<std::uint32_t> first, rest;
    for (const std::uint32_t index : graph_.About(list)) {
      const Statement& s = graph_.statements()[index];
      const Word predicate = graph_.word(s.predicate);
      if (predicate == Word::kRdfFirst || predicate == Word::kRdfRest) {
        auto& end = predicate == Word::kRdfFirst ? first : rest;
        if (end) Refuse("a list forks");
        end = s.object;
      } else if (predicate != Word::kRdfType || graph_.word(s.object) != Word::kRdfList) {
        continue;
      }
      graph_.Use(index);
    }
    if (!first || !rest) Refuse("a list breaks off");
    items.push_back(*first);
    if (items.size() > graph_.statements().size()) Refuse("a list runs in a circle");
    list = *rest;
  }
  return items;
}

std::vector<OwlNode> Expressions::Classes(std::uint32_t list) {
  std::vector<OwlNode> classes;
  for (const std::uint32_t item : Items(list)) classes.push_back(Class(item));
  return classes;
}

std::vector<OwlNode> Expressions::Individuals(std::uint32_t list) {
  std::vector<OwlNode> individuals;
  for (const std::uint32_t item : Items(list)) individuals.push_back(Individual(item));
  return individuals;
}

OwlNode Expressions::Class(std::uint32_t term) {
  if (!graph_.IsBlank(term)) return Entity(term);
  const Deeper deeper(depth_);
  Parts parts = PartsOf(term);
  if (parts.is_data) Refuse("a data range where a class has to be");
  if (parts.Find(Word::kOwlOnProperty) || parts.Find(Word::kOwlOnProperties)) {
    return Restriction(parts);
  }
  return Junction(parts, false);
}

OwlNode Expressions::Range(std::uint32_t term) {
  if (!graph_.IsBlank(term)) return Entity(term);
  const Deeper deeper(depth_);
  Parts parts = PartsOf(term);
  if (parts.Find(Word::kOwlOnDatatype)) return RestrictedDatatype(parts);
  return Junction(parts, true);
}

OwlNode Expressions::DefinitionOf(std::uint32_t iri, std::uint32_t statement) {
  const Statement& s = graph_.statements()[statement];
  Parts parts{{{graph_.word(s.predicate), s.object, statement}}, false};
  graph_.Use(statement);
  return OwlNode::Of(kEquivalentClasses, {Entity(iri), Junction(parts, false)});
}

OwlNode Expressions::Junction(Parts& parts, bool is_data) {
  if (parts.parts.size() != 1) Refuse("a blank node is no class or data range of one kind");
  const Word predicate = parts.parts[0].predicate;
  const std::uint32_t object = parts.parts[0].object;
  switch (predicate) {
    case Word::kOwlComplementOf:
      if (is_data) break;
      return OwlNode::Of(kObjectComplementOf, {Class(object)});
    case Word::kOwlDatatypeComplementOf:
      if (!is_data) break;
      return OwlNode::Of(kDataComplementOf, {Range(object)});
    case Word::kOwlIntersectionOf:
    case Word::kOwlUnionOf: {
      std::vector<OwlNode> members;
      for (const std::uint32_t item : Items(object)) {
        members.push_back(is_data ? Range(item) : Class(item));
      }
      // Table 15: of one, the one itself.
      if (members.size() == 1) return std::move(members[0]);
      if (members.empty()) Refuse("an intersection or union of nothing");
      if (predicate == Word::kOwlIntersectionOf) {
        return OwlNode::Of(is_data ? kDataIntersectionOf : kObjectIntersectionOf,
                           std::move(members));
      }
      return OwlNode::Of(is_data ? kDataUnionOf : kObjectUnionOf, std::move(members));
    }
    case Word::kOwlOneOf: {
      std::vector<OwlNode> members;
      for (const std::uint32_t item : Items(object)) {
        members.push_back(is_data ? Literal(item) : Individual(item));
      }
      if (members.empty()) Refuse("an enumeration of nothing");
      return OwlNode::Of(is_data ? kDataOneOf : kObjectOneOf, std::move(members));
    }
    default:
      break;
  }
  Refuse("<" + std::string(IriOf(predicate)) + "> makes no class or data range here");
}

bool Expressions::IsDataProperty(std::uint32_t property, bool by_filler) const {
  if (graph_.IsBlank(property)) return false;
  const std::uint8_t kind = kinds_[property] & (kIsObjectProperty | kIsDataProperty);
  if (kind == kIsObjectProperty) return false;
  return kind == kIsDataProperty || by_filler;
}

OwlNode Expressions::Restriction(Parts& parts) {
  std::vector<std::uint32_t> properties;
  if (const auto list = parts.Find(Word::kOwlOnProperties)) {
    properties = Items(*list);
    if (properties.empty()) Refuse("a restriction on no property");
  } else {
    properties.push_back(parts.Get(Word::kOwlOnProperty));
  }
  for (const Word predicate : {Word::kOwlSomeValuesFrom, Word::kOwlAllValuesFrom}) {
    const auto filler = parts.Find(predicate);
    if (!filler) continue;
    if (parts.parts.size() != 2) Refuse("a restriction of two kinds");
    const bool some = predicate == Word::kOwlSomeValuesFrom;
    const bool is_data = properties.size() > 1 || IsDataProperty(properties[0], IsRange(*filler));
    std::vector<OwlNode> arguments;
    for (const std::uint32_t property : properties) {
      arguments.push_back(is_data ? DataProperty(property) : ObjectProperty(property));
    }
    arguments.push_back(is_data ? Range(*filler) : Class(*filler));
    if (is_data) {
      return OwlNode::Of(some ? kDataSomeValuesFrom : kDataAllValuesFrom, std::move(arguments));
    }
    return OwlNode::Of(some ? kObjectSomeValuesFrom : kObjectAllValuesFrom, std::move(arguments));
  }
  if (properties.size() > 1) Refuse("a restriction on several properties that is none of values");
  const std::uint32_t property = properties[0];
  if (const auto value = parts.Find(Word::kOwlHasValue)) {
    if (parts.parts.size() != 2) Refuse("a restriction of two kinds");
    if (graph_.IsLiteral(*value)) {
      return OwlNode::Of(kDataHasValue, {DataProperty(property), Literal(*value)});
    }
    return OwlNode::Of(kObjectHasValue, {ObjectProperty(property), Individual(*value)});
  }
  if (const auto self = parts.Find(Word::kOwlHasSelf)) {
    const Term& yes = graph_.term(*self);
    if (parts.parts.size() != 2 || yes.kind != TermKind::kLiteral || yes.value != "true") {
      Refuse("owl:hasSelf that is not true");
    }
    return OwlNode::Of(kObjectHasSelf, {ObjectProperty(property)});
  }
  return Cardinality(parts, property);
}

OwlNode Expressions::Cardinality(Parts& parts, std::uint32_t property) {
  struct Row {
    Word plain, qualified;
    Construct object, data;
  };
  static constexpr std::array<Row, 3> kRows = {
      {{Word::kOwlMinCardinality, Word::kOwlMinQualifiedCardinality, kObjectMinCardinality,
        kDataMinCardinality},
       {Word::kOwlMaxCardinality, Word::kOwlMaxQualifiedCardinality, kObjectMaxCardinality,
        kDataMaxCardinality},
       {Word::kOwlCardinality, Word::kOwlQualifiedCardinality, kObjectExactCardinality,
        kDataExactCardinality}}};
  const auto on_class = parts.Find(Word::kOwlOnClass);
  const auto on_range = parts.Find(Word::kOwlOnDataRange);
  for (const Row& row : kRows) {
    const auto plain = parts.Find(row.plain);
    const auto qualified = parts.Find(row.qualified);
    if (!plain && !qualified) continue;
    const std::uint32_t number = plain ? *plain : *qualified;
    if (!IsCardinalityOf(graph_.term(number))) Refuse("a cardinality that is no number");
    if (parts.parts.size() != (plain ? 2u : 3u)) Refuse("a restriction of two kinds");
    if (qualified && !on_class && !on_range) Refuse("a qualified cardinality of nothing");
    const bool is_data = qualified ? on_range.has_value() : IsDataProperty(property, false);
    std::vector<OwlNode> arguments = {OwlNode::Leaf(Kind::kNumber, number)};
    arguments.push_back(is_data ? DataProperty(property) : ObjectProperty(property));
    if (on_class) arguments.push_back(Class(*on_class));
    if (on_range) arguments.push_back(Range(*on_range));
    return OwlNode::Of(is_data ? row.data : row.object, std::move(arguments));
  }
  Refuse("a restriction that restricts nothing");
}

OwlNode Expressions::RestrictedDatatype(Parts& parts) {
  if (parts.parts.size() != 2) Refuse("a restriction of two kinds");
  std::vector<OwlNode> arguments = {Entity(parts.Get(Word::kOwlOnDatatype))};
  for (const std::uint32_t item : Items(parts.Get(Word::kOwlWithRestrictions))) {
    if (!graph_.IsBlank(item)) Refuse("a facet that is no blank node");
    const auto about = graph_.About(item);
    if (about.size() != 1) Refuse("a facet that is not one triple");
    const Statement& s = graph_.statements()[about[0]];
    graph_.Use(about[0]);
    arguments.push_back(OwlNode::Of(kFacetRestriction, {Entity(s.predicate), Literal(s.object)}));
  }
  if (arguments.size() < 2) Refuse("a datatype restricted by no facet");
  return OwlNode::Of(kDatatypeRestriction, std::move(arguments));
}

}  // namespace lares::rdf
