// What an object model's description and files say, as it is kept with the document.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "server/knowledge/catalogue.h"
#include "server/store/store.h"

namespace lares::server {

// Of the document behind `graph`, which is the top layer of `view`: "models" (model, class, and the
// classes that the document puts that class under), "kinds" of model, "algorithms", "makers",
// "created", "object_ids", "links" and "stated_size_m" (width, height, depth). Throws kInvalid
// when nothing has providesModelFor, and naming thing and property for sizes that are none.
nlohmann::json DescribeModels(const CatalogueState& catalogue, const rdf::View& view,
                              const rdf::Graph& graph);

// "files", each read for what it says of the object's shape. Throws kInvalid for files that are
// not what their name says.
nlohmann::json DescribeModelFiles(const store::Store& store,
                                  const std::vector<AttachedFile>& files);

// "extents" {size_m, axes_known, from} out of both; null when neither says anything.
nlohmann::json ExtentsOf(const nlohmann::json& description, const nlohmann::json& files);

}  // namespace lares::server
