// Which snapshots running questions hold, and since when.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <set>

#include "ontology/triples/view.h"

namespace lares::server {

// All members are thread-safe.
class Snapshots {
 public:
  using Clock = std::chrono::steady_clock;

  std::size_t count() const;
  // Of the snapshot that was pinned first; zero when there is none.
  Clock::duration OldestAge(Clock::time_point now = Clock::now()) const;

 private:
  friend class PinnedView;
  using Pins = std::multiset<Clock::time_point>;

  mutable std::mutex mutex_;
  Pins pins_;
};

// A view, counted in `snapshots` until this is dropped: with the question that it was taken for, on
// every way out. A question whose client does not read is ended by its connection (after
// ConnectionLimits::stall_time), so that nothing idle keeps a snapshot.
class PinnedView {
 public:
  PinnedView(std::shared_ptr<Snapshots> snapshots, rdf::View view,
             Snapshots::Clock::time_point now = Snapshots::Clock::now());
  ~PinnedView();
  PinnedView(const PinnedView&) = delete;
  PinnedView& operator=(const PinnedView&) = delete;

  const rdf::View& view() const { return view_; }

 private:
  std::shared_ptr<Snapshots> snapshots_;
  rdf::View view_;
  Snapshots::Pins::iterator pin_;
};

}  // namespace lares::server
