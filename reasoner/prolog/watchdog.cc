#include "reasoner/prolog/watchdog.h"

#include <SWI-Prolog.h>

#include <algorithm>

namespace lares::prolog {
namespace {

constexpr std::chrono::milliseconds kRepeat{20};

}  // namespace

Watchdog::Watchdog(int signal) : signal_(signal), thread_([this] { Run(); }) {}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

// Goals normally end long before their time, so the thread is woken only for a deadline that is
// nearer than the one it sleeps towards.
Watchdog::Watch::Watch(Watchdog& watchdog, Clock::time_point deadline) : watchdog_(watchdog) {
  bool sooner = false;
  {
    const std::lock_guard lock(watchdog.mutex_);
    entry_ = watchdog.entries_.insert(watchdog.entries_.end(), {PL_thread_self(), deadline});
    sooner = deadline < watchdog.wakes_;
    if (sooner) watchdog.wakes_ = deadline;
  }
  if (sooner) watchdog.changed_.notify_all();
}

Watchdog::Watch::~Watch() {
  const std::lock_guard lock(watchdog_.mutex_);
  watchdog_.entries_.erase(entry_);
}

// The lock is held while a signal is raised, so the engine cannot be given back meanwhile.
void Watchdog::Run() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    const Clock::time_point now = Clock::now();
    wakes_ = Clock::time_point::max();
    for (Watch::Entry& entry : entries_) {
      if (entry.next <= now) {
        PL_thread_raise(entry.thread, signal_);
        entry.next = now + kRepeat;
      }
      wakes_ = std::min(wakes_, entry.next);
    }
    if (wakes_ == Clock::time_point::max()) {
      changed_.wait(lock);
    } else {
      changed_.wait_until(lock, wakes_);
    }
  }
}

}  // namespace lares::prolog
