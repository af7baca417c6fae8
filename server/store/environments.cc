#include "server/store/environments.h"

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "server/store/conditions.h"

namespace lares::store {
namespace {

using Layers = std::map<std::string, LayerInfo>;

#define LARES_ENVIRONMENT_COLUMNS \
  "SELECT id, type_iri, label, created, latest, key FROM environments "
#define LARES_VERSIONS_JOINED \
  "FROM environments e JOIN environment_versions v ON v.environment = e.key "

EnvironmentInfo ReadEnvironment(const Query& row) {
  return {row.Text(0), row.Text(1), row.Text(2), Time(std::chrono::milliseconds(row.Int(3))),
          static_cast<int>(row.Int(4))};
}

// Columns after the version's key.
LayerInfo ReadLayer(const Query& row) {
  LayerInfo layer{row.Text(1),
                  row.Text(2),
                  row.Text(3),
                  {row.Text(4), static_cast<std::uint64_t>(row.Int(5))},
                  {}};
  layer.facts = nlohmann::json::parse(row.Text(6)).get<std::map<std::string, std::string>>();
  return layer;
}

EnvironmentVersion ReadVersion(const Query& row, const std::string& environment) {
  EnvironmentVersion version;
  version.environment = environment;
  version.number = static_cast<int>(row.Int(1));
  version.created = Time(std::chrono::milliseconds(row.Int(2)));
  version.author = row.Text(3);
  version.note = row.Text(4);
  if (const std::string changed = row.Text(5); !changed.empty()) {
    version.changed_layers = Split(changed, ' ');
  }
  version.type_iri = row.Text(6);
  version.label = row.Text(7);
  return version;
}

// Versions and their layers, asked separately, in the same order.
std::vector<EnvironmentVersion> Join(Query& versions, Query& layers, const std::string& id) {
  std::vector<EnvironmentVersion> joined;
  bool more_layers = layers.Next();
  while (versions.Next()) {
    joined.push_back(ReadVersion(versions, id));
    const std::int64_t key = versions.Int(0);
    for (; more_layers && layers.Int(0) == key; more_layers = layers.Next()) {
      joined.back().layers.push_back(ReadLayer(layers));
    }
  }
  return joined;
}

Error NoEnvironment(const std::string& id) {
  return Error(Code::kNotFound, "there is no environment '" + id.substr(0, 200) + "'");
}

bool SameLayer(const LayerInfo& a, const LayerInfo& b) {
  return a.file_name == b.file_name && a.media_type == b.media_type &&
         a.blob.sha256 == b.blob.sha256 && a.facts == b.facts;
}

Layers LayersOf(Database& database, const std::optional<EnvironmentInfo>& environment) {
  Layers layers;
  if (!environment) return layers;
  EnvironmentVersion version = GetVersion(database, environment->id, environment->latest);
  for (LayerInfo& layer : version.layers) layers[layer.name] = std::move(layer);
  return layers;
}

struct Change {
  std::vector<LayerInfo> layers;
  std::vector<std::string> changed;
};

// What `version` makes of its parent's layers.
Change Apply(const NewVersion& version, Layers layers) {
  std::set<std::string> changed;
  for (const std::string& name : version.removed_layers) {
    if (layers.erase(name) == 0) {
      throw Error(Code::kInvalid, "environment '" + version.environment + "' has no layer '" +
                                      name + "' that could be removed");
    }
    changed.insert(name);
  }
  for (const LayerInfo& layer : version.layers) {
    const auto stood = layers.find(layer.name);
    if (stood == layers.end() || !SameLayer(stood->second, layer)) changed.insert(layer.name);
    layers[layer.name] = layer;
  }
  if (layers.empty()) {
    throw Error(Code::kInvalid,
                "a version of environment '" + version.environment + "' needs at least one layer");
  }
  Change change{{}, {changed.begin(), changed.end()}};
  for (auto& [name, layer] : layers) change.layers.push_back(std::move(layer));
  return change;
}

// The environment's key, standing at `number`.
std::int64_t PutEnvironment(Database& database, const NewVersion& version, int number, Time now) {
  database.Run(
      "INSERT INTO environments (id, type_iri, label, created, latest) VALUES (?1, ?2, ?3, ?4, ?5) "
      "ON CONFLICT (id) DO UPDATE SET latest = ?5, "
      "type_iri = CASE WHEN ?2 = '' THEN type_iri ELSE ?2 END, "
      "label = CASE WHEN ?3 = '' THEN label ELSE ?3 END",
      {version.environment, version.type_iri, version.label, now.time_since_epoch().count(),
       number});
  Query query = database.Ask("SELECT key FROM environments WHERE id = ?", {version.environment});
  query.Next();
  return query.Int(0);
}

void AddLayers(Database& database, std::int64_t version, const std::vector<LayerInfo>& layers) {
  for (const LayerInfo& layer : layers) {
    database.Run("INSERT INTO layers VALUES (?, ?, ?, ?, ?, ?, ?)",
                 {version, layer.name, layer.file_name, layer.media_type, layer.blob.sha256,
                  static_cast<std::int64_t>(layer.blob.size), nlohmann::json(layer.facts).dump()});
  }
}

void CheckLayer(const LayerInfo& layer) {
  CheckId(layer.name, "layer");
  CheckText(layer.file_name, "the file name of layer '" + layer.name + "'");
  CheckText(layer.media_type, "the media type of layer '" + layer.name + "'");
  for (const auto& [key, value] : layer.facts) {
    CheckText(key + value, "a fact of layer '" + layer.name + "'");
  }
}

}  // namespace

void CheckNewVersion(const NewVersion& version) {
  CheckId(version.environment, "environment");
  CheckText(version.type_iri, "the type");
  CheckText(version.label, "the label");
  CheckText(version.author, "the author");
  CheckText(version.note, "the note");
  std::set<std::string> named;
  for (const LayerInfo& layer : version.layers) {
    CheckLayer(layer);
    if (!named.insert(layer.name).second) {
      throw Error(Code::kInvalid, "layer '" + layer.name + "' is given twice");
    }
  }
  for (const std::string& name : version.removed_layers) {
    CheckId(name, "layer");
    if (!named.insert(name).second) {
      throw Error(Code::kInvalid, "layer '" + name + "' is both given and removed, or twice");
    }
  }
}

EnvironmentVersion AddVersion(Database& database, const NewVersion& version) {
  const std::optional<EnvironmentInfo> environment = FindEnvironment(database, version.environment);
  EnvironmentVersion added;
  added.environment = version.environment;
  added.number = environment ? environment->latest : 0;
  CheckIfMatch(version.if_match,
               environment ? std::optional<std::string>(added.etag()) : std::nullopt,
               "environment '" + version.environment + "'");
  Change change = Apply(version, LayersOf(database, environment));
  ++added.number;
  added.created = Now();
  added.author = version.author;
  added.note = version.note;
  added.type_iri =
      environment && version.type_iri.empty() ? environment->type_iri : version.type_iri;
  added.label = environment && version.label.empty() ? environment->label : version.label;
  added.layers = std::move(change.layers);
  added.changed_layers = std::move(change.changed);

  const std::int64_t key = PutEnvironment(database, version, added.number, added.created);
  database.Run(
      "INSERT INTO environment_versions (environment, number, created, author, note, changed, "
      "type_iri, label) VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
      {key, added.number, added.created.time_since_epoch().count(), added.author, added.note,
       lares::Join(added.changed_layers, " "), added.type_iri, added.label});
  AddLayers(database, database.last_key(), added.layers);
  return added;
}

std::optional<EnvironmentInfo> FindEnvironment(Database& database, const std::string& id) {
  Query query = database.Ask(LARES_ENVIRONMENT_COLUMNS "WHERE id = ?", {id});
  if (!query.Next()) return std::nullopt;
  return ReadEnvironment(query);
}

std::vector<EnvironmentInfo> ListEnvironments(Database& database) {
  Query query = database.Ask(LARES_ENVIRONMENT_COLUMNS "ORDER BY id");
  std::vector<EnvironmentInfo> environments;
  while (query.Next()) environments.push_back(ReadEnvironment(query));
  return environments;
}

EnvironmentVersion GetVersion(Database& database, const std::string& id, int number) {
  const std::optional<EnvironmentInfo> environment = FindEnvironment(database, id);
  if (!environment) throw NoEnvironment(id);
  const int wanted = number == 0 ? environment->latest : number;
  Query versions = database.Ask(
      "SELECT v.key, v.number, v.created, v.author, v.note, v.changed, v.type_iri, "
      "v.label " LARES_VERSIONS_JOINED "WHERE e.id = ? AND v.number = ?",
      {id, wanted});
  Query layers = database.Ask(
      "SELECT l.version, l.name, l.file_name, l.media_type, l.sha256, l.size, "
      "l.facts " LARES_VERSIONS_JOINED
      "JOIN layers l ON l.version = v.key WHERE e.id = ? AND v.number = ? ORDER BY l.name",
      {id, wanted});
  std::vector<EnvironmentVersion> found = Join(versions, layers, id);
  if (found.empty()) {
    throw Error(Code::kNotFound, "environment '" + id + "' has versions 1 to " +
                                     std::to_string(environment->latest) + ", not " +
                                     std::to_string(wanted));
  }
  return std::move(found.front());
}

std::vector<EnvironmentVersion> EnvironmentLog(Database& database, const std::string& id) {
  Query versions = database.Ask(
      "SELECT v.key, v.number, v.created, v.author, v.note, v.changed, v.type_iri, "
      "v.label " LARES_VERSIONS_JOINED "WHERE e.id = ? ORDER BY v.number DESC",
      {id});
  Query layers = database.Ask(
      "SELECT l.version, l.name, l.file_name, l.media_type, l.sha256, l.size, "
      "l.facts " LARES_VERSIONS_JOINED
      "JOIN layers l ON l.version = v.key WHERE e.id = ? ORDER BY v.number DESC, l.name",
      {id});
  std::vector<EnvironmentVersion> log = Join(versions, layers, id);
  if (log.empty()) throw NoEnvironment(id);
  return log;
}

}  // namespace lares::store
