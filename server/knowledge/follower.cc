#include "server/knowledge/follower.h"

#include <condition_variable>
#include <mutex>

#include "base/error.h"

namespace lares::server {
namespace {

void Follow(const std::stop_token& stop, Knowledge& knowledge, std::chrono::milliseconds period) {
  std::mutex mutex;
  std::condition_variable_any stopped;
  std::int64_t seen = 0;
  while (!stop.stop_requested()) {
    try {
      const std::int64_t revision = knowledge.store().Revision();
      if (revision != seen) {
        const bool is_first = seen == 0;
        seen = revision;
        // Documents that lie above the catalogue are read from the store when they are asked for;
        // whoever watches a question has to be told.
        if (!knowledge.Refresh() && !is_first) knowledge.changes().Notify();
      }
    } catch (const Error&) {
      // The store's health tells why; it is asked again.
    }
    std::unique_lock lock(mutex);
    stopped.wait_for(lock, stop, period, [] { return false; });
  }
}

}  // namespace

Follower::Follower(Knowledge& knowledge, std::chrono::milliseconds period) {
  if (!knowledge.store().shared()) return;
  thread_ = std::jthread(
      [&knowledge, period](const std::stop_token& stop) { Follow(stop, knowledge, period); });
}

}  // namespace lares::server
