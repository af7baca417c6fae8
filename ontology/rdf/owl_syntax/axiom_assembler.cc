#include "ontology/rdf/owl_syntax/axiom_assembler.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "ontology/rdf/position.h"
#include "ontology/rdf/term_checks.h"

namespace lares::rdf {
namespace {

using enum Construct;
using Kind = OwlNode::Kind;

// Trees are walked by recursion.
constexpr int kDeepest = 1000;

bool IsEntity(const OwlNode& node, Construct entity) {
  return node.kind == Kind::kIri && (node.construct == kNone || node.construct == entity);
}

bool HasCategory(const OwlNode& node, Category category) {
  return node.kind == Kind::kConstruct && InfoOf(node.construct).category == category;
}

bool IsConstruct(const OwlNode& node, Construct construct) {
  return node.kind == Kind::kConstruct && node.construct == construct;
}

bool Fits(const OwlNode& node, char role) {
  switch (role) {
    case 'C':
      return IsEntity(node, kClass) || HasCategory(node, Category::kClass);
    case 'P':
      return IsEntity(node, kObjectProperty) || IsConstruct(node, kObjectInverseOf);
    case 'X':
      return Fits(node, 'P') || IsConstruct(node, kObjectPropertyChain);
    case 'D':
      return IsEntity(node, kDataProperty);
    case 'R':
      return IsEntity(node, kDatatype) || HasCategory(node, Category::kDataRange);
    case 'A':
      return IsEntity(node, kAnnotationProperty);
    case 'I':
      return IsEntity(node, kNamedIndividual) || node.kind == Kind::kBlank;
    case 'L':
      return node.kind == Kind::kLiteral;
    case 'n':
      return node.kind == Kind::kNumber;
    case 'U':
      return IsEntity(node, kNone);
    case 'S':
      return IsEntity(node, kNone) || node.kind == Kind::kBlank;
    case 'V':
      return Fits(node, 'S') || node.kind == Kind::kLiteral;
    case 'E':
      return HasCategory(node, Category::kEntity);
    case 'c':
      return IsEntity(node, kClass);
    case 'p':
      return IsEntity(node, kObjectProperty);
    case 't':
      return IsEntity(node, kDatatype);
    case 'F':
      return IsConstruct(node, kFacetRestriction);
    case 'k':
      return IsConstruct(node, kObjectProperties);
    default:
      return IsConstruct(node, kDataProperties);
  }
}

std::string DescribeNode(const OwlNode& node) {
  switch (node.kind) {
    case Kind::kConstruct:
      return std::string(InfoOf(node.construct).name);
    case Kind::kIri:
      if (node.construct != kNone) return std::string(InfoOf(node.construct).name);
      return "an IRI";
    case Kind::kBlank:
      return "an anonymous individual";
    case Kind::kLiteral:
      return "a literal";
    case Kind::kNumber:
      return "a number";
  }
  return {};
}

// "2 arguments", "at least 2 arguments", "2 or 3 arguments".
std::string DescribeCount(std::string_view roles) {
  const bool is_open = roles.find_first_of("+*") != std::string_view::npos;
  const bool is_optional = roles.find('?') != std::string_view::npos;
  const auto letters = std::count_if(roles.begin(), roles.end(),
                                     [](char c) { return c != '+' && c != '*' && c != '?'; });
  const auto least = letters - (roles.find('*') != std::string_view::npos || is_optional ? 1 : 0);
  std::string text = is_open ? "at least " : "";
  text += std::to_string(least);
  if (is_optional) text += " or " + std::to_string(least + 1);
  return text + (least == 1 && !is_optional ? " argument" : " arguments");
}

bool IsAnnotation(const OwlNode& node) { return IsConstruct(node, kAnnotation); }

bool TakesAnnotations(const OwlNode& node) {
  const Category category = InfoOf(node.construct).category;
  return category == Category::kAxiom || category == Category::kAnnotation;
}

}  // namespace

void AxiomAssembler::Refuse(const std::string& message, const SourcePoint& point) const {
  throw Error(Code::kInvalid, message, place_of_(point));
}

void AxiomAssembler::Open(std::string_view name, SourcePoint point) {
  if (const auto construct = ConstructNamed(name)) return Open(*construct, point);
  std::vector<std::string> names;
  for (int i = 0; i < static_cast<int>(kNone); ++i) {
    const ConstructInfo& info = InfoOf(static_cast<Construct>(i));
    if (info.category != Category::kGroup) names.emplace_back(info.name);
  }
  Error error(Code::kInvalid, Quoted(name) + " is no construct of OWL 2", place_of_(point));
  const std::vector<std::string> similar = SimilarNames(name, names);
  if (!similar.empty()) error.WithHint("did you mean " + Join(similar, " or ") + "?");
  throw error;
}

void AxiomAssembler::Open(Construct construct, SourcePoint point) {
  const ConstructInfo& info = InfoOf(construct);
  if (open_.empty() && info.category != Category::kAxiom && construct != kAnnotation) {
    Refuse("expected an axiom, not " + std::string(info.name), point);
  }
  if (open_.size() >= static_cast<std::size_t>(std::min(options_.max_depth, kDeepest))) {
    throw Error(
        Code::kTooLarge,
        "constructs nest deeper than " + std::to_string(std::min(options_.max_depth, kDeepest)),
        place_of_(point));
  }
  OwlNode node = OwlNode::Of(construct, {});
  node.point = point;
  open_.push_back(std::move(node));
}

void AxiomAssembler::Add(OwlNode leaf) {
  if (open_.empty()) Refuse("expected an axiom, not " + DescribeNode(leaf), leaf.point);
  open_.back().arguments.push_back(std::move(leaf));
}

void AxiomAssembler::Close() {
  OwlNode node = std::move(open_.back());
  open_.pop_back();
  Regroup(node);
  CheckArguments(node);
  Attach(std::move(node));
}

void AxiomAssembler::Attach(OwlNode node) {
  if (open_.empty()) return Say(node);
  OwlNode& parent = open_.back();
  if (!IsAnnotation(node)) {
    parent.arguments.push_back(std::move(node));
    return;
  }
  if (!TakesAnnotations(parent)) {
    Refuse(std::string(InfoOf(parent.construct).name) + " takes no annotation", node.point);
  }
  if (!parent.arguments.empty()) {
    Refuse("annotations come before the arguments of " + std::string(InfoOf(parent.construct).name),
           node.point);
  }
  parent.annotations.push_back(std::move(node));
}

void AxiomAssembler::Say(const OwlNode& node) {
  try {
    if (IsAnnotation(node)) {
      rdf_.OntologyAnnotation(node);
    } else {
      rdf_.Axiom(node);
    }
  } catch (const Error& error) {
    throw WithPlace(error, place_of_(node.point));
  }
}

// Facets in pairs (functional syntax writes them flat) and the properties of a key in two lists
// (OWL/XML writes them flat).
void AxiomAssembler::Regroup(OwlNode& node) const {
  std::vector<OwlNode>& arguments = node.arguments;
  if (node.construct == kDatatypeRestriction && arguments.size() > 1 &&
      arguments[1].kind != Kind::kConstruct) {
    std::vector<OwlNode> grouped;
    grouped.push_back(std::move(arguments[0]));
    for (std::size_t i = 1; i < arguments.size(); i += 2) {
      OwlNode facet = OwlNode::Of(kFacetRestriction, {});
      facet.point = arguments[i].point;
      facet.arguments.push_back(std::move(arguments[i]));
      if (i + 1 < arguments.size()) facet.arguments.push_back(std::move(arguments[i + 1]));
      CheckArguments(facet);
      grouped.push_back(std::move(facet));
    }
    arguments = std::move(grouped);
  } else if (node.construct == kHasKey && arguments.size() > 1) {
    const auto is_flat = [](const OwlNode& argument) {
      return argument.construct == kObjectInverseOf ||
             (argument.kind == Kind::kIri && argument.construct != kNone);
    };
    if (!std::all_of(arguments.begin() + 1, arguments.end(), is_flat)) return;
    std::vector<OwlNode> grouped = {std::move(arguments[0]), OwlNode::Of(kObjectProperties, {}),
                                    OwlNode::Of(kDataProperties, {})};
    for (std::size_t i = 1; i < arguments.size(); ++i) {
      const std::size_t group = arguments[i].construct == kDataProperty ? 2 : 1;
      grouped[group].arguments.push_back(std::move(arguments[i]));
    }
    for (const OwlNode& group : grouped) {
      if (HasCategory(group, Category::kGroup)) CheckArguments(group);
    }
    arguments = std::move(grouped);
  }
}

void AxiomAssembler::CheckArguments(const OwlNode& node) const {
  const ConstructInfo& info = InfoOf(node.construct);
  const auto roles = RolesFor(info, node.arguments.size());
  const std::size_t checked =
      std::min(node.arguments.size(), roles ? roles->size() : std::size_t{0});
  for (std::size_t i = 0; i < checked; ++i) {
    if (Fits(node.arguments[i], (*roles)[i])) continue;
    Refuse("expected " + std::string(DescribeRole((*roles)[i])) + " in " + std::string(info.name) +
               ", not " + DescribeNode(node.arguments[i]),
           node.arguments[i].point);
  }
  if (!roles) {
    Refuse(std::string(info.name) + " has " + DescribeCount(info.roles) + ", not " +
               std::to_string(node.arguments.size()),
           node.point);
  }
  if (node.construct == kHasKey && node.arguments[1].arguments.empty() &&
      node.arguments[2].arguments.empty()) {
    Refuse("HasKey names no property", node.point);
  }
}

}  // namespace lares::rdf
