// store_bench find [N]: N environments (100 000), then found by each kind of key.
// store_bench uploads LARES [MB] [COUNT]: COUNT uploads at once, MB each (1024, 16), into a server
// of its own: its memory, and the speed against the disk's own.
// store_bench soak LARES MINUTES: mixed load; memory and file handles at its end against its first
// tenth.
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

#include "benchmarks/measure.h"
#include "server/http/client.h"
#include "server/store/store.h"

namespace lares::bench {
namespace {

namespace fs = std::filesystem;

// --- Finding ----------------------------------------------------------------------------------

store::NewVersion Environment(int i, const store::Blob& blob, std::mt19937& random) {
  store::NewVersion version;
  version.environment = "room-" + std::to_string(100000 + i);
  version.label = "Room " + std::to_string(i) + (i % 10 == 0 ? " kitchen" : " office");
  store::LayerInfo layer;
  layer.name = i % 3 == 0 ? "octomap" : "semantic";
  layer.file_name = "f";
  layer.media_type = "text/turtle";
  layer.blob = blob;
  version.layers = {layer};
  std::vector<store::SearchKey> keys{
      {"room-number", std::to_string(i / 100) + "." + std::to_string(i % 100)},
      {"street", "Street " + std::to_string(i % 977)},
      {"building", "Building " + std::to_string(i % 5003)},
      {"level", std::to_string(i % 12)},
      {"type", i % 10 == 0 ? "x:Kitchen" : "x:Office"}};
  for (int k = 0; k < 3; ++k) {
    keys.push_back({"holds", "x:Object" + std::to_string(random() % 200)});
  }
  version.keys = keys;
  return version;
}

struct Asked {
  std::string what;
  store::EnvironmentSearch search;
};

std::vector<Asked> Questions(int count) {
  using Condition = store::SearchCondition;
  const auto one = [](const std::string& field, std::vector<std::string> values,
                      bool prefix = false) {
    store::EnvironmentSearch search;
    search.all_of = {Condition{field, std::move(values), prefix}};
    return search;
  };
  const std::string last =
      std::to_string((count - 1) / 100) + "." + std::to_string((count - 1) % 100);
  std::vector<Asked> asked{{"room number", one("room-number", {last})},
                           {"street", one("street", {"street 976"})},
                           {"building", one("building", {"building 5002"})},
                           {"level", one("level", {"11"})},
                           {"type", one("type", {"x:Kitchen"})},
                           {"what it holds", one("holds", {"x:Object7"})},
                           {"any of 100 classes", one("holds", {})},
                           {"layer", one("layer", {"octomap"})},
                           {"a word", one("word", {"kitchen"})},
                           {"a word's beginning", one("word", {"kitch"}, true)},
                           {"nothing (the first page)", {}}};
  for (int k = 0; k < 100; ++k) {
    asked[6].search.all_of[0].any_of.push_back("x:Object" + std::to_string(k));
  }
  store::EnvironmentSearch both = one("holds", {"x:Object7"});
  both.all_of.push_back({"type", {"x:Kitchen"}, false});
  both.all_of.push_back({"level", {"10"}, false});
  asked.push_back({"three of them at once", both});
  store::EnvironmentSearch recent;
  recent.changed_from = Now() - std::chrono::seconds(1);
  asked.push_back({"time", recent});
  return asked;
}

int Find(int count) {
  const TemporaryFolder folder;
  const std::unique_ptr<store::Store> store = store::OpenSqliteStore({folder.path()});
  const auto writer = store->NewBlob();
  writer->Append("x");
  const store::Blob blob = writer->Commit();
  std::mt19937 random(1);
  const double filling_s = SecondsOf([&] {
    for (int i = 0; i < count; ++i) store->PutVersion(Environment(i, blob, random));
  });
  Note(std::to_string(count) + " environments put, one by one, each synced", "s", filling_s);
  double slowest_ms = 0;
  std::string which;
  for (const Asked& asked : Questions(count)) {
    std::size_t found = 0;
    const double ms =
        1000 * MedianOfFive([&] {
          return SecondsOf([&] { found = store->SearchEnvironments(asked.search).size(); });
        });
    Note("  found by " + asked.what + ": " + std::to_string(found) + " of a page of 100", "ms", ms);
    if (ms > slowest_ms) which = asked.what;
    slowest_ms = std::max(slowest_ms, ms);
  }
  Row(std::to_string(count) + " environments, found by any key, slowest: " + which, "<", 20, "ms",
      slowest_ms);
  return 0;
}

// --- A server of one's own --------------------------------------------------------------------

class OwnServer {
 public:
  OwnServer(const std::string& lares, const std::string& data) {
    port_ = 20000 + static_cast<int>(::getpid() % 20000);
    pid_ = ::fork();
    if (pid_ == 0) {
      const int null = ::open("/dev/null", O_WRONLY);
      ::dup2(null, STDOUT_FILENO);
      ::dup2(null, STDERR_FILENO);
      ::execl(lares.c_str(), lares.c_str(), "serve", "--port", std::to_string(port_).c_str(),
              "--data", data.c_str(), "--log-level", "off", nullptr);
      ::_exit(127);
    }
    for (int tries = 0; tries < 400; ++tries) {
      try {
        if (http::Client(url()).Send({"GET", "/readyz", {}, {}, {}}).status == 200) return;
      } catch (const Error&) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    throw Error(Code::kTimeout, "the server does not become ready");
  }
  ~OwnServer() {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  OwnServer(const OwnServer&) = delete;
  OwnServer& operator=(const OwnServer&) = delete;
  std::string url() const { return "http://127.0.0.1:" + std::to_string(port_); }

  // "VmRSS", "VmHWM"
  double MegabytesOf(const std::string& field) const {
    std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
    for (std::string word; status >> word;) {
      double kilobytes = 0;
      if (word == field + ":" && status >> kilobytes) return kilobytes / 1024;
    }
    return 0;
  }
  int Handles() const {
    return static_cast<int>(std::distance(
        fs::directory_iterator("/proc/" + std::to_string(pid_) + "/fd"), fs::directory_iterator()));
  }

 private:
  int port_ = 0;
  pid_t pid_ = -1;
};

// --- Uploads ----------------------------------------------------------------------------------

// Bytes per second of one synced file, beside each other as many as there are uploads.
double DiskSpeed(const fs::path& folder, std::uint64_t bytes_each, int count) {
  const std::string piece(1 << 20, 'x');
  const double seconds = SecondsOf([&] {
    std::vector<std::thread> writers;
    for (int i = 0; i < count; ++i) {
      writers.emplace_back([&, i] {
        const fs::path file = folder / ("speed-" + std::to_string(i));
        const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
        for (std::uint64_t done = 0; done < bytes_each; done += piece.size()) {
          if (::write(fd, piece.data(), piece.size()) < 0) break;
        }
        ::fsync(fd);
        ::close(fd);
      });
    }
    for (std::thread& writer : writers) writer.join();
  });
  for (int i = 0; i < count; ++i) fs::remove(folder / ("speed-" + std::to_string(i)));
  return static_cast<double>(bytes_each) * count / seconds;
}

int Uploads(const std::string& lares, std::uint64_t megabytes, int count) {
  const TemporaryFolder folder;
  const std::uint64_t bytes = megabytes << 20;
  // One file, whose last bytes differ from upload to upload: so that each is a blob of its own.
  std::vector<fs::path> files;
  std::mt19937_64 random(5);
  std::string piece(1 << 20, '\0');
  for (int i = 0; i < count; ++i) {
    for (std::size_t at = 0; at < piece.size(); at += 8) {
      const std::uint64_t word = random();
      std::copy_n(reinterpret_cast<const char*>(&word), 8, piece.begin() + static_cast<long>(at));
    }
    files.push_back(fs::path(folder.path()) / ("upload-" + std::to_string(i)));
    std::ofstream file(files.back(), std::ios::binary);
    for (std::uint64_t done = 0; done < bytes; done += piece.size()) file << piece;
  }
  const double disk = DiskSpeed(folder.path(), bytes, count);
  OwnServer server(lares, folder.path() + "/store");
  const double before_mb = server.MegabytesOf("VmHWM");
  std::atomic<int> failed = 0;
  const double seconds = SecondsOf([&] {
    std::vector<std::thread> senders;
    for (int i = 0; i < count; ++i) {
      senders.emplace_back([&, i] {
        http::FormPart part;
        part.name = "features";
        part.file_name = "map.bin";
        part.file = files[static_cast<std::size_t>(i)];
        http::ClientRequest request{"POST",
                                    "/v1/environments/up-" + std::to_string(i) + "/versions",
                                    {},
                                    {},
                                    http::EncodeForm({part})};
        try {
          http::Client client(server.url(), {std::chrono::seconds(1800), "", ""});
          if (client.Send(request).status != 201) ++failed;
        } catch (const Error&) {
          ++failed;
        }
      });
    }
    for (std::thread& sender : senders) sender.join();
  });
  const std::string what =
      std::to_string(count) + " uploads at once, " + std::to_string(megabytes) + " MB each";
  Row(what + ": refused or broken", "==", 0, "uploads", failed);
  Row(what + ": the server's memory peak", "<", 200, "MB", server.MegabytesOf("VmHWM"));
  Note("  … of which before them", "MB", before_mb);
  Row(what + ": share of the disk's own synced speed", ">=", 60, "%",
      100 * static_cast<double>(bytes) * count / seconds / disk);
  Note("  … which is", "MB/s", disk / 1e6);
  return 0;
}

// --- Soak -------------------------------------------------------------------------------------

struct Sample {
  double memory_mb = 0;
  int handles = 0;
};

void MixedLoad(const std::string& url, int seed, const std::atomic<bool>& stop,
               std::atomic<std::uint64_t>& done, std::atomic<std::uint64_t>& failed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  http::Client client(url);
  const auto send = [&](http::ClientRequest request) {
    try {
      const int status = client.Send(request).status;
      if (status >= 500) ++failed;
    } catch (const Error&) {
      ++failed;
    }
    ++done;
  };
  const std::string name = "soak-" + std::to_string(seed);
  for (int i = 0; !stop; ++i) {
    switch (random() % 6) {
      case 0: {
        http::FormPart part;
        part.name = "trajectory";
        part.file_name = "path.txt";
        part.text = std::to_string(i) + ".5 0 0 0 0 0 0 1\n";
        send({"POST", "/v1/environments/" + name + "/versions", {}, {}, http::EncodeForm({part})});
        break;
      }
      case 1:
        send({"GET", "/v1/environments", {{"q", "soak*"}}, {}, {}});
        break;
      case 2:
        send({"GET", "/v1/likely-places", {{"object", "Cup"}}, {}, {}});
        break;
      case 3:
        send(
            {"GET", "/v1/environments/" + name + "/versions/latest/layers/trajectory", {}, {}, {}});
        break;
      case 4:
        send({"GET",
              "/v1/sparql",
              {{"query", "SELECT ?c WHERE { ?c rdfs:subClassOf lares:Container }"}},
              {},
              {}});
        break;
      default: {
        http::ClientRequest request{"PUT", "/v1/ontology/" + name, {}, {}, {}};
        request.headers.Set("Content-Type", "text/turtle");
        // The same few documents again and again: what is known does not grow.
        request.body =
            "<urn:soak:" + name + "> a <urn:soak:Thing" + std::to_string(random() % 3) + "> .";
        if (i % 20 == 0) send(request);
        break;
      }
    }
  }
}

int Soak(const std::string& lares, double minutes) {
  const TemporaryFolder folder;
  OwnServer server(lares, folder.path() + "/store");
  std::atomic<bool> stop = false;
  std::atomic<std::uint64_t> done = 0;
  std::atomic<std::uint64_t> failed = 0;
  std::vector<std::thread> clients;
  for (int i = 0; i < 4; ++i) {
    clients.emplace_back([&, i] { MixedLoad(server.url(), i, stop, done, failed); });
  }
  const auto end = std::chrono::steady_clock::now() +
                   std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                       std::chrono::duration<double, std::ratio<60>>(minutes));
  std::vector<Sample> samples;
  while (std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::duration<double>(minutes * 60 / 100));
    samples.push_back({server.MegabytesOf("VmRSS"), server.Handles()});
  }
  stop = true;
  for (std::thread& client : clients) client.join();
  // Caches fill in the first half; what still grows then is lost.
  const auto median_of = [&](std::size_t from, std::size_t to) {
    std::vector<double> values;
    for (std::size_t i = from; i < to; ++i) values.push_back(samples[i].memory_mb);
    return MedianOf(std::move(values));
  };
  const auto handles_of = [&](std::size_t from, std::size_t to) {
    int most = 0;
    for (std::size_t i = from; i < to; ++i) most = std::max(most, samples[i].handles);
    return most;
  };
  const std::size_t n = samples.size();
  const double third_mb = median_of(n / 2, n * 6 / 10);
  const double last_mb = median_of(n * 9 / 10, n);
  char what[160];
  std::snprintf(what, sizeof what, "soak, %.3g min, %llu requests", minutes,
                static_cast<unsigned long long>(done.load()));
  Row(std::string(what) + ": answered with 5xx or broken", "==", 0, "requests",
      static_cast<double>(failed));
  Row(std::string(what) + ": memory at the end, of that at half time", "<", 105, "%",
      100 * last_mb / third_mb);
  Note("  … which is", "MB", last_mb);
  Row(std::string(what) + ": file handles more at the end than at half time", "<=", 0, "handles",
      handles_of(n * 9 / 10, n) - handles_of(n / 2, n * 6 / 10));
  return 0;
}

}  // namespace
}  // namespace lares::bench

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  ::signal(SIGPIPE, SIG_IGN);
  try {
    if (what == "find") return lares::bench::Find(argc > 2 ? std::atoi(argv[2]) : 100000);
    if (what == "uploads" && argc > 2) {
      return lares::bench::Uploads(
          argv[2], argc > 3 ? static_cast<std::uint64_t>(std::atoll(argv[3])) : 1024,
          argc > 4 ? std::atoi(argv[4]) : 16);
    }
    if (what == "soak" && argc > 3) return lares::bench::Soak(argv[2], std::atof(argv[3]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "store_bench: %s\n", error.what());
    return 1;
  }
  std::fputs("store_bench find [N] | uploads LARES [MB] [COUNT] | soak LARES MINUTES\n", stderr);
  return 2;
}
