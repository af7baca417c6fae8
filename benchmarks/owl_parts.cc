#include "benchmarks/owl_parts.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <set>

namespace lares::bench {
namespace {

using rdf::Category;
using rdf::Construct;
using rdf::Document;
using rdf::InfoOf;
using rdf::OwlNode;
using Terms = std::set<std::uint32_t>;

using enum rdf::Construct;

std::string ToText(const Document& document, const OwlNode& node) {
  if (node.kind == OwlNode::Kind::kNumber || node.kind != OwlNode::Kind::kConstruct) {
    return document.terms[node.term].value;
  }
  std::string text(InfoOf(node.construct).name);
  text += '(';
  for (const OwlNode& argument : node.arguments) {
    if (text.back() != '(') text += ' ';
    text += ToText(document, argument);
  }
  return text + ')';
}

// ---- Which kinds of thing a term is -------------------------------------------------------------

// Letters: c class, p object property, D data property, t datatype, i individual.
using Uses = std::map<std::uint32_t, std::set<char>>;

char KindOfRole(char role) {
  switch (role) {
    case 'C':
    case 'c':
      return 'c';
    case 'P':
    case 'p':
    case 'X':
      return 'p';
    case 'D':
      return 'D';
    case 'R':
    case 't':
      return 't';
    case 'I':
      return 'i';
    default:
      return 0;
  }
}

char KindOfEntity(Construct entity) {
  switch (entity) {
    case kClass:
      return 'c';
    case kDatatype:
      return 't';
    case kObjectProperty:
      return 'p';
    case kDataProperty:
      return 'D';
    case kNamedIndividual:
      return 'i';
    default:
      return 0;
  }
}

void Collect(const OwlNode& node, Uses& uses) {
  if (node.kind != OwlNode::Kind::kConstruct) return;
  const auto& info = InfoOf(node.construct);
  const auto roles = RolesFor(info, node.arguments.size());
  for (std::size_t i = 0; i < node.arguments.size(); ++i) {
    const OwlNode& argument = node.arguments[i];
    char kind = roles && i < roles->size() ? KindOfRole((*roles)[i]) : '\0';
    if (node.construct == kDeclaration && argument.kind == OwlNode::Kind::kConstruct) {
      const OwlNode& name = argument.arguments.front();
      if (const char entity = KindOfEntity(argument.construct)) uses[name.term].insert(entity);
      continue;
    }
    if (node.construct == kDeclaration) kind = KindOfEntity(argument.construct);
    if (argument.kind == OwlNode::Kind::kIri && kind != 0) uses[argument.term].insert(kind);
    Collect(argument, uses);
  }
}

bool Mentions(const OwlNode& node, const Terms& terms) {
  if (node.kind != OwlNode::Kind::kConstruct) {
    return node.kind == OwlNode::Kind::kIri && terms.contains(node.term);
  }
  return std::any_of(node.arguments.begin(), node.arguments.end(),
                     [&](const OwlNode& argument) { return Mentions(argument, terms); });
}

// ---- Simple properties --------------------------------------------------------------------------

std::uint32_t PropertyOf(const OwlNode& node) {
  return node.kind == OwlNode::Kind::kConstruct ? PropertyOf(node.arguments.front()) : node.term;
}

// Transitive properties, those with chains, and what is above, beside or inverse to them.
Terms Composite(const std::vector<OwlNode>& axioms) {
  Terms composite;
  for (const OwlNode& axiom : axioms) {
    if (axiom.construct == kTransitiveObjectProperty) {
      composite.insert(PropertyOf(axiom.arguments[0]));
    } else if (axiom.construct == kSubObjectPropertyOf &&
               axiom.arguments[0].construct == kObjectPropertyChain) {
      composite.insert(PropertyOf(axiom.arguments[1]));
    }
  }
  for (std::size_t before = SIZE_MAX; before != composite.size();) {
    before = composite.size();
    for (const OwlNode& axiom : axioms) {
      const bool is_sub = axiom.construct == kSubObjectPropertyOf &&
                          axiom.arguments[0].construct != kObjectPropertyChain;
      const bool is_equal = axiom.construct == kEquivalentObjectProperties ||
                            axiom.construct == kInverseObjectProperties;
      if (is_sub && composite.contains(PropertyOf(axiom.arguments[0]))) {
        composite.insert(PropertyOf(axiom.arguments[1]));
      }
      if (!is_equal) continue;
      const bool any = std::any_of(
          axiom.arguments.begin(), axiom.arguments.end(),
          [&](const OwlNode& argument) { return composite.contains(PropertyOf(argument)); });
      if (!any) continue;
      for (const OwlNode& argument : axiom.arguments) composite.insert(PropertyOf(argument));
    }
  }
  return composite;
}

bool NeedsSimple(Construct construct) {
  return construct == kObjectMinCardinality || construct == kObjectMaxCardinality ||
         construct == kObjectExactCardinality || construct == kObjectHasSelf ||
         construct == kFunctionalObjectProperty || construct == kInverseFunctionalObjectProperty ||
         construct == kIrreflexiveObjectProperty || construct == kAsymmetricObjectProperty ||
         construct == kDisjointObjectProperties;
}

bool MisusesComposite(const OwlNode& node, const Terms& composite) {
  if (node.kind != OwlNode::Kind::kConstruct) return false;
  if (NeedsSimple(node.construct)) {
    const auto roles = RolesFor(InfoOf(node.construct), node.arguments.size());
    for (std::size_t i = 0; roles && i < roles->size(); ++i) {
      if ((*roles)[i] == 'P' && composite.contains(PropertyOf(node.arguments[i]))) return true;
    }
  }
  return std::any_of(node.arguments.begin(), node.arguments.end(), [&](const OwlNode& argument) {
    return MisusesComposite(argument, composite);
  });
}

// ---- OWL 2 RL (OWL 2 Profiles, section 4.2) -----------------------------------------------------

class Rl {
 public:
  explicit Rl(const Document& document) : document_(document) {}

  bool HasAxiom(const OwlNode& axiom) const {
    const auto& a = axiom.arguments;
    const auto all = [&](auto test) { return std::all_of(a.begin(), a.end(), test); };
    const auto is_sub = [&](const OwlNode& node) { return IsSub(node); };
    switch (axiom.construct) {
      case kSubClassOf:
        return IsSub(a[0]) && IsSuper(a[1]);
      case kEquivalentClasses:
        return all([&](const OwlNode& node) { return IsEquivalent(node); });
      case kDisjointClasses:
        return all(is_sub);
      case kObjectPropertyDomain:
      case kObjectPropertyRange:
      case kDataPropertyDomain:
        return IsSuper(a[1]);
      case kDataPropertyRange:
        return IsDatatype(a[1]);
      case kClassAssertion:
        return IsSuper(a[0]);
      case kHasKey:
        return IsSub(a[0]);
      case kDisjointUnion:
      case kReflexiveObjectProperty:
      case kDatatypeDefinition:
        return false;
      default:
        return true;
    }
  }

 private:
  bool IsName(const OwlNode& node) const {
    return node.kind == OwlNode::Kind::kIri &&
           document_.terms[node.term].value != "http://www.w3.org/2002/07/owl#Thing";
  }
  bool IsThing(const OwlNode& node) const {
    return node.kind == OwlNode::Kind::kIri && !IsName(node);
  }
  bool IsDatatype(const OwlNode& node) const {
    if (node.kind == OwlNode::Kind::kIri) {
      const std::string& name = document_.terms[node.term].value;
      return !name.ends_with("#real") && !name.ends_with("#rational");
    }
    return node.construct == kDataIntersectionOf &&
           std::all_of(node.arguments.begin(), node.arguments.end(),
                       [&](const OwlNode& each) { return IsDatatype(each); });
  }

  bool IsSub(const OwlNode& node) const {
    if (node.kind != OwlNode::Kind::kConstruct) return IsName(node);
    const auto& a = node.arguments;
    switch (node.construct) {
      case kObjectOneOf:
      case kObjectHasValue:
      case kDataHasValue:
        return true;
      case kObjectIntersectionOf:
      case kObjectUnionOf:
        return std::all_of(a.begin(), a.end(), [&](const OwlNode& each) { return IsSub(each); });
      case kObjectSomeValuesFrom:
        return IsThing(a[1]) || IsSub(a[1]);
      case kDataSomeValuesFrom:
        return a.size() == 2 && IsDatatype(a[1]);
      default:
        return false;
    }
  }

  bool IsSuper(const OwlNode& node) const {
    if (node.kind != OwlNode::Kind::kConstruct) return IsName(node);
    const auto& a = node.arguments;
    switch (node.construct) {
      case kObjectHasValue:
      case kDataHasValue:
        return true;
      case kObjectIntersectionOf:
        return std::all_of(a.begin(), a.end(), [&](const OwlNode& each) { return IsSuper(each); });
      case kObjectComplementOf:
        return IsSub(a[0]);
      case kObjectAllValuesFrom:
        return IsSuper(a[1]);
      case kDataAllValuesFrom:
        return a.size() == 2 && IsDatatype(a[1]);
      case kObjectMaxCardinality:
        return IsZeroOrOne(a[0]) && (a.size() < 3 || IsThing(a[2]) || IsSub(a[2]));
      case kDataMaxCardinality:
        return IsZeroOrOne(a[0]) && (a.size() < 3 || IsDatatype(a[2]));
      default:
        return false;
    }
  }

  bool IsEquivalent(const OwlNode& node) const {
    if (node.kind != OwlNode::Kind::kConstruct) return IsName(node);
    const auto& a = node.arguments;
    if (node.construct == kObjectHasValue || node.construct == kDataHasValue) return true;
    return node.construct == kObjectIntersectionOf &&
           std::all_of(a.begin(), a.end(), [&](const OwlNode& each) { return IsEquivalent(each); });
  }

  bool IsZeroOrOne(const OwlNode& node) const {
    const std::string& number = document_.terms[node.term].value;
    return number == "0" || number == "1";
  }

  const Document& document_;
};

}  // namespace

OwlParts PartsOf(const Document& document, const std::vector<OwlNode>& axioms) {
  OwlParts parts;
  std::vector<OwlNode> logical;
  Uses uses;
  for (const OwlNode& axiom : axioms) {
    const Construct kind = axiom.construct;
    if (kind == kAnnotationAssertion || kind == kSubAnnotationPropertyOf ||
        kind == kAnnotationPropertyDomain || kind == kAnnotationPropertyRange) {
      continue;
    }
    if (kind == kDeclaration && axiom.arguments[0].construct == kAnnotationProperty) continue;
    Collect(axiom, uses);
    logical.push_back(axiom);
    logical.back().annotations.clear();
  }
  Terms mixed;
  for (const auto& [term, kinds] : uses) {
    if (kinds.size() < 2) continue;
    const bool is_invalid = (kinds.contains('p') && kinds.contains('D')) ||
                            (kinds.contains('c') && kinds.contains('t'));
    if (is_invalid) mixed.insert(term);
    std::string line = document.terms[term].value + " is";
    for (const char kind : kinds) {
      line += kind == 'c'   ? " a class,"
              : kind == 'p' ? " an object property,"
              : kind == 'D' ? " a data property,"
              : kind == 't' ? " a datatype,"
                            : " an individual,";
    }
    line.back() = is_invalid ? '!' : '.';
    parts.punned.push_back(line);
  }
  const Terms composite = Composite(logical);
  const Rl rl(document);
  for (OwlNode& axiom : logical) {
    if (Mentions(axiom, mixed)) {
      parts.not_dl.push_back("of two kinds: " + ToText(document, axiom));
    } else if (MisusesComposite(axiom, composite)) {
      parts.not_dl.push_back("not simple: " + ToText(document, axiom));
    } else {
      if (rl.HasAxiom(axiom)) parts.rl.push_back(axiom);
      parts.dl.push_back(std::move(axiom));
    }
  }
  return parts;
}

}  // namespace lares::bench
