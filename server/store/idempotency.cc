#include "server/store/idempotency.h"

namespace lares::store {
namespace {

std::int64_t ToMs(Time time) { return time.time_since_epoch().count(); }

}  // namespace

KeyRecord TakeKey(Database& database, const std::string& key, Time now, const KeyLimits& limits) {
  // Those in progress too: by then their server has ended without a word.
  database.Run("DELETE FROM idempotency_keys WHERE created < ?", {ToMs(now - limits.lifetime)});
  KeyRecord record;
  {
    Query query = database.Ask(
        "SELECT fingerprint, written, status, headers, body FROM idempotency_keys WHERE key = ?",
        {key});
    if (query.Next()) {
      record.fingerprint = query.Text(0);
      record.written = query.Text(1);
      record.status = static_cast<int>(query.Int(2));
      record.headers = query.Text(3);
      record.body = query.Text(4);
      record.state = record.status != 0        ? KeyRecord::State::kAnswered
                     : !record.written.empty() ? KeyRecord::State::kWritten
                                               : KeyRecord::State::kInProgress;
      return record;
    }
  }
  database.Run(
      "INSERT INTO idempotency_keys "
      "(key, fingerprint, written, status, created, size, headers, body) "
      "VALUES (?, '', '', 0, ?, 0, '', '')",
      {key, ToMs(now)});
  return record;
}

void FinishKey(Database& database, const std::string& key, const KeyRecord& answer) {
  database.Run(
      "UPDATE idempotency_keys SET fingerprint = ?, status = ?, size = ?, headers = ?, body = ? "
      "WHERE key = ?",
      {answer.fingerprint, answer.status,
       static_cast<std::int64_t>(answer.body.size() + answer.headers.size()), answer.headers,
       answer.body, key});
}

void ReleaseKey(Database& database, const std::string& key) {
  database.Run("DELETE FROM idempotency_keys WHERE key = ? AND status = 0", {key});
}

void MarkWritten(Database& database, const std::string& key, const std::string& fingerprint,
                 const std::string& written) {
  if (key.empty()) return;
  database.Run(
      "UPDATE idempotency_keys SET fingerprint = ?, written = ? WHERE key = ? AND status = 0",
      {fingerprint, written, key});
}

void ForgetInterruptedKeys(Database& database) {
  database.Run("DELETE FROM idempotency_keys WHERE status = 0 AND written = ''");
}

void PruneKeys(Database& database, const KeyLimits& limits) {
  std::int64_t count = 0;
  std::int64_t bytes = 0;
  std::int64_t cutoff = -1;
  {
    Query query = database.Ask(
        "SELECT created, size FROM idempotency_keys WHERE status <> 0 ORDER BY created DESC");
    while (cutoff < 0 && query.Next()) {
      bytes += query.Int(1);
      if (++count > limits.max_count || bytes > limits.max_bytes) cutoff = query.Int(0);
    }
  }
  if (cutoff < 0) return;
  database.Run("DELETE FROM idempotency_keys WHERE status <> 0 AND created <= ?", {cutoff});
}

}  // namespace lares::store
