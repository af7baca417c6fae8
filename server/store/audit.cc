#include "server/store/audit.h"

#include <atomic>
#include <cstdio>
#include <random>

namespace lares::store {
namespace {

// Milliseconds, a count and random digits: ids sort as they were made, and those of several servers
// do not meet.
std::string NewAuditId(Time time) {
  static std::atomic<std::uint32_t> count{0};
  thread_local std::mt19937_64 random{std::random_device{}()};
  char id[48];
  std::snprintf(id, sizeof id, "%012llx%06x%014llx",
                static_cast<unsigned long long>(time.time_since_epoch().count()),
                count.fetch_add(1) & 0xffffffu,
                static_cast<unsigned long long>(random() & 0xffffffffffffffull));
  return id;
}

AuditRecord ReadAudit(const Query& row) {
  AuditRecord record;
  record.id = row.Text(0);
  record.time = Time(std::chrono::milliseconds(row.Int(1)));
  record.token = row.Text(2);
  record.label = row.Text(3);
  record.operation = row.Text(4);
  record.target = row.Text(5);
  record.environment = row.Text(6);
  record.version = static_cast<int>(row.Int(7));
  record.status = static_cast<int>(row.Int(8));
  record.result = row.Text(9);
  record.request_id = row.Text(10);
  record.bytes = static_cast<std::uint64_t>(row.Int(11));
  return record;
}

}  // namespace

void AddAudit(Database& database, const AuditRecord& record) {
  database.Run(
      "INSERT INTO audit (id, time, token, label, operation, target, environment, version, status, "
      "result, request_id, bytes) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      {NewAuditId(record.time), record.time.time_since_epoch().count(), record.token, record.label,
       record.operation, record.target, record.environment, record.version, record.status,
       record.result, record.request_id, static_cast<std::int64_t>(record.bytes)});
}

std::vector<AuditRecord> ListAudit(Database& database, const AuditQuery& query) {
  std::vector<AuditRecord> records;
  Query rows = database.Ask(
      "SELECT id, time, token, label, operation, target, environment, version, status, result, "
      "request_id, bytes FROM audit WHERE time >= ? AND (? = '' OR token = ?) AND "
      "(? = '' OR environment = ?) AND (? = '' OR id < ?) ORDER BY id DESC LIMIT ?",
      {query.since.time_since_epoch().count(), query.token, query.token, query.environment,
       query.environment, query.before, query.before, static_cast<std::int64_t>(query.limit)});
  while (rows.Next()) records.push_back(ReadAudit(rows));
  return records;
}

std::uint64_t BytesStoredSince(Database& database, const std::string& token, Time since) {
  Query query = database.Ask(
      "SELECT coalesce(sum(bytes), 0) FROM audit WHERE token = ? AND time >= ? AND status < 300",
      {token, since.time_since_epoch().count()});
  return query.Next() ? static_cast<std::uint64_t>(query.Int(0)) : 0;
}

}  // namespace lares::store
