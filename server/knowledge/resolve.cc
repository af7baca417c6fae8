// Names that people write become documents and classes.
#include <algorithm>
#include <set>
#include <utility>

#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

using Match = std::pair<store::DocumentInfo, std::string>;  // document, target

std::string Quoted(const std::string& text) { return "'" + text + "'"; }

// The IRI that the document itself wrote for what `target` names.
std::string AsWritten(const store::DocumentInfo& document, const std::string& target) {
  for (const store::DocumentName& name : document.names) {
    if (name.kind == "iri" && name.target == target && name.text != target) return name.text;
  }
  return target;
}

[[noreturn]] void ThrowAmbiguous(store::DocumentKind kind, const std::string& name,
                                 const std::vector<Match>& matches) {
  std::string list;
  std::set<std::string> ids;
  for (const auto& [document, target] : matches) {
    list += "\n  " + document.id + "  <" + AsWritten(document, target) + ">";
    ids.insert(document.id);
  }
  throw Error(Code::kAmbiguous, Quoted(name) + " names " + std::to_string(matches.size()) +
                                    " things among the " + std::string(store::ToString(kind)) +
                                    "s:" + list)
      .WithCandidates({ids.begin(), ids.end()})
      .WithHint(ids.size() > 1 ? "give the id of the one you mean"
                               : "give the IRI of the one you mean");
}

[[noreturn]] void ThrowUnknown(const store::Store& store, store::DocumentKind kind,
                               const std::string& name) {
  std::vector<std::string> known;
  for (const store::DocumentInfo& document : store.ListDocuments(kind)) {
    known.push_back(document.id);
    for (const store::DocumentName& other : document.names) {
      if (other.kind != "iri") known.push_back(other.text);
    }
  }
  Error error(Code::kNotFound,
              "no " + std::string(store::ToString(kind)) + " is called " + Quoted(name));
  const std::vector<std::string> similar = SimilarNames(name, known);
  if (!similar.empty()) {
    error.WithCandidates(similar);
  } else if (known.empty()) {
    error.WithHint("none is stored yet: put one first");
  }
  throw error;
}

// "knowrob" for a table that has …/knowrob.owl#.
bool HasNamespace(const rdf::AliasTable& aliases, const std::string& prefix) {
  return std::any_of(aliases.aliases().begin(), aliases.aliases().end(), [&](const auto& row) {
    return row.is_namespace && row.alias.ends_with("/" + prefix + ".owl#");
  });
}

std::vector<Match> TargetsOf(const store::DocumentInfo& document) {
  std::vector<Match> matches;
  std::set<std::string> seen;
  for (const store::DocumentName& name : document.names) {
    if (name.kind == "id" && seen.insert(name.target).second) {
      matches.emplace_back(document, name.target);
    }
  }
  return matches;
}

}  // namespace

Knowledge::Resolved Knowledge::Resolve(store::DocumentKind kind, const std::string& name) {
  std::vector<Match> matches;
  if (const auto document = state_->store.FindDocument(kind, name)) {
    matches = TargetsOf(*document);
    if (matches.empty()) matches.emplace_back(*document, "");
  } else {
    std::set<std::pair<std::string, std::string>> seen;
    for (const std::string& text : {name, state_->aliases.Canonical(name)}) {
      for (const auto& [found, as] : state_->store.FindByName(kind, text)) {
        if (seen.emplace(found.id, as.target).second) matches.emplace_back(found, as.target);
      }
    }
  }
  if (matches.empty()) ThrowUnknown(state_->store, kind, name);
  if (matches.size() > 1) ThrowAmbiguous(kind, name, matches);
  return {matches.front().first, matches.front().second};
}

recipes::Resource Knowledge::ResolveClass(const std::string& name) {
  const auto catalogue = state_->catalogue();
  const rdf::View& view = catalogue->view;
  const rdf::TermId type = view.dictionary().InternIri(std::string(rdf::kRdf) + "type");
  const rdf::TermId owl_class = view.dictionary().InternIri(std::string(rdf::kOwl) + "Class");
  std::string iri = state_->aliases.Canonical(name);
  if (const std::size_t colon = name.find(':'); colon != std::string::npos) {
    const std::string prefix = name.substr(0, colon);
    const bool is_ours = prefix == "lares";
    if (is_ours || HasNamespace(state_->aliases, prefix)) {
      iri = state_->aliases.Canonical(std::string(rdf::kLares) + name.substr(colon + 1));
    }
  }
  for (const std::string& candidate :
       {iri, state_->aliases.Canonical(std::string(rdf::kLares) + name)}) {
    const auto term = view.dictionary().FindIri(candidate);
    if (term && view.Contains({*term, type, owl_class})) return Describe(view, *term);
  }
  const auto named = catalogue->classes_by_name.find(ToLower(name));
  if (named == catalogue->classes_by_name.end()) {
    std::vector<std::string> known;
    for (const auto& [text, terms] : catalogue->classes_by_name) known.push_back(text);
    Error error(Code::kNotFound, "no class is called " + Quoted(name));
    std::vector<std::string> labels;
    for (const std::string& similar : SimilarNames(name, known)) {
      const std::string label = view.Label(catalogue->classes_by_name.at(similar).front());
      if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(label);
    }
    if (!labels.empty()) error.WithCandidates(labels);
    throw error;
  }
  if (named->second.size() > 1) {
    std::string list;
    for (const rdf::TermId term : named->second) {
      list += "\n  <" + std::string(view.dictionary().Get(term).value) + ">";
    }
    throw Error(Code::kAmbiguous, Quoted(name) + " names several classes:" + list);
  }
  return Describe(view, named->second.front());
}

}  // namespace lares::server
