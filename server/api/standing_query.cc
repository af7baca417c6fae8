#include "server/api/standing_query.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/sparql/syntax.h"
#include "server/api/answers.h"
#include "server/api/environments.h"

namespace lares::api {

const std::map<std::string, std::string>& KnownPrefixes() {
  static const std::map<std::string, std::string> prefixes{{"lares", std::string(rdf::kLares)},
                                                           {"rdf", std::string(rdf::kRdf)},
                                                           {"rdfs", std::string(rdf::kRdfs)},
                                                           {"owl", std::string(rdf::kOwl)},
                                                           {"xsd", std::string(rdf::kXsd)}};
  return prefixes;
}

sparql::Query ParseSparql(const std::string& text, const rdf::AliasTable& aliases,
                          const Parameters& graphs) {
  sparql::ParseOptions options;
  options.source = "query";
  options.prefixes = KnownPrefixes();
  const sparql::Query parsed = sparql::Parse(text, options);
  auto syntax = std::make_shared<sparql::syntax::Query>(parsed.syntax());
  for (rdf::Term& term : syntax->terms) {
    if (term.kind == rdf::TermKind::kIri) term.value = aliases.Canonical(term.value);
  }
  if (graphs.contains("default-graph-uri") || graphs.contains("named-graph-uri")) {
    syntax->from.clear();
    syntax->from_named.clear();
    for (const auto& [name, iri] : graphs) {
      if (name == "default-graph-uri") syntax->from.push_back(iri);
      if (name == "named-graph-uri") syntax->from_named.push_back(iri);
    }
  }
  return sparql::Query(std::move(syntax));
}

server::ViewRequest ReadViewRequest(const http::Request& request, const store::Store& store) {
  server::ViewRequest about;
  about.recipe = request.Query("recipe").value_or("");
  about.robot = request.Query("robot").value_or("");
  about.environment = request.Query("environment").value_or("");
  about.environment_version = ChosenVersion(request, store, about.environment);
  return about;
}

sparql::Dataset DatasetOf(const rdf::View& view) {
  return sparql::DatasetOf(view, sparql::DocumentGraphIri);
}

Json TermToJson(const rdf::TermView& term) {
  Json json;
  json["type"] = term.kind == rdf::TermKind::kIri     ? "uri"
                 : term.kind == rdf::TermKind::kBlank ? "bnode"
                                                      : "literal";
  json["value"] = term.value;
  if (!term.language.empty()) {
    json["xml:lang"] = term.language;
  } else if (!term.datatype.empty()) {
    json["datatype"] = term.datatype;
  }
  return json;
}

}  // namespace lares::api
