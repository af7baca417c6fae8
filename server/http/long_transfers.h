// Transfers that last long (holding a thread, or a place as an event stream), and how many of them
// there may be.
#pragma once

#include <atomic>

namespace lares::http {

// All members are thread-safe.
class LongTransfers {
 public:
  explicit LongTransfers(int max) : max_(max) {}

  // False when there are as many as there may be.
  bool TryBegin() {
    if (running_.fetch_add(1) < max_) return true;
    running_.fetch_sub(1);
    return false;
  }
  void End() { running_.fetch_sub(1); }
  int max() const { return max_; }
  int running() const { return running_; }

 private:
  const int max_;
  std::atomic<int> running_{0};
};

}  // namespace lares::http
