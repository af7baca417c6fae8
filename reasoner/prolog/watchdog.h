// Interrupts goals that run beyond their time. Inside this folder only.
#pragma once

#include <chrono>
#include <condition_variable>
#include <list>
#include <mutex>
#include <thread>

namespace lares::prolog {

// One thread that raises a Prolog signal in each engine whose goal is late, again and again until
// the goal has ended, so that no catch/3 outlives its time. Thread-safe.
class Watchdog {
 public:
  using Clock = std::chrono::steady_clock;

  // `signal`: what StartProlog() returned.
  explicit Watchdog(int signal);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  // The engine attached to the calling thread is watched for the lifetime of this object.
  class Watch {
   public:
    Watch(Watchdog& watchdog, Clock::time_point deadline);
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    friend class Watchdog;
    struct Entry {
      int thread = 0;  // Prolog's number of the engine
      Clock::time_point next;
    };
    Watchdog& watchdog_;
    std::list<Entry>::iterator entry_;
  };

 private:
  void Run();

  const int signal_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Watch::Entry> entries_;
  Clock::time_point wakes_ = Clock::time_point::max();
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace lares::prolog
