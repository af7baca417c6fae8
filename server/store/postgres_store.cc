// A store over PostgreSQL and a folder of blobs that all its servers share.
#include <mutex>
#include <optional>
#include <semaphore>

#include "base/error.h"
#include "server/store/postgres.h"
#include "server/store/schema.h"
#include "server/store/sql_store.h"

namespace lares::store {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHoldCatalogue = "SELECT pg_advisory_lock(6171737302)";

// Of one server; PostgreSQL by itself allows 100 for all.
constexpr int kMaxConnections = 24;

// Connections, as many as were needed at once so far; broken ones are dropped. Who finds all of
// them in use waits.
class ConnectionPool {
 public:
  explicit ConnectionPool(std::string connection) : connection_(std::move(connection)) {}

  class Lease {
   public:
    explicit Lease(ConnectionPool& pool) : pool_(pool), turn_(pool), database_(pool.Take()) {}
    ~Lease() { pool_.GiveBack(std::move(database_)); }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    PostgresDatabase& operator*() const { return *database_; }
    // After the one at hand turned out to be broken: it may have been idle for long.
    void Renew() { database_ = std::make_unique<PostgresDatabase>(pool_.connection_); }

   private:
    // Of those that may have a connection at the same time.
    struct Turn {
      explicit Turn(ConnectionPool& pool) : turns(pool.turns_) { turns.acquire(); }
      ~Turn() { turns.release(); }
      std::counting_semaphore<kMaxConnections>& turns;
    };

    ConnectionPool& pool_;
    Turn turn_;
    std::unique_ptr<PostgresDatabase> database_;
  };

 private:
  std::unique_ptr<PostgresDatabase> Take() {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        auto database = std::move(idle_.back());
        idle_.pop_back();
        return database;
      }
    }
    return std::make_unique<PostgresDatabase>(connection_);
  }
  void GiveBack(std::unique_ptr<PostgresDatabase> database) {
    if (!database || !database->connected() || database->in_transaction()) return;
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(database));
  }

  const std::string connection_;
  std::counting_semaphore<kMaxConnections> turns_{kMaxConnections};
  std::mutex mutex_;
  std::vector<std::unique_ptr<PostgresDatabase>> idle_;
};

// A transaction on a connection that works: one that broke while it was idle is replaced.
class Session {
 public:
  Session(ConnectionPool& pool, Transaction::Kind kind) : lease_(pool) {
    try {
      transaction_.emplace(*lease_, kind);
    } catch (const Error&) {
      if ((*lease_).connected()) throw;
      lease_.Renew();
      transaction_.emplace(*lease_, kind);
    }
  }
  Database& database() const { return *lease_; }
  void Commit() { transaction_->Commit(); }

 private:
  ConnectionPool::Lease lease_;
  std::optional<Transaction> transaction_;
};

void CheckServer(PostgresDatabase& database) {
  for (const char* setting : {"fsync", "full_page_writes"}) {
    if (database.Setting(setting) == "on") continue;
    throw Error(Code::kInvalid, std::string("this PostgreSQL runs with ") + setting +
                                    " off: what it acknowledges may be lost")
        .WithHint(std::string("set ") + setting + " = on in its postgresql.conf");
  }
  if (database.Setting("server_encoding") != "UTF8") {
    throw Error(Code::kInvalid, "this PostgreSQL database has another encoding than UTF8")
        .WithHint("create it with: createdb --encoding UTF8 --template template0 NAME");
  }
}

void PrepareTables(PostgresDatabase& database) {
  Transaction transaction(database, Transaction::Kind::kWrite);
  if (database.AskInt("SELECT count(*) FROM pg_tables WHERE schemaname = current_schema() AND "
                      "tablename = 'schema_version'") == 0) {
    if (database.AskInt("SELECT count(*) FROM pg_tables WHERE schemaname = current_schema()") > 0) {
      throw Error(Code::kInvalid, "this PostgreSQL database holds tables of something else")
          .WithHint("give Lares a database, or a schema, of its own");
    }
    CreateTables(database);
  } else {
    CheckSchemaVersion(ReadSchemaVersion(database), "this PostgreSQL database",
                       "lares store migrate --store URL --blobs DIR");
  }
  transaction.Commit();
}

class CatalogueHold final : public Hold {
 public:
  explicit CatalogueHold(ConnectionPool& pool) : lease_(pool) {
    try {
      (*lease_).Run(kHoldCatalogue);
    } catch (const Error&) {
      if ((*lease_).connected()) throw;
      lease_.Renew();
      (*lease_).Run(kHoldCatalogue);
    }
  }
  ~CatalogueHold() override {
    try {
      (*lease_).Run("SELECT pg_advisory_unlock_all()");
    } catch (const Error&) {
      // The connection is gone, and the lock with it.
    }
  }

 private:
  ConnectionPool::Lease lease_;
};

class PostgresStore final : public SqlStore {
 public:
  explicit PostgresStore(const PostgresOptions& options)
      : SqlStore(options.blobs, RealFiles(), nullptr), pool_(options.connection) {
    const ConnectionPool::Lease lease(pool_);
    CheckServer(*lease);
    PrepareTables(*lease);
  }

  bool shared() const override { return true; }
  std::unique_ptr<Hold> HoldCatalogue() override { return std::make_unique<CatalogueHold>(pool_); }

  // The database may come back by itself: it is asked.
  std::string health() const override {
    const std::string blobs = SqlStore::health();
    if (!blobs.empty()) return blobs;
    try {
      Revision();
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }

 private:
  void Reading(const Work& work) const override {
    const Session session(pool_, Transaction::Kind::kRead);
    work(session.database());
  }

  void Writing(const Work& work) override {
    health_.Check();
    const std::lock_guard one_at_a_time(writer_mutex_);  // they would wait for each other there
    Session session(pool_, Transaction::Kind::kWrite);
    work(session.database());
    session.Commit();
  }

  std::vector<std::string> VerifyFile(Database&) const override { return {}; }

  std::mutex writer_mutex_;
  mutable ConnectionPool pool_;
};

}  // namespace

std::unique_ptr<Store> OpenPostgresStore(const PostgresOptions& options) {
  try {
    const fs::path blobs = fs::absolute(options.blobs).lexically_normal();
    fs::create_directories(blobs);
    return std::make_unique<PostgresStore>(PostgresOptions{options.connection, blobs});
  } catch (const std::system_error& error) {
    throw Error(Code::kIo, std::string("cannot open the folder of blobs: ") + error.what());
  }
}

}  // namespace lares::store
