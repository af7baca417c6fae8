// The OpenAPI 3.1 document: paths from the routes, words and schemas from operations.json.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/http/router.h"

namespace lares::api {

// The hand-written half: "info", "tags", "components" and, by operation id, "operations".
std::string_view OperationsJson();

// The whole document as JSON text. Throws kInternal when a route is not described.
std::string MakeOpenApi(const std::vector<http::Route>& routes);

// Where routes and description disagree, one sentence each; empty when they agree.
std::vector<std::string> CheckOpenApi(const std::vector<http::Route>& routes);

}  // namespace lares::api
