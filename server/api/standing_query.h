// A question in SPARQL as requests put it: what is asked, about which documents, within which
// limits.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "ontology/rdf/aliases.h"
#include "reasoner/sparql/query.h"
#include "server/http/message.h"
#include "server/knowledge/knowledge.h"

namespace lares::api {

using Parameters = std::multimap<std::string, std::string>;

// The prefixes that a query need not declare.
const std::map<std::string, std::string>& KnownPrefixes();

// Parses `text`; IRIs of the alias table mean what they mean in documents. `graphs`:
// default-graph-uri and named-graph-uri, which replace FROM and FROM NAMED (SPARQL 1.1 Protocol
// §2.1.4).
sparql::Query ParseSparql(const std::string& text, const rdf::AliasTable& aliases,
                          const Parameters& graphs = {});

// ?recipe=, ?robot=, ?environment=, ?version=, ?as_of=. Throws kInvalid, kNotFound.
server::ViewRequest ReadViewRequest(const http::Request& request, const store::Store& store);

// Every document of the view is a named graph.
sparql::Dataset DatasetOf(const rdf::View& view);

// As SPARQL 1.1 Query Results JSON writes a term.
nlohmann::ordered_json TermToJson(const rdf::TermView& term);

}  // namespace lares::api
