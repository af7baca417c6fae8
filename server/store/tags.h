// Names of versions, and robots that stay with one. Each function runs in the caller's transaction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/store/database.h"
#include "server/store/store.h"

namespace lares::store {

// Throws kInvalid when a name or a text cannot be stored.
void CheckTag(const Tag& tag);
void CheckPin(const Pin& pin);

// As the members of Store.
Tag PutTag(Database& database, const Tag& tag, bool move);
void DeleteTag(Database& database, const std::string& environment, const std::string& name);
std::optional<Tag> FindTag(Database& database, const std::string& environment,
                           const std::string& name);
std::vector<Tag> Tags(Database& database, const std::string& environment);

Pin PutPin(Database& database, const Pin& pin);
void DeletePin(Database& database, const std::string& robot, const std::string& environment);
std::optional<Pin> FindPin(Database& database, const std::string& robot,
                           const std::string& environment);
std::vector<Pin> Pins(Database& database, const std::string& robot);

}  // namespace lares::store
