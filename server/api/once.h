// Idempotency-Key: a write that is asked for again with its key is answered again, not done again.
#pragma once

#include <functional>
#include <string>

#include "server/api/context.h"
#include "server/http/message.h"

namespace lares::api {

// What a handler needs to tie its write to the key, for once the body is read. Without a key both
// are "".
struct RequestMark {
  std::string key;
  std::function<std::string()> fingerprint = [] { return std::string(); };
};

struct OnceHandler {
  std::function<http::Response(const http::Request&, const RequestMark&)> handle;
  // The answer of a write that was done (as KeyRecord::written says) by a process that ended before
  // it answered. Needed by handlers that tie their write to the key.
  std::function<http::Response(const std::string& written)> recover;
};

// Answers of success are kept for the key; what was refused wrote nothing and frees it. The same
// request is one of the same method, path, query, conditions and content; a form is the same when
// its parts are, whatever lies between them. Throws "idempotency-key-reused",
// "request-in-progress", kInvalid for a key that is not 1 to 255 visible characters.
http::Handler Once(Context& context, OnceHandler handler);
// The same for a write that does no harm when it is done again.
http::Handler Once(Context& context, http::Handler handler);

}  // namespace lares::api
