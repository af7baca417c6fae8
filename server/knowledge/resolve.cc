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

[[noreturn]] void ThrowAmbiguous(store::DocumentKind kind, const std::string& name,
                                 const std::vector<Match>& matches) {
  std::string list;
  for (const auto& [document, target] : matches) {
    list += "\n  " + document.id + "  <" + target + ">";
  }
  throw Error(Code::kAmbiguous, Quoted(name) + " names " + std::to_string(matches.size()) + " " +
                                    std::string(store::ToString(kind)) + "s:" + list)
      .WithHint("give the id or the IRI of the one you mean");
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
    error.WithHint("did you mean " + Join(similar, " or ") + "?");
  } else if (known.empty()) {
    error.WithHint("none is stored yet: put one first");
  }
  throw error;
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
  if (name.starts_with("lares:")) iri = std::string(rdf::kLares) + name.substr(6);
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
    const std::vector<std::string> similar = SimilarNames(name, known);
    if (!similar.empty()) error.WithHint("did you mean " + Join(similar, " or ") + "?");
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
