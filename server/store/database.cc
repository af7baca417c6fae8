#include "server/store/database.h"

#include "base/error.h"

namespace lares::store {

Transaction::Transaction(Database& database, Kind kind) : database_(database) {
  if (kind == Kind::kRead) {
    database_.BeginRead();
  } else {
    database_.BeginWrite();
  }
}

Transaction::~Transaction() {
  if (!database_.in_transaction()) return;
  try {
    database_.RollBack();
  } catch (const Error&) {
    // The connection rolls back when it closes; nothing of it was committed.
  }
}

}  // namespace lares::store
