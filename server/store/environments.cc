#include "server/store/environments.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "server/store/conditions.h"
#include "server/store/search.h"

namespace lares::store {
namespace {

using Layers = std::map<std::string, LayerInfo>;

#define LARES_ENVIRONMENT_COLUMNS \
  "SELECT id, type_iri, label, created, latest, changed_at, count, key FROM environments "
#define LARES_VERSION_COLUMNS                                                             \
  "SELECT v.key, v.number, v.created, v.author, v.note, v.changed, v.type_iri, v.label, " \
  "v.robot, v.mission, v.origin, v.parents, v.base, v.was_head "
#define LARES_VERSIONS_JOINED \
  "FROM environments e JOIN environment_versions v ON v.environment = e.key "

EnvironmentInfo ReadEnvironment(const Query& row) {
  return {row.Text(0),
          row.Text(1),
          row.Text(2),
          Time(std::chrono::milliseconds(row.Int(3))),
          static_cast<int>(row.Int(4)),
          Time(std::chrono::milliseconds(row.Int(5))),
          static_cast<int>(row.Int(6))};
}

Origin OriginOf(const std::string& text) {
  if (text == ToString(Origin::kRollback)) return Origin::kRollback;
  return text == ToString(Origin::kMerge) ? Origin::kMerge : Origin::kPut;
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
  version.robot = row.Text(8);
  version.mission = row.Text(9);
  version.origin = OriginOf(row.Text(10));
  if (const std::string parents = row.Text(11); !parents.empty()) {
    for (const std::string& parent : Split(parents, ' ')) {
      version.parents.push_back(std::stoi(parent));
    }
  }
  version.base = static_cast<int>(row.Int(12));
  version.was_head = row.Int(13) != 0;
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

Layers LayersOf(Database& database, const std::string& environment, int number) {
  Layers layers;
  if (number == 0) return layers;
  EnvironmentVersion version = GetVersion(database, environment, number);
  for (LayerInfo& layer : version.layers) layers[layer.name] = std::move(layer);
  return layers;
}

struct Change {
  std::vector<LayerInfo> layers;
  std::vector<std::string> changed;
};

// What `version` makes of the layers of its base.
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

// The environment's key; it has one version more, and another head when `added` is one.
std::int64_t PutEnvironment(Database& database, const EnvironmentVersion& added) {
  const std::int64_t now = added.created.time_since_epoch().count();
  if (added.number == 1) {
    return database.AskInt(
        "INSERT INTO environments (id, type_iri, label, created, latest, count, changed_at) "
        "VALUES (?1, ?2, ?3, ?4, 1, 1, ?4) RETURNING key",
        {added.environment, added.type_iri, added.label, now});
  }
  if (!added.was_head) {
    return database.AskInt("UPDATE environments SET count = ? WHERE id = ? RETURNING key",
                           {added.number, added.environment});
  }
  return database.AskInt(
      "UPDATE environments SET latest = ?2, count = ?2, changed_at = ?3, type_iri = ?4, label = ?5 "
      "WHERE id = ?1 RETURNING key",
      {added.environment, added.number, now, added.type_iri, added.label});
}

std::string JoinNumbers(const std::vector<int>& numbers) {
  std::string joined;
  for (const int number : numbers) {
    joined += (joined.empty() ? "" : " ") + std::to_string(number);
  }
  return joined;
}

std::int64_t PutVersionRow(Database& database, std::int64_t environment,
                           const EnvironmentVersion& added) {
  return database.AskInt(
      "INSERT INTO environment_versions (environment, number, created, author, note, changed, "
      "type_iri, label, robot, mission, origin, parents, base, was_head) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) RETURNING key",
      {environment, added.number, added.created.time_since_epoch().count(), added.author,
       added.note, lares::Join(added.changed_layers, " "), added.type_iri, added.label, added.robot,
       added.mission, ToString(added.origin), JoinNumbers(added.parents), added.base,
       added.was_head ? 1 : 0});
}

// Parents, base, origin and place of a new version of `environment` (null: there is none yet).
void Place(const NewVersion& version, const EnvironmentInfo* environment,
           EnvironmentVersion& added) {
  const int head = environment != nullptr ? environment->latest : 0;
  const int count = environment != nullptr ? environment->count : 0;
  for (const int number : {version.parent, version.merged, version.restored}) {
    if (number < 0 || number > count) {
      throw Error(Code::kNotFound,
                  "environment '" + version.environment + "' has " +
                      (count == 0 ? "no version yet" : "versions 1 to " + std::to_string(count)) +
                      ", not " + std::to_string(number));
    }
  }
  const int parent = version.parent == 0 ? head : version.parent;
  if (version.merged != 0 && version.merged == parent) {
    throw Error(Code::kInvalid, "a version cannot be merged with itself");
  }
  added.number = count + 1;
  added.was_head = parent == head;
  if (parent != 0) added.parents.push_back(parent);
  if (version.merged != 0) added.parents.push_back(version.merged);
  added.base = version.restored != 0 ? version.restored : parent;
  added.origin = version.merged != 0     ? Origin::kMerge
                 : version.restored != 0 ? Origin::kRollback
                                         : Origin::kPut;
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
  CheckText(version.robot, "the robot");
  CheckText(version.mission, "the mission");
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
  Place(version, environment ? &*environment : nullptr, added);
  Change change = Apply(version, LayersOf(database, version.environment, added.base));
  // Never before the head that it follows, whatever the clock does: questions "as of" rest on it.
  added.created = std::max(Now(), environment ? environment->changed : Time{});
  added.author = version.author;
  added.robot = version.robot;
  added.mission = version.mission;
  added.note = version.note;
  const EnvironmentVersion base = added.base == 0
                                      ? EnvironmentVersion()
                                      : GetVersion(database, version.environment, added.base);
  added.type_iri = version.type_iri.empty() ? base.type_iri : version.type_iri;
  added.label = version.label.empty() ? base.label : version.label;
  added.layers = std::move(change.layers);
  added.changed_layers = std::move(change.changed);

  AddLayers(database, PutVersionRow(database, PutEnvironment(database, added), added),
            added.layers);
  if (added.was_head) UpdateKeys(database, added, version.keys);
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
      LARES_VERSION_COLUMNS LARES_VERSIONS_JOINED "WHERE e.id = ? AND v.number = ?", {id, wanted});
  Query layers = database.Ask(
      "SELECT l.version, l.name, l.file_name, l.media_type, l.sha256, l.size, "
      "l.facts " LARES_VERSIONS_JOINED
      "JOIN layers l ON l.version = v.key WHERE e.id = ? AND v.number = ? ORDER BY l.name",
      {id, wanted});
  std::vector<EnvironmentVersion> found = Join(versions, layers, id);
  if (found.empty()) {
    throw Error(Code::kNotFound, "environment '" + id + "' has versions 1 to " +
                                     std::to_string(environment->count) + ", not " +
                                     std::to_string(wanted));
  }
  return std::move(found.front());
}

std::vector<EnvironmentVersion> EnvironmentLog(Database& database, const std::string& id) {
  Query versions = database.Ask(
      LARES_VERSION_COLUMNS LARES_VERSIONS_JOINED "WHERE e.id = ? ORDER BY v.number DESC", {id});
  Query layers = database.Ask(
      "SELECT l.version, l.name, l.file_name, l.media_type, l.sha256, l.size, "
      "l.facts " LARES_VERSIONS_JOINED
      "JOIN layers l ON l.version = v.key WHERE e.id = ? ORDER BY v.number DESC, l.name",
      {id});
  std::vector<EnvironmentVersion> log = Join(versions, layers, id);
  if (log.empty()) throw NoEnvironment(id);
  return log;
}

int VersionAsOf(Database& database, const std::string& id, Time time) {
  if (!FindEnvironment(database, id)) throw NoEnvironment(id);
  const std::int64_t number = database.AskInt(
      "SELECT v.number " LARES_VERSIONS_JOINED
      "WHERE e.id = ? AND v.was_head = 1 AND v.created <= ? ORDER BY v.number DESC LIMIT 1",
      {id, time.time_since_epoch().count()});
  if (number == 0) {
    throw Error(Code::kNotFound,
                "environment '" + id + "' had no version yet at " + ToRfc3339(time));
  }
  return static_cast<int>(number);
}

}  // namespace lares::store
