// What the audit log keeps of a write.
#pragma once

#include <cstdint>

#include "base/time.h"
#include "server/access/table.h"
#include "server/http/message.h"
#include "server/http/router.h"
#include "server/store/store.h"

namespace lares::access {

// `request.grant` is set. The target is where the answer says the thing is, else where the request
// went; the version is that of the answer's ETag.
store::AuditRecord RecordOf(const http::Route& route, const Rule& rule,
                            const http::Request& request, const http::Response& response,
                            std::uint64_t bytes, Time now);

}  // namespace lares::access
