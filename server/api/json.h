// The values of the services as JSON, in the shapes that the OpenAPI document gives them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "mapping/semantic/map_object.h"
#include "ontology/rdf/document.h"
#include "recipes/plan/plan.h"
#include "recipes/resource.h"
#include "server/knowledge/knowledge.h"
#include "server/store/store.h"

namespace lares::api {

using Json = nlohmann::ordered_json;

Json ToJson(const recipes::Resource& resource);
Json ToJson(const std::vector<recipes::Resource>& resources);
Json ToJson(const rdf::Remark& remark);
Json ToJson(const server::CheckAnswer& answer);
Json ToJson(const store::DocumentInfo& document);
Json ToJson(const store::LayerInfo& layer);
Json ToJson(const store::EnvironmentVersion& version);
Json ToJson(const store::EnvironmentInfo& environment);
Json ToJson(const semantic::MapObject& object);
Json ToJson(const recipes::Task& task);
Json ToJson(const server::PutAnswer& answer);

// Repairs and warnings of a document that was read, and warnings without a place, as two lists
// "repairs" and "warnings" of {message, place?}.
void AddRemarks(const std::vector<rdf::Remark>& remarks, const std::vector<std::string>& warnings,
                Json& to);

}  // namespace lares::api
