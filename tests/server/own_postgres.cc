#include "tests/server/own_postgres.h"

#include <fcntl.h>
#include <grp.h>
#include <libpq-fe.h>
#include <pwd.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace lares::store::testing {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrograms = "/usr/lib/postgresql/15/bin/";

fs::path TemporaryPlace() { return fs::is_directory("/dev/shm") ? "/dev/shm" : "/tmp"; }

// PostgreSQL refuses to run as root: then it runs as the user that its package made.
struct User {
  uid_t uid = ::getuid();
  gid_t gid = ::getgid();
};
User ServerUser() {
  User user;
  if (user.uid != 0) return user;
  const passwd* postgres = ::getpwnam("postgres");
  if (postgres == nullptr) throw std::runtime_error("there is no user 'postgres'");
  return {postgres->pw_uid, postgres->pw_gid};
}

// In the child, after fork.
[[noreturn]] void Become(const User& user, const std::vector<std::string>& command,
                         const fs::path& log) {
  if (::getuid() != user.uid) {
    if (::setgroups(0, nullptr) != 0 || ::setgid(user.gid) != 0 || ::setuid(user.uid) != 0) {
      ::_exit(126);
    }
  }
  // Set after the user: a change of user clears it. Fast shutdown when the tests die.
  ::prctl(PR_SET_PDEATHSIG, SIGINT);
  const int fd = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  ::dup2(fd, STDOUT_FILENO);
  ::dup2(fd, STDERR_FILENO);
  if (::chdir("/") != 0) ::_exit(126);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::setenv("LC_ALL", "C.UTF-8", 1);
  ::execv(arguments[0], arguments.data());
  ::_exit(127);
}

pid_t Spawn(const User& user, const std::vector<std::string>& command, const fs::path& log) {
  const pid_t child = ::fork();
  if (child == 0) Become(user, command, log);
  if (child < 0) throw std::runtime_error("cannot fork");
  return child;
}

std::string TextOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool Answers(const std::string& connection) {
  const std::unique_ptr<PGconn, decltype(&PQfinish)> made(PQconnectdb(connection.c_str()),
                                                          &PQfinish);
  return PQstatus(made.get()) == CONNECTION_OK;
}

}  // namespace

OwnPostgres::OwnPostgres() {
  std::string pattern = (TemporaryPlace() / "lares-postgres-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = pattern;
  const User user = ServerUser();
  if (::chown(folder_.c_str(), user.uid, user.gid) != 0) throw std::runtime_error("chown failed");
  const pid_t init = Spawn(user,
                           {std::string(kPrograms) + "initdb", "-D", folder_ / "data", "-U",
                            "lares", "-A", "trust", "-E", "UTF8", "--locale=C.UTF-8", "-N"},
                           folder_ / "log");
  int status = 0;
  ::waitpid(init, &status, 0);
  if (status != 0) throw std::runtime_error("initdb failed: " + TextOf(folder_ / "log"));
  Start();
}

OwnPostgres::~OwnPostgres() {
  if (server_ > 0) {
    ::kill(server_, SIGINT);
    ::waitpid(server_, nullptr, 0);
  }
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void OwnPostgres::Start() {
  // The socket's path has to be short.
  server_ = Spawn(ServerUser(),
                  {std::string(kPrograms) + "postgres", "-D", folder_ / "data", "-k", folder_, "-c",
                   "listen_addresses=", "-c", "fsync=on", "-c", "max_connections=100"},
                  folder_ / "log");
  for (int tries = 0; tries < 600; ++tries) {
    if (Answers(Connection("postgres"))) return;
    if (::waitpid(server_, nullptr, WNOHANG) == server_) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  throw std::runtime_error("PostgreSQL does not start: " + TextOf(folder_ / "log"));
}

void OwnPostgres::Kill() {
  // Its children notice that it is gone, and end without writing anything.
  ::kill(server_, SIGKILL);
  ::waitpid(server_, nullptr, 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  std::error_code ignored;
  fs::remove(folder_ / "data" / "postmaster.pid", ignored);
}

std::string OwnPostgres::Connection(const std::string& database) const {
  return "host=" + folder_.string() + " user=lares dbname=" + database;
}

std::string OwnPostgres::NewDatabase() {
  const std::string name =
      "store_" + std::to_string(::getpid()) + "_" + std::to_string(++databases_);
  const std::unique_ptr<PGconn, decltype(&PQfinish)> connection(
      PQconnectdb(Connection("postgres").c_str()), &PQfinish);
  const std::unique_ptr<PGresult, decltype(&PQclear)> made(
      PQexec(connection.get(), ("CREATE SCHEMA " + name).c_str()), &PQclear);
  if (PQresultStatus(made.get()) != PGRES_COMMAND_OK) {
    throw std::runtime_error(PQerrorMessage(connection.get()));
  }
  return Connection("postgres") + " options='-c search_path=" + name + "'";
}

OwnPostgres& SharedPostgres() {
  static OwnPostgres postgres;
  return postgres;
}

}  // namespace lares::store::testing
