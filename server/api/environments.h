// What the routes of environments share.
#pragma once

#include <string>

#include "server/api/context.h"
#include "server/http/message.h"

namespace lares::api {

// `number` as it stands in a path: "3" or "latest". Throws kInvalid, kNotFound (with similar
// names).
store::EnvironmentVersion FindVersion(const store::Store& store, const std::string& environment,
                                      const std::string& number);

// The answer to a version that was taken, with its ETag and Location.
http::Response VersionCreated(const server::Knowledge::VersionAnswer& answer);

}  // namespace lares::api
