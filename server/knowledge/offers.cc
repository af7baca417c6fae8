#include "server/knowledge/offers.h"

#include <nlohmann/json.hpp>
#include <string>

#include "ontology/rdf/vocabulary.h"

namespace lares::server {
namespace {

using recipes::Offer;

// What a layer is to a robot. A grid and a collision map are cut from an OctoMap.
struct LayerKind {
  const char* layer;
  const char* class_name;
};
constexpr LayerKind kLayerKinds[] = {
    {"grid", "OccupancyGridMap"},          {"octomap", "OctoMap"},
    {"octomap", "CollisionMap"},           {"octomap", "OccupancyGridMap"},
    {"features", "VisualSlamMap"},         {"cloud", "PointMap"},
    {"semantic", "SemanticEnvironmentMap"}};

std::string Lares(std::string_view name) { return std::string(rdf::kLares) + std::string(name); }

bool IsUnder(const rdf::View& catalogue, const std::string& modelled, const std::string& sought) {
  if (modelled == sought) return true;
  const auto below = catalogue.dictionary().FindIri(modelled);
  const auto above = catalogue.dictionary().FindIri(sought);
  const auto sub_class = catalogue.dictionary().FindIri(std::string(rdf::kRdfs) + "subClassOf");
  return below && above && sub_class && catalogue.Contains({*below, *sub_class, *above});
}

// Whether the class of one of a description's models, or one that the description puts it under, is
// what is sought.
bool Serves(const rdf::View& catalogue, const nlohmann::json& model, const std::string& sought) {
  if (IsUnder(catalogue, model.at("class").at("iri"), sought)) return true;
  for (const auto& above : model.value("above", nlohmann::json::array())) {
    if (IsUnder(catalogue, above, sought)) return true;
  }
  return false;
}

// The files of a model; one of several is found by its name.
Offer ToOffer(const store::DocumentInfo& document, const nlohmann::json& details,
              const std::string& for_what) {
  Offer offer;
  offer.class_iri = Lares("ObjectRecognitionModel");
  offer.for_what = for_what;
  offer.document = "object-model:" + document.id;
  offer.link = "/v1/object-models/" + document.id;
  const nlohmann::json files = details.value("files", nlohmann::json::array());
  for (const auto& file : files) offer.size_bytes += file.value("size", std::uint64_t{0});
  if (files.size() == 1) {
    offer.file = files[0].value("file_name", "");
    offer.sha256 = files[0].value("sha256", "");
    offer.link += "/files/" + offer.file;
  } else if (files.empty()) {
    offer.file = document.file_name;
    offer.sha256 = document.blob.sha256;
    offer.size_bytes = document.blob.size;
  }
  return offer;
}

}  // namespace

std::vector<Offer> ModelOffers(const store::Store& store, const rdf::View& catalogue,
                               const std::vector<recipes::Resource>& sought) {
  std::vector<Offer> offers;
  std::vector<bool> found(sought.size(), false);
  if (sought.empty()) return offers;
  for (const auto& document : store.ListDocuments(store::DocumentKind::kObjectModel)) {
    const auto details = nlohmann::json::parse(document.details_json, nullptr, false);
    if (!details.is_object() || !details.contains("models")) continue;
    for (std::size_t i = 0; i < sought.size(); ++i) {
      for (const auto& model : details["models"]) {
        if (!Serves(catalogue, model, sought[i].iri)) continue;
        found[i] = true;
        offers.push_back(ToOffer(document, details, sought[i].label));
        break;
      }
    }
  }
  for (const bool one : found) {
    if (!one) return {};
  }
  return offers;
}

std::vector<Offer> MapOffers(const store::EnvironmentVersion& version) {
  std::vector<Offer> offers;
  const std::string number = std::to_string(version.number);
  for (const store::LayerInfo& layer : version.layers) {
    for (const LayerKind& kind : kLayerKinds) {
      if (layer.name != kind.layer) continue;
      offers.push_back({Lares(kind.class_name), version.environment,
                        "environment:" + version.environment + "/" + number, layer.name,
                        "/v1/environments/" + version.environment + "/versions/" + number +
                            "/layers/" + layer.name,
                        layer.blob.sha256, layer.blob.size});
    }
  }
  return offers;
}

}  // namespace lares::server
