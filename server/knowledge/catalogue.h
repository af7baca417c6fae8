// The catalogue: the ontology modules, ours and those put later, closed.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ontology/rdf/aliases.h"
#include "ontology/triples/view.h"
#include "server/knowledge/knowledge.h"

namespace lares::server {

// One state of the catalogue. Immutable, shared by the readers that began with it.
struct CatalogueState {
  rdf::View view;  // the own modules' layer below, that of the stored documents above it
  std::uint64_t generation = 0;
  std::size_t inferred = 0;
  std::vector<Knowledge::Module> modules;
  // Lower-case local name or label of a class → the classes.
  std::unordered_map<std::string, std::vector<rdf::TermId>> classes_by_name;
};

// The graphs of the project's own modules: ontology/*.ttl and recipes/skills/*.ttl.
std::vector<rdf::Graph> LoadOwnModules(const rdf::AliasTable& aliases, rdf::Dictionary& dictionary);

// The layer of the project's own modules; they change only with the program.
rdf::View CloseOwnModules(const std::shared_ptr<rdf::Dictionary>& dictionary,
                          std::vector<rdf::Graph> own);

// The catalogue of the own modules and `stored`; made from `before`, an earlier one over the same
// own modules, where that is given.
std::shared_ptr<const CatalogueState> MakeCatalogue(const rdf::View& own,
                                                    const std::vector<rdf::Graph>& stored,
                                                    std::uint64_t generation,
                                                    const CatalogueState* before);

// The triples of a layer that no document asserts. Linear.
std::size_t CountInferred(const rdf::Layer& layer);

// Whether a class is one of places: as our own modules have it where they know the class (KnowRob
// calls every container a place), as the whole catalogue has it otherwise.
bool IsPlace(const CatalogueState& catalogue, rdf::TermId kind);

// A term as answers name it.
recipes::Resource Describe(const rdf::View& view, rdf::TermId term);
recipes::Resource Describe(const rdf::View& view, std::string_view iri);

// One sentence for each contradiction of the top layer, the first `limit` of them.
std::vector<std::string> DescribeClashes(const rdf::View& view, std::size_t limit = 5);

}  // namespace lares::server
