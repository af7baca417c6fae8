#include "benchmarks/konclude.h"

#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>

#include "base/error.h"
#include "base/file.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::bench {
namespace {

namespace fs = std::filesystem;

const std::string kType = std::string(rdf::kRdf) + "type";
const std::string kSubClassOf = std::string(rdf::kRdfs) + "subClassOf";

std::string Quoted(const fs::path& path) { return "'" + path.string() + "'"; }

void Run(const std::string& command, const fs::path& log) {
  const std::string line = "timeout 300 Konclude " + command + " >" + Quoted(log) + " 2>&1";
  if (std::system(line.c_str()) != 0) throw Error(Code::kInternal, "Konclude failed: " + line);
}

std::string Unescaped(std::string text) {
  for (std::size_t at = 0; (at = text.find("&amp;", at)) != std::string::npos; ++at) {
    text.erase(at + 1, 4);
  }
  return text;
}

// The IRIs bound to x and y in answers written one after the other.
void ReadAnswers(const std::string& text, const std::vector<std::string>& properties,
                 Facts& facts) {
  std::size_t at = 0;
  for (const std::string& property : properties) {
    at = text.find("<sparql", at);
    if (at == std::string::npos) throw Error(Code::kInternal, "Konclude answered too few queries");
    const std::size_t end = text.find("</sparql>", at);
    std::string subject;
    while (true) {
      const std::size_t binding = text.find("<binding name=\"", at);
      if (binding >= end) break;
      const char variable = text[binding + 15];
      const std::size_t close = text.find("</binding>", binding);
      const std::size_t uri = text.find("<uri>", binding);
      at = close;
      std::string value;  // stays empty for what is no IRI
      if (uri < close) {
        value = Unescaped(text.substr(uri + 5, text.find("</uri>", uri) - uri - 5));
      }
      if (variable == 'x') {
        subject = value;
      } else if (!subject.empty() && !value.empty()) {
        facts.insert(subject + ' ' + property + ' ' + value);
      }
    }
    at = end;
  }
}

// Calls the function for each `property` between two IRIs in a file of OWL/XML.
void ForEachNamed(const fs::path& file, const std::string& property,
                  const std::function<void(const std::string&, const std::string&)>& visit) {
  rdf::ReadOptions options;
  options.source = file.filename().string();
  const rdf::Document document = ReadRdf(ReadFile(file), rdf::Format::kOwlXml, options);
  for (const rdf::Statement& statement : document.statements) {
    const auto& s = document.terms[statement.subject];
    const auto& o = document.terms[statement.object];
    if (document.terms[statement.predicate].value != property) continue;
    if (s.kind == rdf::TermKind::kIri && o.kind == rdf::TermKind::kIri) visit(s.value, o.value);
  }
}

}  // namespace

Conclusions ClassesByKonclude(const fs::path& file) {
  const fs::path folder = file.parent_path();
  Run("classification -w 2 -i " + Quoted(file) + " -o " + Quoted(folder / "classes.owx"),
      folder / "log");
  Conclusions found;
  found.is_consistent = ReadFile(folder / "log").find("inconsistent") == std::string::npos;
  std::map<std::string, std::set<std::string>> above;
  ForEachNamed(folder / "classes.owx", kSubClassOf,
               [&](const std::string& c, const std::string& d) { above[c].insert(d); });
  ForEachNamed(folder / "classes.owx", std::string(rdf::kOwl) + "equivalentClass",
               [&](const std::string& c, const std::string& d) {
                 above[c].insert(d);
                 above[d].insert(c);
               });
  for (const auto& [c, direct] : above) {
    std::vector<std::string> open(direct.begin(), direct.end());
    std::set<std::string> seen;
    while (!open.empty()) {
      const std::string d = open.back();
      open.pop_back();
      if (!seen.insert(d).second) continue;
      if (d != c) found.facts.insert(c + ' ' + kSubClassOf + ' ' + d);
      const auto next = above.find(d);
      if (next != above.end()) open.insert(open.end(), next->second.begin(), next->second.end());
    }
  }
  return found;
}

Conclusions IndividualsByKonclude(const fs::path& file,
                                  const std::vector<std::string>& properties) {
  const fs::path folder = file.parent_path();
  const fs::path log = folder / "log";
  Run("realization -w 2 -i " + Quoted(file) + " -o " + Quoted(folder / "types.owx"), log);
  Conclusions found;
  const std::string said = ReadFile(log);
  if (said.find("inconsistent") != std::string::npos) found.is_consistent = false;
  for (std::size_t at = 0; (at = said.find("{error}", at)) != std::string::npos; ++at) {
    std::cerr << "  Konclude: " << said.substr(at, said.find('\n', at) - at) << '\n';
  }
  ForEachNamed(folder / "types.owx", kType, [&](const std::string& x, const std::string& c) {
    found.facts.insert(x + ' ' + kType + ' ' + c);
  });
  std::string queries;
  for (const std::string& property : properties) {
    queries += "SELECT ?x ?y WHERE { ?x <" + property + "> ?y . }\n";
  }
  WriteFileAtomically(folder / "queries", queries);
  Run("sparqlfile -w 2 -i " + Quoted(file) + " -s " + Quoted(folder / "queries") + " -o " +
          Quoted(folder / "answers"),
      log);
  ReadAnswers(ReadFile(folder / "answers"), properties, found.facts);
  return found;
}

}  // namespace lares::bench
