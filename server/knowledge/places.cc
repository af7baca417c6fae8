// Where things are: seen in a map, or likely by a table.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/file.h"
#include "base/search_path.h"
#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

constexpr char kOwnTable[] = "lares";

std::shared_ptr<const PlaceTables> Split(const places::PriorTable& table,
                                         const CatalogueState& catalogue) {
  const rdf::View& view = catalogue.view;
  const rdf::TermId sub_class = view.dictionary().InternIri(std::string(rdf::kRdfs) + "subClassOf");
  auto tables = std::make_shared<PlaceTables>();
  tables->title = table.title;
  tables->rooms.name = tables->furniture.name = table.name;
  for (const places::PriorRow& row : table.rows) {
    // Rooms are places; what else a table names (furniture, boxes) stands in one. A class that no
    // ontology knows is taken for a room, as the tables of rooms in the field have it.
    const auto place = view.dictionary().FindIri(row.place);
    const bool is_known = place && !view.Objects(*place, sub_class).empty();
    const bool is_room = !is_known || IsPlace(catalogue, *place);
    (is_room ? tables->rooms : tables->furniture).rows.push_back(row);
  }
  return tables;
}

std::vector<WhereAnswer::Place> Rank(const places::PriorTable& table, const std::string& object,
                                     const rdf::View& view) {
  std::vector<WhereAnswer::Place> ranked;
  if (table.rows.empty()) return ranked;
  for (const places::RankedPlace& place : places::RankPlaces(table, object)) {
    ranked.push_back({Describe(view, place.place), place.probability, place.support});
  }
  return ranked;
}

bool Mentions(const PlaceTables& tables, const std::string& object) {
  const auto names = [&](const places::PriorRow& row) { return row.object == object; };
  return std::any_of(tables.rooms.rows.begin(), tables.rooms.rows.end(), names) ||
         std::any_of(tables.furniture.rows.begin(), tables.furniture.rows.end(), names);
}

bool NewerFirst(const SeenObject& a, const SeenObject& b) {
  return a.object.last_seen.value_or(Time{}) > b.object.last_seen.value_or(Time{});
}

}  // namespace

std::shared_ptr<const PlaceTables> Knowledge::FindPrior(const std::string& name) {
  const auto catalogue = state_->catalogue();
  std::string key = name + "#" + std::to_string(catalogue->generation);
  std::optional<store::DocumentInfo> document;
  if (name != kOwnTable) {
    document = state_->store.FindDocument(store::DocumentKind::kPrior, name);
    if (!document) {
      throw Error(Code::kNotFound, "no prior is called '" + name + "'")
          .WithHint("lares prior list shows those stored; '" + std::string(kOwnTable) +
                    "' is built in");
    }
    key += "@" + std::to_string(document->version);
  }
  const std::lock_guard lock(state_->priors_mutex);
  auto& tables = state_->priors[key];
  if (tables) return tables;
  if (document) {
    const auto details = nlohmann::json::parse(document->details_json);
    const auto format = details.value("format", "tsv") == "omics" ? places::PriorFormat::kOmics
                                                                  : places::PriorFormat::kTsv;
    tables = Split(places::ReadPrior(state_->store.ReadBlob(document->blob.sha256), format, name,
                                     state_->aliases),
                   *catalogue);
  } else {
    tables = Split(places::ReadPrior(ReadFile(FindShared("ontology/priors/lares.tsv")),
                                     places::PriorFormat::kTsv, kOwnTable, state_->aliases),
                   *catalogue);
  }
  return tables;
}

WhereAnswer Knowledge::Where(const WhereRequest& request) {
  WhereAnswer answer;
  answer.prior = request.prior.empty() ? kOwnTable : request.prior;
  const std::shared_ptr<const PlaceTables> tables = FindPrior(answer.prior);
  answer.prior_title = tables->title;
  const auto catalogue = state_->catalogue();
  try {
    answer.object = ResolveClass(request.object);
  } catch (const Error&) {
    // A table may know classes that no ontology does.
    const std::string iri = state_->aliases.Canonical(
        request.object.find(':') == std::string::npos ? std::string(rdf::kLares) + request.object
                                                      : request.object);
    if (!Mentions(*tables, iri)) throw;
    answer.object = Describe(catalogue->view, iri);
  }
  answer.rooms = Rank(tables->rooms, answer.object.iri, catalogue->view);
  answer.furniture = Rank(tables->furniture, answer.object.iri, catalogue->view);
  if (request.environment.empty()) return answer;

  const store::EnvironmentVersion version =
      state_->store.GetVersion(request.environment, request.environment_version);
  const rdf::View view = state_->ViewOf({nullptr, nullptr, &version});
  const rdf::TermId type = view.dictionary().InternIri(std::string(rdf::kRdf) + "type");
  const rdf::TermId wanted = view.dictionary().InternIri(answer.object.iri);
  for (semantic::MapObject& object : MapObjects(request.environment, version.number)) {
    const auto term = view.dictionary().FindIri(object.iri);
    if (term && view.Contains({*term, type, wanted})) {
      answer.seen.push_back({version.environment, version.number, std::move(object)});
    }
  }
  std::stable_sort(answer.seen.begin(), answer.seen.end(), NewerFirst);
  return answer;
}

}  // namespace lares::server
