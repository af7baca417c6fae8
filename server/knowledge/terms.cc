#include "server/knowledge/terms.h"

#include <algorithm>
#include <set>
#include <vector>

#include "base/text.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::server {
namespace {

constexpr std::string_view kPrefixes =
    "@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> . "
    "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> . "
    "@prefix owl: <http://www.w3.org/2002/07/owl#> . "
    "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> . "
    "@prefix lares: <https://w3id.org/lares#> . ";

// Whether `text` is written as a term of Turtle rather than as a name.
bool IsTurtle(const std::string& text) {
  const char first = text.front();
  if (first == '<' || first == '"' || first == '\'' || text == "true" || text == "false")
    return true;
  if ((first >= '0' && first <= '9') || first == '+' || first == '-') return true;
  for (const char* prefix : {"rdf:", "rdfs:", "owl:", "xsd:", "lares:"}) {
    if (text.starts_with(prefix)) return true;
  }
  return false;
}

rdf::TermId ReadTurtleTerm(const rdf::View& view, const rdf::AliasTable& aliases,
                           const std::string& text) {
  rdf::ReadOptions options;
  options.source = "term";
  options.base_iri = "https://w3id.org/lares/";
  rdf::Document document;
  try {
    document = rdf::ReadRdf(std::string(kPrefixes) + "<urn:s> <urn:p> " + text + " .",
                            rdf::Format::kTurtle, options);
  } catch (const Error& error) {
    throw Error(Code::kInvalid, "'" + text + "' is no term: " + error.what());
  }
  if (document.statements.size() != 1) {
    throw Error(Code::kInvalid, "'" + text + "' is more than one term");
  }
  const rdf::Term& term = document.terms[document.statements[0].object];
  if (term.kind != rdf::TermKind::kIri) return view.dictionary().Intern(term.view());
  return view.dictionary().InternIri(aliases.Canonical(term.value));
}

bool IsMentioned(const rdf::View& view, rdf::TermId term) {
  return view.Estimate({term, {}, {}}) + view.Estimate({{}, {}, term}) +
             view.Estimate({{}, term, {}}) >
         0;
}

// Everything of the view with that local name or label, and all such names for what was meant.
struct Named {
  std::set<rdf::TermId> terms;
  std::vector<std::string> names;
};

Named FindNamed(const rdf::View& view, const std::string& text) {
  Named named;
  const std::string wanted = ToLower(text);
  const rdf::TermId label = view.dictionary().InternIri(std::string(rdf::kRdfs) + "label");
  rdf::TermId last{};
  view.ForEach({}, [&](const rdf::Triple& triple) {
    if (triple.predicate == label &&
        ToLower(view.dictionary().Get(triple.object).value) == wanted) {
      named.terms.insert(triple.subject);
    }
    if (triple.subject == last) return true;
    last = triple.subject;
    const rdf::TermView term = view.dictionary().Get(triple.subject);
    if (term.kind != rdf::TermKind::kIri) return true;
    named.names.emplace_back(LocalName(term.value));
    if (ToLower(LocalName(term.value)) == wanted) named.terms.insert(triple.subject);
    return true;
  });
  return named;
}

}  // namespace

rdf::TermId ResolveTerm(const rdf::View& view, const rdf::AliasTable& aliases,
                        const std::string& text) {
  rdf::Dictionary& dictionary = view.dictionary();
  if (Trim(text).empty()) throw Error(Code::kInvalid, "a term is missing");
  if (text == "a") return dictionary.InternIri(std::string(rdf::kRdf) + "type");
  if (text.starts_with("_:")) {
    const auto known =
        dictionary.Find({rdf::TermKind::kBlank, std::string_view(text).substr(2), {}, {}});
    if (known) return *known;
    throw Error(Code::kNotFound, "no blank node is called '" + text + "'");
  }
  if (IsTurtle(text)) return ReadTurtleTerm(view, aliases, text);
  if (text.find(':') != std::string::npos) return dictionary.InternIri(aliases.Canonical(text));
  const auto ours = dictionary.FindIri(aliases.Canonical(std::string(rdf::kLares) + text));
  if (ours && IsMentioned(view, *ours)) return *ours;
  const Named named = FindNamed(view, text);
  if (named.terms.size() == 1) return *named.terms.begin();
  if (named.terms.empty()) {
    throw Error(Code::kNotFound, "nothing is called '" + text + "'")
        .WithCandidates(SimilarNames(text, named.names));
  }
  std::vector<std::string> candidates;
  for (const rdf::TermId term : named.terms) {
    candidates.push_back("<" + std::string(dictionary.Get(term).value) + ">");
  }
  throw Error(Code::kAmbiguous, "'" + text + "' names several things: " + Join(candidates, ", "))
      .WithCandidates(candidates);
}

}  // namespace lares::server
