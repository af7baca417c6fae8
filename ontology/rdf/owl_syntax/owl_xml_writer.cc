#include <string>

#include "base/xml_text.h"
#include "ontology/rdf/owl_syntax/owl_writers.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"
#include "ontology/rdf/writers.h"
#include "ontology/rdf/xml_names.h"

namespace lares::rdf {
namespace {

using enum Construct;
using Kind = OwlNode::Kind;

// The element that an IRI becomes, by the role of the argument.
std::string_view ElementOf(char role) {
  switch (role) {
    case 'C':
    case 'c':
      return "Class";
    case 'P':
    case 'p':
    case 'X':
      return "ObjectProperty";
    case 'D':
      return "DataProperty";
    case 'A':
      return "AnnotationProperty";
    case 'R':
    case 't':
      return "Datatype";
    case 'I':
      return "NamedIndividual";
    default:
      return {};  // IRI or AbbreviatedIRI, with the IRI as text
  }
}

class OwlXmlWriter {
 public:
  explicit OwlXmlWriter(const Document& document)
      : document_(document),
        prefixes_(OwlPrefixes(document)),
        labels_(BlankLabels(document, &IsAsciiXmlName)) {}

  std::string Write(const OwlOntology& ontology);

 private:
  void Print(const OwlNode& node, char role, int depth);
  void PrintConstruct(const OwlNode& node, int depth);
  void PrintArguments(const OwlNode& node, int depth);
  void PrintIri(std::string_view iri, std::string_view element);
  void PrintLiteral(const Term& literal);
  void Indent(int depth) { out_.append(4 * static_cast<std::size_t>(depth), ' '); }
  // Empty when no prefix shortens it.
  std::string Shortened(std::string_view iri);

  const Document& document_;
  PrefixTable prefixes_;
  std::vector<std::string> labels_;
  std::string out_;
};

std::string OwlXmlWriter::Write(const OwlOntology& ontology) {
  for (const std::uint32_t import : ontology.imports) {
    out_ +=
        "    <Import>" + EscapedXml(document_.terms[import].value, XmlUse::kText) + "</Import>\n";
  }
  for (const auto* nodes : {&ontology.annotations, &ontology.axioms}) {
    for (const OwlNode& node : *nodes) Print(node, 0, 1);
  }
  std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Ontology xmlns=\"";
  head += kOwl;
  head += '"';
  if (ontology.iri) {
    const std::string iri = EscapedXml(document_.terms[*ontology.iri].value, XmlUse::kAttribute);
    head += "\n    xml:base=\"" + iri + "\"\n    ontologyIRI=\"" + iri + "\"";
  }
  if (ontology.version) {
    head += "\n    versionIRI=\"" +
            EscapedXml(document_.terms[*ontology.version].value, XmlUse::kAttribute) + "\"";
  }
  head += ">\n";
  for (const auto& [prefix, space] : prefixes_.Used()) {
    head += "    <Prefix name=\"" + prefix + "\" IRI=\"" + EscapedXml(space, XmlUse::kAttribute) +
            "\"/>\n";
  }
  return head + out_ + "</Ontology>\n";
}

void OwlXmlWriter::Print(const OwlNode& node, char role, int depth) {
  switch (node.kind) {
    case Kind::kConstruct:
      return PrintConstruct(node, depth);
    case Kind::kIri:
      Indent(depth);
      return PrintIri(document_.terms[node.term].value, ElementOf(role));
    case Kind::kBlank:
      Indent(depth);
      out_ += "<AnonymousIndividual nodeID=\"_:" + labels_[node.term] + "\"/>\n";
      return;
    case Kind::kLiteral:
      Indent(depth);
      return PrintLiteral(document_.terms[node.term]);
    case Kind::kNumber:
      return;  // an attribute
  }
}

void OwlXmlWriter::PrintConstruct(const OwlNode& node, int depth) {
  const ConstructInfo& info = InfoOf(node.construct);
  if (info.category == Category::kGroup) return PrintArguments(node, depth);
  Indent(depth);
  if (info.category == Category::kEntity) {
    return PrintIri(document_.terms[node.arguments[0].term].value, info.name);
  }
  out_.append("<").append(info.name);
  if (info.shape == Shape::kCardinality) {
    out_ += " cardinality=\"" + document_.terms[node.arguments[0].term].value + "\"";
  } else if (node.construct == kFacetRestriction) {
    out_ += " facet=\"" +
            EscapedXml(document_.terms[node.arguments[0].term].value, XmlUse::kAttribute) + "\"";
  }
  out_ += ">\n";
  for (const OwlNode& annotation : node.annotations) Print(annotation, 0, depth + 1);
  PrintArguments(node, depth + 1);
  Indent(depth);
  out_.append("</").append(info.name).append(">\n");
}

void OwlXmlWriter::PrintArguments(const OwlNode& node, int depth) {
  const std::string roles = RolesFor(InfoOf(node.construct), node.arguments.size()).value_or("");
  const std::size_t first = node.construct == kFacetRestriction ? 1 : 0;
  for (std::size_t i = first; i < node.arguments.size() && i < roles.size(); ++i) {
    Print(node.arguments[i], roles[i], depth);
  }
}

std::string OwlXmlWriter::Shortened(std::string_view iri) {
  std::string name = prefixes_.Shorten(iri);
  return name.ends_with(':') ? "" : name;
}

void OwlXmlWriter::PrintIri(std::string_view iri, std::string_view element) {
  const std::string name = Shortened(iri);
  if (element.empty()) {
    out_ += name.empty() ? "<IRI>" + EscapedXml(iri, XmlUse::kText) + "</IRI>\n"
                         : "<AbbreviatedIRI>" + name + "</AbbreviatedIRI>\n";
    return;
  }
  out_.append("<").append(element);
  out_ +=
      name.empty() ? " IRI=\"" + EscapedXml(iri, XmlUse::kAttribute) : " abbreviatedIRI=\"" + name;
  out_ += "\"/>\n";
}

void OwlXmlWriter::PrintLiteral(const Term& literal) {
  if (!IsXmlText(literal.value)) {
    throw Error(Code::kInvalid,
                "the literal " + Quoted(literal.value) + " has a character that XML cannot hold")
        .WithHint("functional syntax and Turtle can");
  }
  out_ += "<Literal";
  if (!literal.language.empty()) {
    out_ += " xml:lang=\"" + literal.language + "\"";
  } else if (!literal.datatype.empty()) {
    out_ += " datatypeIRI=\"" + EscapedXml(literal.datatype, XmlUse::kAttribute) + "\"";
  }
  out_ += ">" + EscapedXml(literal.value, XmlUse::kText) + "</Literal>\n";
}

}  // namespace

std::string PrintOwlXml(const Document& document, const OwlOntology& ontology) {
  return OwlXmlWriter(document).Write(ontology);
}

}  // namespace lares::rdf
