// What the routes of environments share.
#pragma once

#include <optional>
#include <string>

#include "base/time.h"
#include "server/api/context.h"
#include "server/http/message.h"

namespace lares::api {

// `name` as it stands in a path: "3", "latest" or a tag. Throws kInvalid, kNotFound (with similar
// names among those that the caller's token reaches).
store::EnvironmentVersion FindVersion(const http::Request& request, const store::Store& store,
                                      const std::string& environment, const std::string& name);

// The version that the path's {id} and {number} name; with "latest", ?as_of= a time asks for what
// was the newest then, and ?robot= for what that robot is pinned to, if it is.
store::EnvironmentVersion FindVersion(const http::Request& request, Context& context);

// What a question's ?version= (a number or a tag) or ?as_of= (a time) say of `environment`; 0 for
// neither. Throws kInvalid when there is no environment that they could be of.
int ChosenVersion(const http::Request& request, const store::Store& store,
                  const std::string& environment);

// A time of a query parameter, RFC 3339 in UTC. Throws kInvalid.
std::optional<Time> QueryTime(const http::Request& request, const std::string& name);

// The answer to a version that was taken, with its ETag and Location.
http::Response VersionCreated(const server::Knowledge::VersionAnswer& answer);

}  // namespace lares::api
