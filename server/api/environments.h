// What the routes of environments share.
#pragma once

#include <string>

#include "server/api/context.h"
#include "server/http/message.h"

namespace lares::api {

// The version that the path's {id} and {number} ("3" or "latest") name. Throws kInvalid, kNotFound
// (with similar names among those that the caller's token reaches).
store::EnvironmentVersion FindVersion(const http::Request& request, const store::Store& store);

// The answer to a version that was taken, with its ETag and Location.
http::Response VersionCreated(const server::Knowledge::VersionAnswer& answer);

}  // namespace lares::api
