// The audit log as rows: who wrote what, and how it ended. Free functions over a connection; the
// caller holds the transaction.
#pragma once

#include <string>
#include <vector>

#include "server/store/database.h"
#include "server/store/store.h"

namespace lares::store {

// The id is made here, in the order of time.
void AddAudit(Database& database, const AuditRecord& record);
std::vector<AuditRecord> ListAudit(Database& database, const AuditQuery& query);  // newest first
// Bytes that writes of the token which were done took in, since a time.
std::uint64_t BytesStoredSince(Database& database, const std::string& token, Time since);

}  // namespace lares::store
