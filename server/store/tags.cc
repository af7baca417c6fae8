#include "server/store/tags.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "server/store/conditions.h"
#include "server/store/environments.h"

namespace lares::store {
namespace {

#define LARES_TAG_COLUMNS "SELECT environment, name, number, created, author, note FROM tags "
#define LARES_PIN_COLUMNS "SELECT robot, environment, number, created, author FROM pins "

Time ToTime(std::int64_t millis) { return Time(std::chrono::milliseconds(millis)); }

Tag ReadTag(const Query& row) {
  return {row.Text(0),        row.Text(1), static_cast<int>(row.Int(2)),
          ToTime(row.Int(3)), row.Text(4), row.Text(5)};
}

Pin ReadPin(const Query& row) {
  return {row.Text(0), row.Text(1), static_cast<int>(row.Int(2)), ToTime(row.Int(3)), row.Text(4)};
}

bool IsNumber(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

void CheckTag(const Tag& tag) {
  CheckId(tag.environment, "environment");
  CheckId(tag.name, "tag");
  if (IsNumber(tag.name) || tag.name == "latest") {
    throw Error(Code::kInvalid,
                "'" + tag.name + "' cannot be a tag: numbers and 'latest' name versions already");
  }
  CheckText(tag.author, "the author");
  CheckText(tag.note, "the note");
}

void CheckPin(const Pin& pin) {
  CheckId(pin.robot, "robot");
  CheckId(pin.environment, "environment");
  CheckText(pin.author, "the author");
}

Tag PutTag(Database& database, const Tag& tag, bool move) {
  Tag put = tag;
  put.number = GetVersion(database, tag.environment, tag.number).number;
  put.created = Now();
  const std::optional<Tag> stood = FindTag(database, tag.environment, tag.name);
  if (stood && stood->number == put.number) return *stood;
  if (stood && !move) {
    throw Error(Code::kConflict, "tag '" + tag.name + "' of environment '" + tag.environment +
                                     "' is at version " + std::to_string(stood->number))
        .WithHint("ask for it to be moved, or choose another name");
  }
  database.Run(
      "INSERT INTO tags VALUES (?1, ?2, ?3, ?4, ?5, ?6) ON CONFLICT (environment, name) "
      "DO UPDATE SET number = ?3, created = ?4, author = ?5, note = ?6",
      {put.environment, put.name, put.number, put.created.time_since_epoch().count(), put.author,
       put.note});
  return put;
}

void DeleteTag(Database& database, const std::string& environment, const std::string& name) {
  if (!FindTag(database, environment, name)) {
    throw Error(Code::kNotFound,
                "environment '" + environment + "' has no tag '" + name.substr(0, 200) + "'");
  }
  database.Run("DELETE FROM tags WHERE environment = ? AND name = ?", {environment, name});
}

std::optional<Tag> FindTag(Database& database, const std::string& environment,
                           const std::string& name) {
  Query query =
      database.Ask(LARES_TAG_COLUMNS "WHERE environment = ? AND name = ?", {environment, name});
  if (!query.Next()) return std::nullopt;
  return ReadTag(query);
}

std::vector<Tag> Tags(Database& database, const std::string& environment) {
  Query query =
      database.Ask(LARES_TAG_COLUMNS "WHERE environment = ? ORDER BY name", {environment});
  std::vector<Tag> tags;
  while (query.Next()) tags.push_back(ReadTag(query));
  return tags;
}

Pin PutPin(Database& database, const Pin& pin) {
  Pin put = pin;
  put.number = GetVersion(database, pin.environment, pin.number).number;
  put.created = Now();
  database.Run(
      "INSERT INTO pins VALUES (?1, ?2, ?3, ?4, ?5) ON CONFLICT (robot, environment) "
      "DO UPDATE SET number = ?3, created = ?4, author = ?5",
      {put.robot, put.environment, put.number, put.created.time_since_epoch().count(), put.author});
  return put;
}

void DeletePin(Database& database, const std::string& robot, const std::string& environment) {
  if (!FindPin(database, robot, environment)) {
    throw Error(Code::kNotFound, "robot '" + robot.substr(0, 200) +
                                     "' is pinned to no version of environment '" +
                                     environment.substr(0, 200) + "'");
  }
  database.Run("DELETE FROM pins WHERE robot = ? AND environment = ?", {robot, environment});
}

std::optional<Pin> FindPin(Database& database, const std::string& robot,
                           const std::string& environment) {
  Query query =
      database.Ask(LARES_PIN_COLUMNS "WHERE robot = ? AND environment = ?", {robot, environment});
  if (!query.Next()) return std::nullopt;
  return ReadPin(query);
}

std::vector<Pin> Pins(Database& database, const std::string& robot) {
  Query query = database.Ask(
      LARES_PIN_COLUMNS "WHERE (?1 = '' OR robot = ?1) ORDER BY robot, environment", {robot});
  std::vector<Pin> pins;
  while (query.Next()) pins.push_back(ReadPin(query));
  return pins;
}

}  // namespace lares::store
