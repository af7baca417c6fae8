#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "ontology/rdf/iri_resolve.h"
#include "ontology/rdf/owl_syntax/axiom_assembler.h"
#include "ontology/rdf/owl_syntax/owl_readers.h"
#include "ontology/rdf/position.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"
#include "ontology/rdf/xml_prescan.h"

namespace lares::rdf {
namespace {

using enum Construct;
using NodeKind = OwlNode::Kind;

bool IsCardinality(Construct construct) { return InfoOf(construct).shape == Shape::kCardinality; }

bool IsEntity(Construct construct) { return InfoOf(construct).category == Category::kEntity; }

// OWL 2 XML Serialization (W3C 2012): elements are constructs and leaves, by their names.
class OwlXmlReader {
 public:
  OwlXmlReader(std::string_view bytes, const ReadOptions& options)
      : bytes_(bytes),
        options_(options),
        builder_(Format::kOwlXml, options),
        axioms_(builder_, options, [this](const SourcePoint& point) { return At(point); }) {
    prefixes_ = {{"rdf", std::string(kRdf)},
                 {"rdfs", std::string(kRdfs)},
                 {"owl", std::string(kOwl)},
                 {"xsd", std::string(kXsd)}};
  }

  Document Read();

 private:
  // What an open element is.
  enum class Open {
    kOntology,
    kConstruct,  // one of the assembler's, closed with the element
    kDeclared,   // Class and the like in Declaration: a construct with its one leaf
    kEmpty,      // a leaf or a prefix, whole with its start tag
    kText,       // Import, IRI, AbbreviatedIRI, Literal: whole with its end tag
    kSkipped,    // a rule, or within one
  };

  void Start(const XmlElement& element);
  void StartOntology(const XmlElement& element);
  Open StartInside(const XmlElement& element);
  void StartText(const XmlElement& element);
  Open StartConstruct(const XmlElement& element);
  Open StartEntity(const XmlElement& element, Construct entity);
  void ReadPrefix(const XmlElement& element);
  void End();
  void EndText();
  void Text(std::string_view piece);

  std::string_view Required(const XmlElement& element, std::string_view name) const;
  std::optional<std::string_view> Attribute(const XmlElement& element, std::string_view name) const;
  // Of the attributes IRI and abbreviatedIRI, one of which there has to be.
  std::uint32_t IriTerm(const XmlElement& element);
  std::string Resolved(std::string_view iri) const;
  std::string Expanded(std::string_view name, const SourcePoint& point) const;
  std::uint32_t Intern(const TermView& term, const SourcePoint& point);
  static SourcePoint PointOf(const XmlElement& element);
  Place At(const SourcePoint& point) const;
  [[noreturn]] void Refuse(const std::string& message, const SourcePoint& point) const {
    throw Error(Code::kInvalid, message, At(point));
  }

  std::string_view bytes_;
  const ReadOptions& options_;
  DocumentBuilder builder_;
  AxiomAssembler axioms_;
  std::map<std::string, std::string, std::less<>> prefixes_;
  std::string base_;
  std::vector<Open> open_;
  SourcePoint point_;  // of the latest start tag
  // Of the element that holds text.
  std::string name_, text_, datatype_, language_;
};

Document OwlXmlReader::Read() {
  base_ = options_.base_iri;
  XmlEvents events{[this](const XmlElement& element) { Start(element); }, [this] { End(); },
                   [this](std::string_view piece) { Text(piece); }};
  XmlSummary summary = CheckXml(bytes_, options_, &events);
  Document document = builder_.Finish();
  document.remarks.insert(document.remarks.begin(), summary.warnings.begin(),
                          summary.warnings.end());
  std::stable_sort(document.remarks.begin(), document.remarks.end(),
                   [](const Remark& a, const Remark& b) { return a.place.line < b.place.line; });
  return document;
}

SourcePoint OwlXmlReader::PointOf(const XmlElement& element) {
  if (element.offset != XmlElement::kNoOffset) return {element.offset};
  return {0, element.place.line, element.place.column};
}

Place OwlXmlReader::At(const SourcePoint& point) const {
  if (point.line > 0) return {options_.source, point.line, point.column};
  return PlaceAt(bytes_, point.offset, options_.source);
}

void OwlXmlReader::Start(const XmlElement& element) {
  point_ = PointOf(element);
  if (!open_.empty() && open_.back() == Open::kSkipped) return open_.push_back(Open::kSkipped);
  if (element.space != kOwl) {
    Refuse("the element " + Quoted(element.name) + " is not of OWL's namespace", point_);
  }
  if (open_.empty()) return StartOntology(element);
  if (open_.back() == Open::kEmpty || open_.back() == Open::kText ||
      open_.back() == Open::kDeclared) {
    Refuse("the element " + Quoted(element.name) + " is no part of OWL/XML here", point_);
  }
  open_.push_back(StartInside(element));
}

void OwlXmlReader::StartOntology(const XmlElement& element) {
  if (element.name != "Ontology") {
    Refuse("expected the element Ontology, not " + Quoted(element.name), point_);
  }
  open_.push_back(Open::kOntology);
  for (const auto& attribute : element.attributes) {
    if (attribute.prefix == "xml" && attribute.name == "base") {
      base_ = Resolved(attribute.value.substr(0, attribute.value.find('#')));
    }
  }
  builder_.document().base_iri = base_;
  const auto iri = Attribute(element, "ontologyIRI");
  if (!iri || iri->empty()) return axioms_.rdf().NamelessOntology();
  axioms_.rdf().Ontology(Intern({TermKind::kIri, Resolved(*iri), {}, {}}, point_));
  if (const auto version = Attribute(element, "versionIRI"); version && !version->empty()) {
    axioms_.rdf().Version(Intern({TermKind::kIri, Resolved(*version), {}, {}}, point_));
  }
}

OwlXmlReader::Open OwlXmlReader::StartInside(const XmlElement& element) {
  const std::string_view name = element.name;
  const bool is_outside = axioms_.depth() == 0;
  if (is_outside && name == "Prefix") {
    ReadPrefix(element);
    return Open::kEmpty;
  }
  if (is_outside && (name == "DLSafeRule" || name == "DescriptionGraphRule")) {
    builder_.document().remarks.push_back(
        {Remark::Kind::kWarning, At(point_),
         "a " + std::string(name) + " is no part of OWL 2 and was left out"});
    return Open::kSkipped;
  }
  const bool is_text =
      name == "IRI" || name == "AbbreviatedIRI" || name == "Literal" || name == "Import";
  if (is_text && is_outside != (name == "Import")) {
    Refuse("the element " + std::string(name) + " in the wrong place", point_);
  }
  if (is_text) {
    StartText(element);
    return Open::kText;
  }
  if (name == "AnonymousIndividual") {
    std::string_view label = Required(element, "nodeID");
    if (label.starts_with("_:")) label.remove_prefix(2);
    if (!IsNodeLabel(label)) Refuse(Quoted(label) + " is no node's label", point_);
    axioms_.Add(OwlNode::Leaf(NodeKind::kBlank, axioms_.rdf().Blank(label), point_));
    return Open::kEmpty;
  }
  return StartConstruct(element);
}

void OwlXmlReader::StartText(const XmlElement& element) {
  name_ = element.name;
  text_.clear();
  datatype_.clear();
  language_.clear();
  if (name_ != "Literal") return;
  language_ = element.language;
  if (const auto datatype = Attribute(element, "datatypeIRI")) datatype_ = Resolved(*datatype);
  // An xml:lang from outside is not meant for typed literals.
  if (!datatype_.empty() && datatype_ != IriOf(Word::kRdfPlainLiteral)) language_.clear();
}

OwlXmlReader::Open OwlXmlReader::StartConstruct(const XmlElement& element) {
  const auto construct = ConstructNamed(element.name);
  if (construct && IsEntity(*construct)) return StartEntity(element, *construct);
  axioms_.Open(element.name, point_);
  if (*construct == kFacetRestriction) {
    const std::string facet = Resolved(Required(element, "facet"));
    axioms_.Add(
        OwlNode::Leaf(NodeKind::kIri, Intern({TermKind::kIri, facet, {}, {}}, point_), point_));
  } else if (IsCardinality(*construct)) {
    const std::string_view number = Trim(Required(element, "cardinality"));
    if (number.empty() || number.find_first_not_of("0123456789") != std::string_view::npos) {
      Refuse("the cardinality " + Quoted(number) + " is no number", point_);
    }
    axioms_.Add(OwlNode::Leaf(
        NodeKind::kNumber,
        Intern({TermKind::kLiteral, number, IriOf(Word::kXsdNonNegativeInteger), {}}, point_),
        point_));
  }
  return Open::kConstruct;
}

OwlXmlReader::Open OwlXmlReader::StartEntity(const XmlElement& element, Construct entity) {
  const std::uint32_t term = IriTerm(element);
  const bool is_declared = axioms_.depth() > 0 && axioms_.top().construct == kDeclaration;
  OwlNode leaf = OwlNode::Leaf(NodeKind::kIri, term, point_);
  if (is_declared) {
    axioms_.Open(entity, point_);
  } else {
    leaf.construct = entity;
  }
  axioms_.Add(std::move(leaf));
  return is_declared ? Open::kDeclared : Open::kEmpty;
}

void OwlXmlReader::ReadPrefix(const XmlElement& element) {
  const std::string prefix(Required(element, "name"));
  const std::string space = Resolved(Required(element, "IRI"));
  if (!IsAbsoluteIri(space)) Refuse("the IRI " + Quoted(space) + " is not absolute", point_);
  prefixes_.insert_or_assign(prefix, space);
  builder_.document().prefixes.insert_or_assign(prefix, space);
}

void OwlXmlReader::End() {
  switch (open_.back()) {
    case Open::kConstruct:
    case Open::kDeclared:
      axioms_.Close();
      break;
    case Open::kText:
      EndText();
      break;
    default:
      break;
  }
  open_.pop_back();
}

void OwlXmlReader::EndText() {
  if (name_ == "Literal") {
    try {
      return axioms_.Add(OwlNode::Leaf(NodeKind::kLiteral,
                                       axioms_.rdf().Literal(text_, datatype_, language_), point_));
    } catch (const Error& error) {
      throw WithPlace(error, At(point_));
    }
  }
  const std::string_view text = Trim(text_);
  const std::string iri = name_ == "AbbreviatedIRI" ? Expanded(text, point_) : Resolved(text);
  const std::uint32_t term = Intern({TermKind::kIri, iri, {}, {}}, point_);
  if (name_ == "Import") return axioms_.rdf().Import(term);
  axioms_.Add(OwlNode::Leaf(NodeKind::kIri, term, point_));
}

void OwlXmlReader::Text(std::string_view piece) {
  if (open_.empty() || open_.back() == Open::kSkipped) return;
  if (open_.back() == Open::kText) {
    if (text_.size() + piece.size() > options_.max_term_bytes) {
      throw Error(Code::kTooLarge,
                  "a term is longer than " + std::to_string(options_.max_term_bytes) + " bytes",
                  At(point_));
    }
    text_.append(piece);
  } else if (!Trim(piece).empty()) {
    Refuse("the text " + Quoted(Trim(piece)) + " after this tag is in the wrong place", point_);
  }
}

std::optional<std::string_view> OwlXmlReader::Attribute(const XmlElement& element,
                                                        std::string_view name) const {
  for (const auto& attribute : element.attributes) {
    if (attribute.prefix.empty() && attribute.name == name) return attribute.value;
  }
  return std::nullopt;
}

std::string_view OwlXmlReader::Required(const XmlElement& element, std::string_view name) const {
  if (const auto value = Attribute(element, name)) return *value;
  Refuse("the element " + std::string(element.name) + " has no attribute " + std::string(name),
         point_);
}

std::uint32_t OwlXmlReader::IriTerm(const XmlElement& element) {
  std::string iri;
  if (const auto full = Attribute(element, "IRI")) {
    iri = Resolved(*full);
  } else if (const auto abbreviated = Attribute(element, "abbreviatedIRI")) {
    iri = Expanded(*abbreviated, point_);
  } else {
    Refuse("the element " + std::string(element.name) +
               " has neither of the attributes IRI and abbreviatedIRI",
           point_);
  }
  return Intern({TermKind::kIri, iri, {}, {}}, point_);
}

std::string OwlXmlReader::Resolved(std::string_view iri) const {
  if (base_.empty() || IsAbsoluteIri(iri)) return std::string(iri);
  std::string resolved;
  ResolveIri(iri, base_, resolved);
  return resolved;
}

std::string OwlXmlReader::Expanded(std::string_view name, const SourcePoint& point) const {
  const std::size_t colon = name.find(':');
  const std::string_view prefix = name.substr(0, colon);
  const auto row = prefixes_.find(prefix);
  if (colon == std::string_view::npos) Refuse(Quoted(name) + " has no prefix", point);
  if (row == prefixes_.end()) {
    Refuse("the prefix '" + std::string(prefix) + ":' is not declared", point);
  }
  return row->second + std::string(name.substr(colon + 1));
}

std::uint32_t OwlXmlReader::Intern(const TermView& term, const SourcePoint& point) {
  try {
    return builder_.Intern(term);
  } catch (const Error& error) {
    throw WithPlace(error, At(point));
  }
}

}  // namespace

Document ReadOwlXml(std::string_view bytes, const ReadOptions& options) {
  return OwlXmlReader(bytes, options).Read();
}

}  // namespace lares::rdf
