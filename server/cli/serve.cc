#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <optional>
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
  std::string tls_certificate;
  std::string tls_key;
  bool behind_proxy = false;
  std::vector<std::string> allowed_hosts;
  std::size_t max_connections = 1024;
  std::optional<std::size_t> max_connections_per_peer;

  bool has_tls() const { return !tls_certificate.empty(); }
  bool is_beyond_loopback() const { return !http::IsLoopbackHost(host); }
};

constexpr rlim_t kMostFiles = 65'536;
constexpr std::size_t kConnectionsPerPeer = 128;  // of other machines

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

// Other machines are served only if they have to say who they are, and nobody can listen in.
void CheckReach(const ServeOptions& serve, const store::Store& store) {
  if (!serve.is_beyond_loopback() && !serve.behind_proxy) return;
  if (serve.is_beyond_loopback() && !serve.has_tls() && !serve.behind_proxy) {
    throw Error(Code::kForbidden,
                "'" + serve.host + "' is not this machine's loopback, and there is no TLS")
        .WithHint("give --tls-cert and --tls-key, or --behind-proxy when a proxy does that");
  }
  if (!store.HasTokens()) {
    throw Error(Code::kForbidden,
                "other machines are served only with tokens, and the store has none")
        .WithHint("lares token create --role admin --label me " + OptionsOf(serve.place));
  }
}

http::OriginRules OriginRulesOf(const ServeOptions& serve) {
  http::OriginRules rules{serve.allowed_hosts, serve.has_tls(), serve.behind_proxy};
  if (serve.is_beyond_loopback() && serve.host != "0.0.0.0" && serve.host != "::") {
    rules.hosts.push_back(serve.host);
  }
  return rules;
}

http::ServerOptions ServerOptionsOf(const ServeOptions& serve) {
  http::ServerOptions options;
  options.host = serve.host;
  options.port = serve.port;
  options.beyond_loopback = serve.is_beyond_loopback();
  if (serve.has_tls()) options.tls = http::TlsOptions{serve.tls_certificate, serve.tls_key};
  options.loop.max_connections = serve.max_connections;
  // Behind a proxy every connection is the proxy's.
  const bool bounds_peers = serve.is_beyond_loopback() && !serve.behind_proxy;
  options.loop.max_connections_per_peer =
      serve.max_connections_per_peer.value_or(bounds_peers ? kConnectionsPerPeer : 0);
  return options;
}

// Each connection takes a descriptor, beside those of the store: as many as the system allows.
void AllowManyFiles() {
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return;
  files.rlim_cur = std::max(files.rlim_cur, std::min(files.rlim_max, kMostFiles));
  ::setrlimit(RLIMIT_NOFILE, &files);
}

void Serve(const ServeOptions& serve) {
  const StopSignals signals;
  AllowManyFiles();
  http::SetLogLevel(http::ParseLogLevel(serve.log_level));
  const std::unique_ptr<store::Store> store = OpenStore(serve.place);
  CheckReach(serve, *store);
  prolog::EnginePool engines;
  server::Knowledge knowledge(*store, engines);
  knowledge.IndexEnvironments();
  const server::Follower follower(knowledge);
  api::Context context{*store, knowledge};
  context.backups = BackupFolder(serve);
  context.origins = OriginRulesOf(serve);
  http::Server server(api::MakeService(context), ServerOptionsOf(serve));
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

void AddAccessOptions(CLI::App& command, ServeOptions& serve) {
  auto* certificate = command.add_option("--tls-cert", serve.tls_certificate,
                                         "certificate (PEM), with those that lead to its root");
  auto* key = command.add_option("--tls-key", serve.tls_key, "its key (PEM)");
  certificate->needs(key);
  key->needs(certificate);
  command.add_flag("--behind-proxy", serve.behind_proxy,
                   "a proxy in front does TLS; what it says in X-Forwarded-… gives nobody rights");
  command
      .add_option("--allow-host", serve.allowed_hosts,
                  "a name that requests may be sent to (Host); again for more")
      ->expected(1)
      ->take_all();
  command.add_option("--max-connections", serve.max_connections, "at the same time")
      ->check(CLI::Range(16, 100'000))
      ->capture_default_str();
  command.add_option("--max-connections-per-peer", serve.max_connections_per_peer,
                     "of one address, 0: no bound (default: 128 when other machines are served)");
}

}  // namespace

void AddServe(CLI::App& app, const Options&) {
  auto* command =
      AddCommand(app, "serve", "Run the server",
                 "  lares serve\n  lares serve --port 9090 --data ./lares-data\n"
                 "  lares serve --store postgresql://lares@db/lares --blobs /srv/lares\n"
                 "  lares serve --host 0.0.0.0 --tls-cert host.pem --tls-key host.key "
                 "--allow-host lares.example.org");
  auto serve = std::make_shared<ServeOptions>();
  command->add_option("--port", serve->port, "0: any free one")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  AddStorePlace(*command, serve->place);
  command->add_option("--backups", serve->backups,
                      "folder that backups go to (default: backups, in --data)");
  command
      ->add_option("--host", serve->host,
                   "address to listen on; one that other machines reach takes tokens, and TLS or "
                   "--behind-proxy")
      ->capture_default_str();
  AddAccessOptions(*command, *serve);
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
