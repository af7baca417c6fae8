// Goals from outside, each in a process of its own.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "ontology/triples/view.h"
#include "reasoner/prolog/expert.h"

namespace lares::prolog {

struct WorkerOptions {
  int max_running = 2;                          // goals at once
  int max_waiting = 8;                          // more are refused at once
  std::chrono::milliseconds wait_time{5'000};   // for one that runs to end
  std::chrono::milliseconds idle_time{30'000};  // that a goal waits for its answers to be taken
  std::size_t memory_bytes = std::size_t{512} << 20;  // of a worker, beyond its program and view
  std::string program = "/proc/self/exe";             // which calls RunWorker() when it is told to
};

struct GoalRequest {
  std::string goal;
  std::size_t max_answers = 1000;
  std::size_t max_bytes = std::size_t{64} << 20;  // of all answers together
  std::chrono::milliseconds time{10'000};         // that the goal may think
  bool prove = true;                              // false: in tests of the process alone
};

class Workers;

// One goal in its process. One thread at a time; it must not outlive its Workers. Destroying it
// kills and reaps the process in whatever state it is.
class RunningGoal {
 public:
  ~RunningGoal();
  RunningGoal(const RunningGoal&) = delete;
  RunningGoal& operator=(const RunningGoal&) = delete;

  // Waits for the next answer, a JSON object on one line; nothing when there is none any more: then
  // end() says how it ended, and the process is gone. `stop` ends the goal while it is waited for.
  std::optional<std::string> Next(std::stop_token stop = {});
  // Whether Next() would not have to wait, after waiting for that up to `time`.
  bool MoreWithin(std::chrono::milliseconds time) const;
  // Besides the kinds of expert.h: time, idle, escape (a system call that no goal may make), died
  // (the process ended by itself), worker (it could not begin).
  const GoalEnd& end() const { return end_; }

 private:
  friend class Workers;
  struct State;
  explicit RunningGoal(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
  GoalEnd end_;
};

// Thread-safe.
class Workers {
 public:
  explicit Workers(const WorkerOptions& options = {});
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  // The goal begins on a copy of `view`, which is made once and shared by goals for as long as the
  // view lives; `view` itself is not pinned. Throws kUnavailable when too many goals run, kTooLarge
  // for a goal of more than kMaxGoalBytes or a view beyond SnapshotFile::kMaxTriples.
  std::unique_ptr<RunningGoal> Start(const rdf::View& view, const GoalRequest& request);

  struct Counts {
    int running = 0;
    int waiting = 0;
    std::size_t snapshot_bytes = 0;  // of copies that are kept
    // How goals ended: yes, no, error, time, memory, idle, abandoned, escape, died, worker.
    std::map<std::string, std::uint64_t> ended;
    std::uint64_t refused = 0;  // no room
  };
  Counts counts() const;

  static constexpr std::size_t kMaxGoalBytes = 4u << 20;

 private:
  friend class RunningGoal;
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace lares::prolog
