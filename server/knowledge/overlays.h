// What lies over the catalogue when a question is asked: closed views, kept and renewed.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <list>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <unordered_map>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::server {

// A catalogue, or a catalogue with overlays: what was closed, and over which catalogue.
struct Snapshot {
  rdf::View view;
  std::uint64_t generation = 0;
};

// One document of a stack of overlays. `key` names its graph and its content.
struct OverlaySource {
  std::string key;
  std::function<rdf::Graph()> read;  // may throw Error
  // What is computed from its view goes over it, under the same key; null for nothing.
  std::function<rdf::View(const rdf::View&)> complete;
};

// Keeps the closed views of stacks of overlays. When the catalogue changes, a thread of low
// priority closes the stacks that are kept anew, the last used first; until a stack's turn comes,
// whoever asks for it gets the old one whole: the old catalogue with the old overlays. So a reader
// waits only for a stack of which there is no older view, and sees a change of the catalogue in a
// stack a little after the catalogue itself. Thread-safe.
class Overlays {
 public:
  // Keeps `capacity` stacks, the least recently used forgotten. `renewed` is called, on the thread
  // that closes, whenever readers get something newer of a stack than before.
  explicit Overlays(std::size_t capacity, std::function<void()> renewed = {});
  // Stops the closing that is under way.
  ~Overlays();
  Overlays(const Overlays&) = delete;
  Overlays& operator=(const Overlays&) = delete;

  // The view of `catalogue` with `stack` over it, lowest first. Threads that ask at once for what
  // is not there share one making of it; what that throws reaches them all and is not kept.
  // `top`, where given, is what the last of the stack would read.
  Snapshot Get(const Snapshot& catalogue, const std::vector<OverlaySource>& stack,
               const rdf::Graph* top = nullptr);
  // The catalogue of readers who come now: what is kept is due for it. A stack that cannot be
  // closed over it is forgotten, and whoever asks next meets the fault.
  void Renew(const Snapshot& catalogue);
  // Waits until nothing is due.
  void Wait();

  std::size_t size() const;

 private:
  struct Entry {
    std::string key;
    std::vector<OverlaySource> stack;
    std::shared_future<Snapshot> snapshot;  // not ready while it is first made
    bool is_due = false;
  };
  using Entries = std::list<Entry>;

  void MarkIfOld(Entry& entry);
  void DropOldest();
  void Forget(const std::string& key);
  void Work(const std::stop_token& stop);
  Entries::iterator NextDue();
  void RenewOne(const Snapshot& catalogue, const std::vector<OverlaySource>& stack,
                const std::stop_token& stop);

  const std::size_t capacity_;
  const std::function<void()> renewed_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  Entries by_use_;  // most recent first
  std::unordered_map<std::string, Entries::iterator> by_key_;
  std::optional<Snapshot> newest_;  // the catalogue to renew for
  bool is_working_ = false;         // on a stack that is no longer marked as due
  std::jthread worker_;             // last: it uses all else
};

}  // namespace lares::server
