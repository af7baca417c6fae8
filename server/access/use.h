// How much of its limits a token has used, in this process.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

namespace lares::access {

// As many requests at once as a minute allows, then a steady pace. Thread-safe.
class TokenBucket {
 public:
  using Clock = std::chrono::steady_clock;

  // Nothing when there is room for one more (which is taken), else how long to wait.
  std::optional<std::chrono::seconds> Take(std::int64_t per_minute, Clock::time_point now);

 private:
  std::mutex mutex_;
  double left_ = -1;  // below 0: not used yet
  Clock::time_point at_{};
};

// All members are thread-safe.
struct Use {
  TokenBucket requests;
  std::mutex mutex;  // of what follows
  std::int64_t queries_running = 0;
  std::uint64_t bytes_arriving = 0;  // announced or read, of writes that are not answered yet
};

// What one request holds of them; given back with it.
class Held {
 public:
  explicit Held(std::shared_ptr<Use> use) : use_(std::move(use)) {}
  ~Held();
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

  // False when `most` (0: any number) run already.
  bool BeginQuery(std::int64_t most);
  // Counts on: `bytes` of the body in all. What is arriving in all requests of the token.
  std::uint64_t Arriving(std::uint64_t bytes);
  // The write is answered: what it stored is counted elsewhere.
  void Arrived();
  // The query's answer is made.
  void EndQuery();
  std::uint64_t bytes() const { return bytes_; }
  void Read(std::uint64_t bytes) { read_ += bytes; }
  std::uint64_t bytes_read() const { return read_; }

 private:
  std::shared_ptr<Use> use_;
  bool is_query_ = false;
  std::uint64_t bytes_ = 0;  // counted in `bytes_arriving`
  std::uint64_t read_ = 0;   // of the body, so far
};

}  // namespace lares::access
