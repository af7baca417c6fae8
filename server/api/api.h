// The whole HTTP interface as one service.
#pragma once

#include <memory>

#include "server/api/context.h"
#include "server/http/service.h"

namespace lares::api {

// Every route, without anything behind it: enough for the OpenAPI document.
http::Router MakeRouter(Context& context);

// `context` must outlive the service.
std::shared_ptr<const http::Service> MakeService(Context& context);

}  // namespace lares::api
