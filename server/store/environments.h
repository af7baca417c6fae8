// Environments and their versions in the database. Each function runs in the caller's transaction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/store/database.h"
#include "server/store/store.h"

namespace lares::store {

// Throws kInvalid when an id or a text cannot be stored, or the layers contradict one another.
void CheckNewVersion(const NewVersion& version);

// Adds the next version; unchanged layers are carried over from its base. Blobs are not looked at.
// Throws kPreconditionFailed, kInvalid when it would have no layer, kNotFound for a parent that
// there is not.
EnvironmentVersion AddVersion(Database& database, const NewVersion& version);

// As the members of Store.
std::optional<EnvironmentInfo> FindEnvironment(Database& database, const std::string& id);
std::vector<EnvironmentInfo> ListEnvironments(Database& database);
EnvironmentVersion GetVersion(Database& database, const std::string& id, int number);
std::vector<EnvironmentVersion> EnvironmentLog(Database& database, const std::string& id);
int VersionAsOf(Database& database, const std::string& id, Time time);

}  // namespace lares::store
