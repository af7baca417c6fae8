// Questions about object models, beside the documents themselves.
#pragma once

#include "server/api/context.h"
#include "server/http/message.h"

namespace lares::api {

// GET /v1/object-models?class=&room=&maker=&algorithm=&kind=
http::Response ListObjectModels(const http::Request& request, Context& context);

// GET /v1/object-models/typical?room=&robot=&prior=&strict=&min_probability=&max_models=&max_bytes=
http::Response TypicalObjectModels(const http::Request& request, Context& context);

}  // namespace lares::api
