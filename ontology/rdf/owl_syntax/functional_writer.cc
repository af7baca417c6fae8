#include <string>

#include "ontology/rdf/owl_syntax/owl_writers.h"
#include "ontology/rdf/prefix_table.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/writers.h"

namespace lares::rdf {
namespace {

using enum Construct;
using Kind = OwlNode::Kind;

class FunctionalWriter {
 public:
  explicit FunctionalWriter(const Document& document)
      : document_(document),
        prefixes_(document.prefixes),
        labels_(BlankLabels(document, &IsBlankLabel)) {}

  std::string Write(const OwlOntology& ontology);

 private:
  void Print(const OwlNode& node);
  void PrintConstruct(const OwlNode& node);
  void PrintArguments(const OwlNode& node);
  void PrintLiteral(const Term& literal);
  void PrintIri(std::string_view iri);

  const Document& document_;
  PrefixTable prefixes_;
  std::vector<std::string> labels_;
  std::string out_;
};

std::string FunctionalWriter::Write(const OwlOntology& ontology) {
  out_ = "Ontology(";
  if (ontology.iri) out_ += "<" + document_.terms[*ontology.iri].value + ">";
  if (ontology.version) out_ += " <" + document_.terms[*ontology.version].value + ">";
  out_ += '\n';
  for (const std::uint32_t import : ontology.imports) {
    out_ += "Import(<" + document_.terms[import].value + ">)\n";
  }
  for (const auto* nodes : {&ontology.annotations, &ontology.axioms}) {
    for (const OwlNode& node : *nodes) {
      Print(node);
      out_ += '\n';
    }
  }
  out_ += ")\n";
  std::string head;
  for (const auto& [prefix, space] : prefixes_.Used()) {
    head += "Prefix(" + prefix + ":=<" + space + ">)\n";
  }
  return head.empty() ? out_ : head + "\n" + out_;
}

void FunctionalWriter::Print(const OwlNode& node) {
  switch (node.kind) {
    case Kind::kConstruct:
      return PrintConstruct(node);
    case Kind::kIri:
      return PrintIri(document_.terms[node.term].value);
    case Kind::kBlank:
      out_ += "_:" + labels_[node.term];
      return;
    case Kind::kLiteral:
      return PrintLiteral(document_.terms[node.term]);
    case Kind::kNumber:
      out_ += document_.terms[node.term].value;
      return;
  }
}

void FunctionalWriter::PrintConstruct(const OwlNode& node) {
  const ConstructInfo& info = InfoOf(node.construct);
  if (node.construct == kFacetRestriction) return PrintArguments(node);
  if (info.category != Category::kGroup) out_ += info.name;
  out_ += '(';
  for (const OwlNode& annotation : node.annotations) {
    Print(annotation);
    out_ += ' ';
  }
  PrintArguments(node);
  out_ += ')';
}

void FunctionalWriter::PrintArguments(const OwlNode& node) {
  for (std::size_t i = 0; i < node.arguments.size(); ++i) {
    if (i > 0) out_ += ' ';
    Print(node.arguments[i]);
  }
}

void FunctionalWriter::PrintLiteral(const Term& literal) {
  out_ += '"';
  for (const char c : literal.value) {
    if (c == '"' || c == '\\') out_ += '\\';
    out_ += c;
  }
  out_ += '"';
  if (!literal.language.empty()) {
    out_ += "@" + literal.language;
  } else if (!literal.datatype.empty()) {
    out_ += "^^";
    PrintIri(literal.datatype);
  }
}

void FunctionalWriter::PrintIri(std::string_view iri) {
  const std::string name = prefixes_.Shorten(iri);
  // "a:" alone is a prefix and no IRI here.
  if (name.empty() || name.back() == ':') {
    out_.append("<").append(iri).append(">");
  } else {
    out_ += name;
  }
}

}  // namespace

std::string PrintFunctional(const Document& document, const OwlOntology& ontology) {
  return FunctionalWriter(document).Write(ontology);
}

}  // namespace lares::rdf
