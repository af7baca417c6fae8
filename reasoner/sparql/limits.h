// What one evaluation may take: memory by account, time by deadline.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <stop_token>

#include "reasoner/sparql/query.h"

namespace lares::sparql {

// Bytes that an evaluation holds. Not thread-safe: one evaluation, one thread.
class Account {
 public:
  explicit Account(std::size_t limit) : limit_(limit) {}

  // Throws kTooLarge beyond the limit; nothing is charged then.
  void Charge(std::size_t bytes) {
    if (bytes > limit_ - used_) Refuse();
    used_ += bytes;
    peak_ = std::max(peak_, used_);
  }
  void Release(std::size_t bytes) { used_ -= std::min(bytes, used_); }
  std::size_t used() const { return used_; }
  std::size_t peak() const { return peak_; }
  std::size_t limit() const { return limit_; }

 private:
  [[noreturn]] void Refuse() const;

  std::size_t limit_;
  std::size_t used_ = 0;
  std::size_t peak_ = 0;
};

// A part of an account that is given back when it goes.
class Charge {
 public:
  explicit Charge(Account& account) : account_(account) {}
  ~Charge() { account_.Release(bytes_); }
  Charge(const Charge&) = delete;
  Charge& operator=(const Charge&) = delete;

  void Add(std::size_t bytes) {
    account_.Charge(bytes);
    bytes_ += bytes;
  }
  void Clear() {
    account_.Release(bytes_);
    bytes_ = 0;
  }

 private:
  Account& account_;
  std::size_t bytes_ = 0;
};

// Looks at the clock and the stop token once in a while.
class Guard {
 public:
  Guard(std::chrono::milliseconds timeout, std::stop_token stop);

  // One small piece of work; throws kTimeout when it is time to stop.
  void Tick() {
    if (++ticks_ % kBatch == 0) Check();
  }
  // A piece of work of about this many bytes.
  void Work(std::size_t bytes) {
    ticks_ += bytes / 64;
    if (bytes > 64 * kBatch) Check();
    Tick();
  }
  void Check() const;
  std::size_t ticks() const { return ticks_; }
  std::chrono::microseconds elapsed() const;

 private:
  static constexpr std::size_t kBatch = 512;
  std::chrono::milliseconds timeout_;
  std::chrono::steady_clock::time_point start_;
  std::stop_token stop_;
  std::size_t ticks_ = 0;
};

}  // namespace lares::sparql
