// The audit log of writes.
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "server/api/answers.h"
#include "server/api/context.h"

namespace lares::api {
namespace {

Json ToJson(const store::AuditRecord& record) {
  Json json{{"id", record.id},
            {"time", ToRfc3339(record.time)},
            {"token", record.token},
            {"label", record.label},
            {"operation", record.operation},
            {"target", record.target},
            {"environment", nullptr},
            {"version", nullptr},
            {"status", record.status},
            {"result", record.result},
            {"bytes", record.bytes},
            {"request_id", record.request_id}};
  if (!record.environment.empty()) json["environment"] = record.environment;
  if (record.version > 0) json["version"] = record.version;
  return json;
}

// Newest first: ?after= is the id of the last one that was seen.
http::Response ListAudit(const http::Request& request, Context& context) {
  store::AuditQuery query;
  if (const auto since = request.Query("since")) {
    const auto time = FromRfc3339(*since);
    if (!time) {
      throw Error(Code::kInvalid,
                  "?since= is a time such as 2026-01-31T12:00:00Z, not '" + *since + "'");
    }
    query.since = *time;
  }
  query.token = request.Query("token").value_or("");
  query.environment = request.Query("environment").value_or("");
  query.before = request.Query("after").value_or("");
  query.limit = QueryNumber(request, "limit", 100, 1, 1000);
  const auto limit = static_cast<std::size_t>(query.limit);
  ++query.limit;  // one more tells whether there is a next page
  std::vector<store::AuditRecord> records = context.store.ListAudit(query);
  const bool more = records.size() > limit;
  if (more) records.resize(limit);
  Json json{{"items", Json::array()}, {"next", nullptr}};
  for (const store::AuditRecord& record : records) json["items"].push_back(ToJson(record));
  if (more) json["next"] = records.back().id;
  return JsonAnswer(json);
}

}  // namespace

void AddAuditRoutes(http::Router& router, Context& context) {
  router.Add({"GET",
              "/v1/audit",
              "listAudit",
              [&context](const http::Request& request) { return ListAudit(request, context); },
              {},
              0});
}

}  // namespace lares::api
