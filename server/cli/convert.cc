#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>

#include "base/file.h"
#include "ontology/rdf/merge.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/writer.h"
#include "server/cli/command.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

struct ConvertOptions {
  std::vector<std::string> files;
  rdf::Format to = rdf::Format::kTurtle;
  std::string out;
  bool leave_out = false;
  bool recover = false;
};

const std::map<std::string, rdf::Format>& FormatNames() {
  static const std::map<std::string, rdf::Format> names = {
      {"rdf-xml", rdf::Format::kRdfXml}, {"turtle", rdf::Format::kTurtle},
      {"trig", rdf::Format::kTriG},      {"n-triples", rdf::Format::kNTriples},
      {"n-quads", rdf::Format::kNQuads}, {"owl-functional", rdf::Format::kOwlFunctional},
      {"owl-xml", rdf::Format::kOwlXml},
  };
  return names;
}

// For relative IRIs in a file that states no base.
std::string FileIri(const std::string& file) {
  std::string iri = "file://";
  for (const char c : std::filesystem::absolute(file).lexically_normal().string()) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '/' || c == '.' || c == '-' || c == '_';
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned char>(c));
    iri += is_plain ? std::string(1, c) : code;
  }
  return iri;
}

void PrintRemark(const std::string& kind, const std::string& text) {
  std::fprintf(stderr, "%s: %s\n", kind.c_str(), text.c_str());
}

rdf::Document ReadOne(const std::string& file, bool recover) {
  const std::string bytes = ReadFile(file);
  rdf::ReadOptions options;
  options.source = file;
  options.base_iri = FileIri(file);
  options.recover = recover;
  return rdf::ReadRdf(bytes, rdf::GuessFormat("", file, bytes), options);
}

void Convert(const ConvertOptions& convert) {
  std::vector<rdf::Document> documents;
  for (const std::string& file : convert.files) {
    documents.push_back(ReadOne(file, convert.recover));
  }
  const rdf::Document document = rdf::MergeOntologies(documents);
  for (const rdf::Remark& remark : document.remarks) {
    const bool is_repair = remark.kind == rdf::Remark::Kind::kRepair;
    PrintRemark(is_repair ? "repaired" : "warning", ToString(remark.place) + ": " + remark.message);
  }
  std::string text;
  if (convert.leave_out && rdf::HoldsOnlyAxioms(convert.to)) {
    rdf::OwlText written = rdf::WriteAxioms(document, convert.to);
    for (const std::string& triple : written.left_out) PrintRemark("left out", triple);
    text = std::move(written.text);
  } else {
    text = rdf::WriteRdf(document, convert.to);
  }
  if (convert.out.empty()) return Print(text);
  WriteFileAtomically(convert.out, text);
}

}  // namespace

void AddOntologyConvert(CLI::App& ontology) {
  auto* command = AddCommand(
      ontology, "convert",
      "Rewrite ontology files in another format; several become one ontology. Needs no server",
      "  lares ontology convert SOMA.owl --to turtle\n"
      "  lares ontology convert DUL.owl SOMA.owl --to owl-xml --out soma.owx");
  auto convert = std::make_shared<ConvertOptions>();
  command->add_option("files", convert->files, "files; their names or first bytes tell the format")
      ->required()
      ->check(CLI::ExistingFile);
  command->add_option("--to", convert->to, "the format to write")
      ->required()
      ->transform(CLI::CheckedTransformer(FormatNames(), CLI::ignore_case));
  command->add_option("--out,-o", convert->out, "a file to write instead of standard output");
  command->add_flag("--leave-out", convert->leave_out,
                    "to OWL's own syntaxes: list triples that no axiom says and go on");
  command->add_flag("--recover", convert->recover, "repair the known faults of RDF/XML");
  command->callback([convert] { Convert(*convert); });
}

}  // namespace lares::cli
