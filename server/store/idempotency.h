// Idempotency keys: a request that is sent again with its key is answered again and not done again.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "base/time.h"
#include "server/store/database.h"

namespace lares::store {

// What is known of a key.
struct KeyRecord {
  enum class State {
    kNew,         // nothing: it is the caller's now, until Finish or Release
    kInProgress,  // somebody else's
    kWritten,     // its write is done, but the answer was not kept before the process ended
    kAnswered,
  };
  State state = State::kNew;
  std::string fingerprint;  // of the request; kWritten and kAnswered
  std::string written;      // what the write made, "lab/3"; may be empty
  int status = 0;           // kAnswered, with the next two
  std::string headers;      // as the caller wrote them
  std::string body;
};

struct KeyLimits {
  std::chrono::milliseconds lifetime = std::chrono::hours(24);
  std::int64_t max_count = 10'000;
  std::int64_t max_bytes = 256 << 20;  // of all answers together
};

// All members are thread-safe; each has been made durable when it returns.
class IdempotencyKeys {
 public:
  virtual ~IdempotencyKeys() = default;
  virtual KeyRecord Take(const std::string& key) = 0;
  // Of a key that was kNew: the answer to give from now on.
  virtual void Finish(const std::string& key, const KeyRecord& answer) = 0;
  // Of a key that was kNew: nothing was written, the next request is judged anew.
  virtual void Release(const std::string& key) = 0;
};

// The table, in words that PostgreSQL takes too. `status` is 0 until the answer is known.
inline constexpr const char* kIdempotencyTables = R"sql(
CREATE TABLE IF NOT EXISTS idempotency_keys (
  key TEXT PRIMARY KEY,
  fingerprint TEXT NOT NULL,
  written TEXT NOT NULL,
  status BIGINT NOT NULL,
  created BIGINT NOT NULL,
  size BIGINT NOT NULL,
  headers TEXT NOT NULL,
  body TEXT NOT NULL
);
CREATE INDEX IF NOT EXISTS idempotency_keys_by_age ON idempotency_keys (created);
)sql";

// The same in the caller's transaction.
KeyRecord TakeKey(Database& database, const std::string& key, Time now, const KeyLimits& limits);
void FinishKey(Database& database, const std::string& key, const KeyRecord& answer);
void ReleaseKey(Database& database, const std::string& key);
// Together with the write that the key is for: whatever happens next, it is known to be done. An
// empty key is none.
void MarkWritten(Database& database, const std::string& key, const std::string& fingerprint,
                 const std::string& written);
// Keys of a process that has ended, whose requests wrote nothing. Only while no other process uses
// the store.
void ForgetInterruptedKeys(Database& database);
// The oldest answers beyond the limits.
void PruneKeys(Database& database, const KeyLimits& limits);

}  // namespace lares::store
