// A PostgreSQL of the tests' own: on a Unix socket in a temporary folder, reachable by nobody else.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace lares::store::testing {

class OwnPostgres {
 public:
  // Initialised and ready. Throws std::runtime_error with what its programs said.
  OwnPostgres();
  ~OwnPostgres();  // stopped, its folder removed
  OwnPostgres(const OwnPostgres&) = delete;
  OwnPostgres& operator=(const OwnPostgres&) = delete;

  // The connection of a new, empty database (a schema: those are made at once).
  std::string NewDatabase();
  // As if the machine had lost power: every process of it killed. Ready again when Start returns.
  void Kill();
  void Start();

 private:
  std::string Connection(const std::string& database) const;

  std::filesystem::path folder_;
  pid_t server_ = -1;
  int databases_ = 0;
};

// The one of this process, started when it is first asked for.
OwnPostgres& SharedPostgres();

}  // namespace lares::store::testing
