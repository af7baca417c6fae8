#include "ontology/rdf/writer.h"

#include <algorithm>

#include "ontology/rdf/owl_syntax/owl_writers.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/writers.h"

namespace lares::rdf {
namespace {

[[noreturn]] void Refuse(const std::string& message) { throw Error(Code::kInvalid, message); }

void CheckStatement(const Document& document, const Statement& statement) {
  const auto& terms = document.terms;
  const bool has_graph = statement.graph != Statement::kDefaultGraph;
  const std::size_t last = std::max(
      {statement.subject, statement.predicate, statement.object, has_graph ? statement.graph : 0});
  if (last >= terms.size()) throw Error(Code::kInternal, "a statement names a term that is absent");
  if (terms[statement.subject].kind == TermKind::kLiteral) {
    Refuse("a literal cannot be a subject: " + Quoted(terms[statement.subject].value));
  }
  if (terms[statement.predicate].kind != TermKind::kIri) {
    Refuse("only an IRI can be a predicate, not " + Quoted(terms[statement.predicate].value));
  }
  if (has_graph && terms[statement.graph].kind == TermKind::kLiteral) {
    Refuse("a literal cannot name a graph: " + Quoted(terms[statement.graph].value));
  }
}

void CheckDocument(const Document& document, bool may_have_graphs) {
  for (const Term& term : document.terms) {
    if (const auto fault = FaultOf(term.view())) Refuse(*fault);
  }
  for (const Statement& statement : document.statements) {
    CheckStatement(document, statement);
    if (!may_have_graphs && statement.graph != Statement::kDefaultGraph) {
      throw Error(Code::kInvalid, "the document has named graphs, which this format cannot hold")
          .WithHint("TriG, N-Quads and JSON-LD can");
    }
  }
}

std::string Describe(const Document& document, const LeftOutTriple& left_out) {
  const Statement& statement = left_out.statement;
  std::string text;
  for (const std::uint32_t term : {statement.subject, statement.predicate, statement.object}) {
    text += ToNTriples(document.terms[term].view()) + " ";
  }
  return text + ". (" + left_out.why + ")";
}

std::string PrintAxioms(const Document& document, const OwlOntology& ontology, Format format) {
  return format == Format::kOwlXml ? PrintOwlXml(document, ontology)
                                   : PrintFunctional(document, ontology);
}

std::string WriteOwl(const Document& document, Format format) {
  const AxiomsOfDocument axioms = AxiomsOf(document);
  if (!axioms.left_out.empty()) {
    const std::size_t more = axioms.left_out.size() - 1;
    throw Error(Code::kInvalid,
                "no axiom of OWL 2 says " + Describe(document, axioms.left_out[0]) +
                    (more == 0 ? "" : ", nor " + std::to_string(more) + " more of its triples"))
        .WithHint("Turtle can hold any triple");
  }
  return PrintAxioms(document, axioms.ontology, format);
}

}  // namespace

std::vector<std::string> BlankLabels(const Document& document, bool (*fits)(std::string_view)) {
  const bool keeps = std::all_of(document.terms.begin(), document.terms.end(), [&](const Term& t) {
    return t.kind != TermKind::kBlank || fits(t.value);
  });
  std::vector<std::string> labels(document.terms.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (document.terms[i].kind != TermKind::kBlank) continue;
    labels[i] = keeps ? document.terms[i].value : "n" + std::to_string(i);
  }
  return labels;
}

std::string WriteLines(const Document& document) {
  const std::vector<std::string> labels = BlankLabels(document, &IsBlankLabel);
  std::string out;
  const auto append = [&](std::uint32_t index) {
    const Term& term = document.terms[index];
    out += term.kind == TermKind::kBlank ? "_:" + labels[index] : ToNTriples(term.view());
    out += ' ';
  };
  for (const Statement& statement : document.statements) {
    append(statement.subject);
    append(statement.predicate);
    append(statement.object);
    if (statement.graph != Statement::kDefaultGraph) append(statement.graph);
    out += ".\n";
  }
  return out;
}

bool HoldsOnlyAxioms(Format format) {
  return format == Format::kOwlFunctional || format == Format::kOwlXml;
}

OwlText WriteAxioms(const Document& document, Format format) {
  CheckDocument(document, false);
  const AxiomsOfDocument axioms = AxiomsOf(document);
  OwlText written{PrintAxioms(document, axioms.ontology, format), {}};
  for (const LeftOutTriple& triple : axioms.left_out) {
    written.left_out.push_back(Describe(document, triple));
  }
  return written;
}

bool HoldsGraphs(Format format) {
  return format == Format::kTriG || format == Format::kNQuads || format == Format::kJsonLd;
}

std::string WriteRdf(const Document& document, Format format) {
  CheckDocument(document, HoldsGraphs(format));
  switch (format) {
    case Format::kNTriples:
    case Format::kNQuads:
      return WriteLines(document);
    case Format::kTurtle:
    case Format::kTriG:
      return WriteTurtle(document);
    case Format::kRdfXml:
      return WriteRdfXml(document);
    case Format::kOwlFunctional:
    case Format::kOwlXml:
      return WriteOwl(document, format);
    case Format::kJsonLd:
      return WriteJsonLd(document);
  }
  throw Error(Code::kInternal, "a format that is none");
}

}  // namespace lares::rdf
