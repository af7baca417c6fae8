#include "ontology/rdf/owl_syntax/axioms_to_rdf.h"

#include <string>

namespace lares::rdf {
namespace {

using enum Construct;
constexpr std::string_view kMadeUp = "genid";

// Of a cardinality with a filler.
Word Qualified(Word predicate) {
  switch (predicate) {
    case Word::kOwlMinCardinality:
      return Word::kOwlMinQualifiedCardinality;
    case Word::kOwlMaxCardinality:
      return Word::kOwlMaxQualifiedCardinality;
    default:
      return Word::kOwlQualifiedCardinality;
  }
}

}  // namespace

std::uint32_t AxiomsToRdf::Iri(Word word) {
  std::uint32_t& known = words_[static_cast<std::size_t>(word)];
  if (known == 0) known = builder_.Intern({TermKind::kIri, IriOf(word), {}, {}}) + 1;
  return known - 1;
}

std::uint32_t AxiomsToRdf::Fresh() {
  const std::string label = std::string(kMadeUp) + std::to_string(++made_up_);
  return builder_.Intern({TermKind::kBlank, label, {}, {}});
}

std::uint32_t AxiomsToRdf::Blank(std::string_view label) {
  const std::size_t start = label.find_first_not_of('L');
  if (start == std::string_view::npos || !label.substr(start).starts_with(kMadeUp)) {
    return builder_.Intern({TermKind::kBlank, label, {}, {}});
  }
  return builder_.Intern({TermKind::kBlank, "L" + std::string(label), {}, {}});
}

std::uint32_t AxiomsToRdf::Literal(std::string_view lexical, std::string_view datatype,
                                   std::string_view language) {
  if (datatype == IriOf(Word::kRdfPlainLiteral)) {
    datatype = {};
    if (const std::size_t at = lexical.rfind('@'); at != std::string_view::npos) {
      language = lexical.substr(at + 1);
      lexical = lexical.substr(0, at);
    }
  }
  return builder_.Intern({TermKind::kLiteral, lexical, datatype, language});
}

std::uint32_t AxiomsToRdf::TypedNode(Word type) {
  const std::uint32_t node = Fresh();
  Say(node, Word::kRdfType, Iri(type));
  return node;
}

AxiomsToRdf::Triple AxiomsToRdf::Say(std::uint32_t subject, std::uint32_t predicate,
                                     std::uint32_t object) {
  builder_.Add({subject, predicate, object, Statement::kDefaultGraph});
  return {subject, predicate, object};
}

AxiomsToRdf::Triple AxiomsToRdf::Say(std::uint32_t subject, Word predicate, std::uint32_t object) {
  return Say(subject, Iri(predicate), object);
}

void AxiomsToRdf::NamelessOntology() { ontology_ = TypedNode(Word::kOwlOntology); }

void AxiomsToRdf::Ontology(std::uint32_t iri) {
  ontology_ = iri;
  Say(iri, Word::kRdfType, Iri(Word::kOwlOntology));
}

void AxiomsToRdf::Version(std::uint32_t version) { Say(ontology_, Word::kOwlVersionIRI, version); }

void AxiomsToRdf::Import(std::uint32_t iri) { Say(ontology_, Word::kOwlImports, iri); }

void AxiomsToRdf::OntologyAnnotation(const OwlNode& annotation) {
  AnnotateNode(ontology_, {annotation});
}

// --- expressions ---

std::uint32_t AxiomsToRdf::NodeOf(const OwlNode& node) {
  if (node.kind != OwlNode::Kind::kConstruct) return node.term;
  return Expression(node, InfoOf(node.construct));
}

std::uint32_t AxiomsToRdf::Expression(const OwlNode& node, const ConstructInfo& info) {
  switch (info.shape) {
    case Shape::kList: {
      const std::uint32_t head = ListOf(node.arguments, 0, node.arguments.size());
      return Say(TypedNode(info.type), info.predicate, head).subject;
    }
    case Shape::kComplement: {
      const std::uint32_t inner = NodeOf(node.arguments[0]);
      return Say(TypedNode(info.type), info.predicate, inner).subject;
    }
    case Shape::kRestriction:
      return Restriction(node, info);
    case Shape::kCardinality:
      return Cardinality(node, info);
    default:
      break;
  }
  switch (node.construct) {
    case kObjectInverseOf: {
      const std::uint32_t property = NodeOf(node.arguments[0]);
      return Say(Fresh(), Word::kOwlInverseOf, property).subject;
    }
    case kObjectPropertyChain:
      return ListOf(node.arguments, 0, node.arguments.size());
    case kObjectHasSelf: {
      const std::uint32_t property = NodeOf(node.arguments[0]);
      const std::uint32_t restriction = TypedNode(Word::kOwlRestriction);
      Say(restriction, Word::kOwlOnProperty, property);
      const std::uint32_t yes =
          builder_.Intern({TermKind::kLiteral, "true", IriOf(Word::kXsdBoolean), {}});
      return Say(restriction, Word::kOwlHasSelf, yes).subject;
    }
    case kDatatypeRestriction:
      return RestrictedDatatype(node);
    default:
      throw Error(Code::kInternal, "no expression: " + std::string(info.name));
  }
}

std::uint32_t AxiomsToRdf::Restriction(const OwlNode& node, const ConstructInfo& info) {
  const std::size_t properties = node.arguments.size() - 1;
  const std::uint32_t filler = NodeOf(node.arguments.back());
  const std::uint32_t on =
      properties == 1 ? NodeOf(node.arguments[0]) : ListOf(node.arguments, 0, properties);
  const std::uint32_t restriction = TypedNode(info.type);
  Say(restriction, properties == 1 ? Word::kOwlOnProperty : Word::kOwlOnProperties, on);
  return Say(restriction, info.predicate, filler).subject;
}

std::uint32_t AxiomsToRdf::Cardinality(const OwlNode& node, const ConstructInfo& info) {
  const bool is_qualified = node.arguments.size() == 3;
  const bool is_data = info.roles[1] == 'D';
  const std::uint32_t property = NodeOf(node.arguments[1]);
  const std::uint32_t filler = is_qualified ? NodeOf(node.arguments[2]) : 0;
  const std::uint32_t restriction = TypedNode(info.type);
  Say(restriction, Word::kOwlOnProperty, property);
  Say(restriction, is_qualified ? Qualified(info.predicate) : info.predicate,
      node.arguments[0].term);
  if (is_qualified) {
    Say(restriction, is_data ? Word::kOwlOnDataRange : Word::kOwlOnClass, filler);
  }
  return restriction;
}

std::uint32_t AxiomsToRdf::RestrictedDatatype(const OwlNode& node) {
  std::vector<std::uint32_t> facets;
  for (std::size_t i = 1; i < node.arguments.size(); ++i) {
    const OwlNode& facet = node.arguments[i];
    facets.push_back(Fresh());
    Say(facets.back(), facet.arguments[0].term, facet.arguments[1].term);
  }
  const std::uint32_t list = ListOf(facets);
  const std::uint32_t range = TypedNode(Word::kRdfsDatatype);
  Say(range, Word::kOwlOnDatatype, NodeOf(node.arguments[0]));
  return Say(range, Word::kOwlWithRestrictions, list).subject;
}

std::uint32_t AxiomsToRdf::ListOf(const std::vector<OwlNode>& nodes, std::size_t begin,
                                  std::size_t end) {
  std::vector<std::uint32_t> items;
  items.reserve(end - begin);
  for (std::size_t i = begin; i < end; ++i) items.push_back(NodeOf(nodes[i]));
  return ListOf(items);
}

std::uint32_t AxiomsToRdf::ListOf(const std::vector<std::uint32_t>& items) {
  if (items.empty()) return Iri(Word::kRdfNil);
  const std::uint32_t head = Fresh();
  std::uint32_t cell = head;
  for (std::size_t i = 0; i < items.size(); ++i) {
    Say(cell, Word::kRdfFirst, items[i]);
    const std::uint32_t next = i + 1 < items.size() ? Fresh() : Iri(Word::kRdfNil);
    Say(cell, Word::kRdfRest, next);
    cell = next;
  }
  return head;
}

// --- axioms ---

void AxiomsToRdf::Axiom(const OwlNode& axiom) {
  const ConstructInfo& info = InfoOf(axiom.construct);
  const std::vector<OwlNode>& arguments = axiom.arguments;
  switch (info.shape) {
    case Shape::kTriple: {
      const std::uint32_t subject = NodeOf(arguments[0]);
      return Main(Say(subject, info.predicate, NodeOf(arguments[1])), axiom);
    }
    case Shape::kType:
      return Main(Say(NodeOf(arguments[0]), Word::kRdfType, Iri(info.type)), axiom);
    case Shape::kPairOrAll:
      if (arguments.size() > 2) {
        const std::uint32_t members = ListOf(arguments, 0, arguments.size());
        const std::uint32_t node = TypedNode(info.type);
        Say(node, Word::kOwlMembers, members);
        return AnnotateNode(node, axiom.annotations);
      }
      [[fallthrough]];
    case Shape::kPairs: {
      std::uint32_t previous = NodeOf(arguments[0]);
      for (std::size_t i = 1; i < arguments.size(); ++i) {
        const std::uint32_t next = NodeOf(arguments[i]);
        Main(Say(previous, info.predicate, next), axiom);
        previous = next;
      }
      return;
    }
    default:
      return SpecialAxiom(axiom, info);
  }
}

void AxiomsToRdf::SpecialAxiom(const OwlNode& axiom, const ConstructInfo& info) {
  const std::vector<OwlNode>& arguments = axiom.arguments;
  switch (axiom.construct) {
    case kDeclaration: {
      const OwlNode& entity = arguments[0];
      const Word type = InfoOf(entity.construct).type;
      return Main(Say(entity.arguments[0].term, Word::kRdfType, Iri(type)), axiom);
    }
    case kClassAssertion: {
      const std::uint32_t type = NodeOf(arguments[0]);
      return Main(Say(arguments[1].term, Word::kRdfType, type), axiom);
    }
    case kDisjointUnion: {
      const std::uint32_t parts = ListOf(arguments, 1, arguments.size());
      return Main(Say(arguments[0].term, info.predicate, parts), axiom);
    }
    case kSubObjectPropertyOf: {
      const std::uint32_t lower = NodeOf(arguments[0]);
      const std::uint32_t upper = NodeOf(arguments[1]);
      if (arguments[0].construct == kObjectPropertyChain) {
        return Main(Say(upper, Word::kOwlPropertyChainAxiom, lower), axiom);
      }
      return Main(Say(lower, info.predicate, upper), axiom);
    }
    case kHasKey:
      return Key(axiom);
    case kObjectPropertyAssertion:
    case kDataPropertyAssertion:
    case kAnnotationAssertion:
      return PropertyAssertion(axiom);
    case kNegativeObjectPropertyAssertion:
    case kNegativeDataPropertyAssertion:
      return NegativeAssertion(axiom, info);
    default:
      throw Error(Code::kInternal, "no axiom: " + std::string(info.name));
  }
}

void AxiomsToRdf::PropertyAssertion(const OwlNode& axiom) {
  const OwlNode& property = axiom.arguments[0];
  std::uint32_t subject = axiom.arguments[1].term;
  std::uint32_t object = axiom.arguments[2].term;
  if (property.construct == kObjectInverseOf) {
    std::swap(subject, object);
    return Main(Say(subject, property.arguments[0].term, object), axiom);
  }
  Main(Say(subject, property.term, object), axiom);
}

void AxiomsToRdf::NegativeAssertion(const OwlNode& axiom, const ConstructInfo& info) {
  const std::uint32_t property = NodeOf(axiom.arguments[0]);
  const std::uint32_t node = TypedNode(info.type);
  Say(node, Word::kOwlSourceIndividual, axiom.arguments[1].term);
  Say(node, Word::kOwlAssertionProperty, property);
  Say(node, info.predicate, axiom.arguments[2].term);
  AnnotateNode(node, axiom.annotations);
}

void AxiomsToRdf::Key(const OwlNode& axiom) {
  const std::uint32_t subject = NodeOf(axiom.arguments[0]);
  std::vector<std::uint32_t> properties;
  for (const std::size_t group : {1u, 2u}) {
    for (const OwlNode& property : axiom.arguments[group].arguments) {
      properties.push_back(NodeOf(property));
    }
  }
  Main(Say(subject, Word::kOwlHasKey, ListOf(properties)), axiom);
}

// --- annotations (2.2 and 2.3) ---

void AxiomsToRdf::Main(const Triple& triple, const OwlNode& axiom) {
  Annotate(triple, axiom.annotations, Word::kOwlAxiom);
}

void AxiomsToRdf::Annotate(const Triple& triple, const std::vector<OwlNode>& annotations,
                           Word kind) {
  if (annotations.empty()) return;
  const std::uint32_t node = TypedNode(kind);
  Say(node, Word::kOwlAnnotatedSource, triple.subject);
  Say(node, Word::kOwlAnnotatedProperty, triple.predicate);
  Say(node, Word::kOwlAnnotatedTarget, triple.object);
  AnnotateNode(node, annotations);
}

void AxiomsToRdf::AnnotateNode(std::uint32_t subject, const std::vector<OwlNode>& annotations) {
  for (const OwlNode& annotation : annotations) {
    const Triple triple = Say(subject, annotation.arguments[0].term, annotation.arguments[1].term);
    Annotate(triple, annotation.annotations, Word::kOwlAnnotation);
  }
}

}  // namespace lares::rdf
