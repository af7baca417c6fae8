#include "tests/ontology/content.h"

#include <algorithm>

#include "base/file.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::testing {
namespace {

using rdf::TermId;

std::string Expand(std::string_view name) {
  if (name.find("://") != std::string_view::npos) return std::string(name);
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return std::string(rdf::kLares).append(name);
  const std::string_view prefix = name.substr(0, colon);
  const std::string_view space = prefix == "owl"    ? rdf::kOwl
                                 : prefix == "rdfs" ? rdf::kRdfs
                                 : prefix == "rdf"  ? rdf::kRdf
                                                    : rdf::kXsd;
  return std::string(space).append(name.substr(colon + 1));
}

}  // namespace

std::filesystem::path SourceFolder() { return LARES_SOURCE_DIR; }

rdf::AliasTable OurAliases() {
  const auto file = SourceFolder() / "ontology/aliases.tsv";
  return rdf::AliasTable::FromTsv(lares::ReadFile(file), file.filename().string());
}

std::vector<std::filesystem::path> ModuleFiles() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SourceFolder() / "ontology")) {
    if (entry.path().extension() == ".ttl") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

rdf::Document ReadDocument(const std::filesystem::path& file, bool recover) {
  const std::string bytes = lares::ReadFile(file);
  rdf::ReadOptions options;
  options.source = file.filename().string();
  options.base_iri = "http://example.org/" + options.source;
  options.recover = recover;
  return rdf::ReadRdf(bytes, rdf::GuessFormat({}, options.source, bytes), options);
}

Content::Content(const std::vector<std::filesystem::path>& files, bool recover)
    : view_(std::make_shared<rdf::Dictionary>()) {
  const rdf::AliasTable aliases = OurAliases();
  std::vector<rdf::Graph> graphs;
  for (const auto& file : files) {
    graphs.push_back(rdf::MakeGraph(ReadDocument(file, recover), file.filename().string(), aliases,
                                    view_.dictionary()));
  }
  view_ = view_.With(std::make_shared<rdf::Layer>(std::move(graphs), std::vector<rdf::Triple>{},
                                                  std::vector<rdf::Clash>{}));
}

TermId Content::Id(std::string_view name) const {
  return view_.dictionary().FindIri(Expand(name)).value_or(rdf::kAnyTerm);
}

std::string Content::Name(TermId term) const {
  const std::string_view value = view_.dictionary().Get(term).value;
  return std::string(value.starts_with(rdf::kLares) ? value.substr(rdf::kLares.size()) : value);
}

std::set<std::string> Content::Declared(std::string_view type) const {
  std::set<std::string> names;
  if (Id(type) == rdf::kAnyTerm) return names;
  for (const TermId term : view_.Subjects(Id("rdf:type"), Id(type))) {
    if (view_.dictionary().Get(term).kind == rdf::TermKind::kIri) names.insert(Name(term));
  }
  return names;
}

std::set<std::string> Content::Values(std::string_view subject, std::string_view property) const {
  std::set<std::string> values;
  if (Id(subject) == rdf::kAnyTerm || Id(property) == rdf::kAnyTerm) return values;
  for (const TermId value : view_.Objects(Id(subject), Id(property))) values.insert(Name(value));
  return values;
}

void Content::Members(TermId list, std::vector<TermId>& members) const {
  for (const TermId first : view_.Objects(list, Id("rdf:first"))) members.push_back(first);
  for (const TermId rest : view_.Objects(list, Id("rdf:rest"))) Members(rest, members);
}

std::set<TermId> Content::AboveIds(TermId id) const {
  std::set<TermId> seen;
  std::vector<TermId> open = {id};
  while (!open.empty()) {
    const TermId next = open.back();
    open.pop_back();
    if (next == rdf::kAnyTerm || !seen.insert(next).second) continue;
    for (const TermId parent : view_.Objects(next, Id("rdfs:subClassOf"))) open.push_back(parent);
    if (Id("owl:intersectionOf") == rdf::kAnyTerm) continue;
    for (const TermId list : view_.Objects(next, Id("owl:intersectionOf"))) Members(list, open);
  }
  return seen;
}

std::set<std::string> Content::Above(std::string_view name) const {
  std::set<std::string> names;
  for (const TermId term : AboveIds(Id(name))) {
    if (view_.dictionary().Get(term).kind == rdf::TermKind::kIri) names.insert(Name(term));
  }
  return names;
}

std::set<std::string> Content::Some(std::string_view name, std::string_view property) const {
  std::set<std::string> fillers;
  if (Id(property) == rdf::kAnyTerm) return fillers;
  for (const TermId term : AboveIds(Id(name))) {
    if (!view_.Contains({term, Id("owl:onProperty"), Id(property)})) continue;
    for (const TermId filler : view_.Objects(term, Id("owl:someValuesFrom"))) {
      fillers.insert(Name(filler));
    }
  }
  return fillers;
}

std::set<std::string> Content::Needs(std::string_view task) const {
  std::set<std::string> needs = Some(task, "dependsOnCapability");
  for (const std::string& step : Some(task, "subAction")) needs.merge(Needs(step));
  return needs;
}

}  // namespace lares::testing
