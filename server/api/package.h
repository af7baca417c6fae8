// Task packages as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "server/knowledge/package.h"

namespace lares::api {

// With a link, a size and a SHA-256 for every file; docs/package.md shows it.
nlohmann::json ToJson(const server::TaskPackage& package);

}  // namespace lares::api
