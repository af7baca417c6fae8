// Standing queries: each is asked again when what is known has changed, and whoever watches it is
// told what came and what went.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "reasoner/sparql/query.h"
#include "server/http/event_channel.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/snapshots.h"

namespace lares::api {

struct WatchOptions {
  std::size_t max_queries = 64;      // distinct ones
  std::size_t max_rows = 10'000;     // of an answer
  std::size_t max_bytes = 2u << 20;  // of an answer's rows
  std::chrono::milliseconds timeout{5'000};
  // Commits that follow each other sooner make one event.
  std::chrono::milliseconds settle_time{30};
};

struct Standing {
  std::string key;  // equal keys ask the same
  sparql::Query query;
  server::ViewRequest about;
};

// How much the first event says of the answer that stands.
enum class FirstEvent { kRows, kCount };

// One thread of its own asks all queries. What a watched query takes bounds how often it is asked:
// at most a tenth of the time. All members are thread-safe.
class WatchHub {
 public:
  WatchHub(server::Knowledge& knowledge, std::shared_ptr<server::Snapshots> snapshots,
           const WatchOptions& options = {});
  ~WatchHub();  // ends every stream

  // A place for the query among the distinct ones; given back when the last copy is dropped. Throws
  // "unavailable".
  std::shared_ptr<void> Reserve(const std::string& key);
  // The stream ends once `allowed`, asked every second or so, says no.
  void Subscribe(
      Standing standing, FirstEvent first, std::shared_ptr<http::EventChannel> channel,
      std::shared_ptr<void> place, std::function<bool()> allowed = [] { return true; });
  std::size_t subscribers() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lares::api
