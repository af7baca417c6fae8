#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "base/error.h"
#include "reasoner/prolog/engine_pool.h"
#include "server/api/api.h"
#include "server/cli/command.h"
#include "server/cli/print.h"
#include "server/cli/service_manager.h"
#include "server/cli/store_place.h"
#include "server/http/log.h"
#include "server/http/origin_check.h"
#include "server/http/server.h"
#include "server/knowledge/follower.h"
#include "server/knowledge/knowledge.h"
#include "server/store/store.h"

namespace lares::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kGrace{30};

struct ServeOptions {
  std::string host = "127.0.0.1";
  int port = 8080;
  StorePlace place;
  std::string backups;
  std::string log_level = "info";
};

// SIGINT and SIGTERM are waited for instead of handled: blocked before any thread begins, so that
// every thread inherits it.
class StopSignals {
 public:
  StopSignals() {
    ::sigemptyset(&signals_);
    ::sigaddset(&signals_, SIGINT);
    ::sigaddset(&signals_, SIGTERM);
    ::pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
  }
  int Wait() const {
    int signal = 0;
    ::sigwait(&signals_, &signal);
    return signal;
  }

 private:
  sigset_t signals_{};
};

// Beside the data; nowhere for a store that is in no folder, unless one is named.
fs::path BackupFolder(const ServeOptions& serve) {
  if (!serve.backups.empty()) return fs::absolute(serve.backups);
  return serve.place.store.empty() ? fs::absolute(DataFolder(serve.place)) / "backups" : fs::path();
}

void Serve(const ServeOptions& serve) {
  const StopSignals signals;
  http::SetLogLevel(http::ParseLogLevel(serve.log_level));
  const std::unique_ptr<store::Store> store = OpenStore(serve.place);
  prolog::EnginePool engines;
  server::Knowledge knowledge(*store, engines);
  knowledge.IndexEnvironments();
  const server::Follower follower(knowledge);
  api::Context context{*store, knowledge};
  context.backups = BackupFolder(serve);
  http::ServerOptions options;
  options.host = serve.host;
  options.port = serve.port;
  http::Server server(api::MakeService(context), options);
  http::Log(http::LogLevel::kInfo, "ready",
            {{"url", server.url()}, {"data", Describe(serve.place)}});
  Print("Lares is ready at " + server.url() + "\n");
  TellServiceManager("READY=1\nSTATUS=Ready at " + server.url());

  signals.Wait();
  http::Log(http::LogLevel::kInfo, "stopping");
  TellServiceManager("STOPPING=1");
  std::thread([signals] {
    signals.Wait();
    std::_Exit(1);  // asked twice: at once
  }).detach();
  if (!server.Stop(kGrace)) http::Log(http::LogLevel::kWarning, "requests were cut off");
  http::Log(http::LogLevel::kInfo, "stopped");
}

}  // namespace

void AddServe(CLI::App& app, const Options&) {
  auto* command =
      AddCommand(app, "serve", "Run the server, for programs of this machine",
                 "  lares serve\n  lares serve --port 9090 --data ./lares-data\n"
                 "  lares serve --store postgresql://lares@db/lares --blobs /srv/lares");
  auto serve = std::make_shared<ServeOptions>();
  command->add_option("--port", serve->port, "0: any free one")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  AddStorePlace(*command, serve->place);
  command->add_option("--backups", serve->backups,
                      "folder that backups go to (default: backups, in --data)");
  command->add_option("--host", serve->host, "a loopback address: 127.0.0.1, localhost or ::1")
      ->check([](const std::string& text) {
        return http::IsLoopbackHost(text) ? std::string()
                                          : "'" + text + "' is not this machine's loopback";
      })
      ->capture_default_str();
  command->add_option("--log-level", serve->log_level, "debug, info, warning, error or off")
      ->check([](const std::string& text) {
        try {
          http::ParseLogLevel(text);
          return std::string();
        } catch (const Error& error) {
          return std::string(error.what());
        }
      })
      ->capture_default_str();
  command->callback([serve] { Serve(*serve); });
}

}  // namespace lares::cli
