#include "reasoner/prolog_worker/workers.h"

#include <condition_variable>
#include <csignal>
#include <list>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.h"
#include "reasoner/prolog_worker/frames.h"
#include "reasoner/prolog_worker/goal_process.h"
#include "reasoner/prolog_worker/snapshot_cache.h"

namespace lares::prolog {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

constexpr std::chrono::seconds kCpuGrace{2};

// What a process's end means when it did not say so itself.
GoalFault FaultOf(const ProcessEnd& end) {
  switch (end.signal) {
    case SIGSYS:
      return {"escape", "the goal tried what no goal may do, and was ended"};
    case SIGXCPU:
      return {"time", "the goal took longer than it may"};
    case SIGABRT:
    case SIGSEGV:
    case SIGBUS:
      return {"memory", "the goal's process broke down, as it does when memory is short"};
    case SIGKILL:
      return {"died", "the system ended the goal's process, as it does when memory is short"};
    default:
      return {"died", "the goal's process ended by itself"};
  }
}

std::string OutcomeOf(const GoalEnd& end) {
  if (!end.fault) return end.answers > 0 ? "yes" : "no";
  static const std::set<std::string> kOwn{"time", "memory", "idle", "escape", "died", "worker"};
  return kOwn.contains(end.fault->kind) ? end.fault->kind : "error";
}

// Believes nothing: a worker may have been taken over by its goal.
std::optional<GoalEnd> ReadEnd(const std::string& bytes) {
  try {
    const Json json = Json::parse(bytes);
    GoalEnd end;
    end.complete = json.at("complete");
    if (const auto fault = json.find("fault"); fault != json.end()) {
      end.fault = GoalFault{fault->at("kind"), fault->at("message"), fault->at("line"),
                            fault->at("column")};
    }
    return end;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

bool IsObject(const std::string& answer) {
  return answer.starts_with('{') && answer.find('\n') == std::string::npos && Json::accept(answer);
}

}  // namespace

// ---- What goals share --------------------------------------------------------------------------

struct Workers::State {
  explicit State(const WorkerOptions& wanted) : options(wanted) {}

  const WorkerOptions options;
  SnapshotCache snapshots;
  mutable std::mutex mutex;
  std::condition_variable changed;
  Counts counts;
  std::set<RunningGoal::State*> running;
  bool stopping = false;
  std::thread keeper;  // ends what nobody reads from

  void Enter();
  void Leave(const std::string& outcome);
  void KeepHouse();
};

struct RunningGoal::State {
  State(std::shared_ptr<Workers::State> workers_in, const GoalRequest& request_in)
      : workers(std::move(workers_in)), request(request_in), time_left(request.time) {}

  std::shared_ptr<Workers::State> workers;
  const GoalRequest request;
  std::optional<GoalProcess> process;
  std::optional<FrameReader> reader;
  Clock::duration time_left;
  std::size_t bytes = 0;
  // Under the workers' mutex.
  Clock::time_point last_taken = Clock::now();
  bool is_awaited = false;  // somebody is inside Next()
  bool was_idle = false;    // and so was killed

  ProcessEnd Reap();
  FrameReader::Got Wait(Frame* frame);
  std::optional<GoalEnd> EndAt(FrameReader::Got got, const Frame& frame);
};

// A place among the goals that may run.
void Workers::State::Enter() {
  std::unique_lock lock(mutex);
  const auto has_room = [this] { return counts.running < options.max_running || stopping; };
  if (!has_room()) {
    bool got_it = false;
    if (counts.waiting < options.max_waiting) {
      ++counts.waiting;
      got_it = changed.wait_for(lock, options.wait_time, has_room);
      --counts.waiting;
    }
    if (!got_it) {
      ++counts.refused;
      throw Error(Code::kUnavailable, "too many Prolog goals run already")
          .WithHint("ask again a little later");
    }
  }
  if (stopping) throw Error(Code::kUnavailable, "the server is stopping");
  ++counts.running;
}

void Workers::State::Leave(const std::string& outcome) {
  {
    const std::lock_guard lock(mutex);
    --counts.running;
    ++counts.ended[outcome];
  }
  changed.notify_all();
}

void Workers::State::KeepHouse() {
  constexpr std::chrono::milliseconds kPeriod{250};
  std::unique_lock lock(mutex);
  while (!stopping) {
    changed.wait_for(lock, kPeriod, [this] { return stopping; });
    snapshots.Prune();
    for (RunningGoal::State* goal : running) {
      if (goal->is_awaited || Clock::now() - goal->last_taken < options.idle_time) continue;
      goal->was_idle = true;
      goal->process->Kill();
    }
  }
}

Workers::Workers(const WorkerOptions& options) : state_(std::make_shared<State>(options)) {
  state_->keeper = std::thread([state = state_.get()] { state->KeepHouse(); });
}

Workers::~Workers() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stopping = true;
    for (RunningGoal::State* goal : state_->running) goal->process->Kill();
  }
  state_->changed.notify_all();
  state_->keeper.join();
}

std::unique_ptr<RunningGoal> Workers::Start(const rdf::View& view, const GoalRequest& request) {
  if (request.goal.size() > kMaxGoalBytes) {
    throw Error(Code::kTooLarge,
                "the goal has more than " + std::to_string(kMaxGoalBytes) + " bytes");
  }
  const Json json{
      {"goal", request.goal},
      {"max_answers", request.max_answers},
      {"memory_bytes", state_->options.memory_bytes},
      {"cpu_s", std::chrono::ceil<std::chrono::seconds>(request.time + kCpuGrace).count()},
      {"prove", request.prove}};
  const std::string bytes = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  state_->Enter();
  auto goal = std::make_unique<RunningGoal::State>(state_, request);
  try {
    const std::shared_ptr<const SnapshotFile> snapshot = state_->snapshots.Of(view);
    goal->process.emplace(state_->options.program);
    goal->reader.emplace(goal->process->socket());
    SendFrame(goal->process->socket(), FrameKind::kRequest, bytes, snapshot->fd());
  } catch (...) {
    state_->Leave("worker");
    throw;
  }
  const std::lock_guard lock(state_->mutex);
  goal->last_taken = Clock::now();
  state_->running.insert(goal.get());
  return std::unique_ptr<RunningGoal>(new RunningGoal(std::move(goal)));
}

Workers::Counts Workers::counts() const {
  const std::lock_guard lock(state_->mutex);
  Counts counts = state_->counts;
  counts.snapshot_bytes = state_->snapshots.bytes();
  return counts;
}

// ---- One goal ----------------------------------------------------------------------------------

RunningGoal::RunningGoal(std::unique_ptr<State> state) : state_(std::move(state)) {}

RunningGoal::~RunningGoal() {
  if (state_ == nullptr) return;
  state_->Reap();
  state_->workers->Leave("abandoned");
}

ProcessEnd RunningGoal::State::Reap() {
  {
    const std::lock_guard lock(workers->mutex);
    workers->running.erase(this);
  }
  const ProcessEnd end = process->End();
  process.reset();
  return end;
}

// The next frame, within what is left of the goal's time: only waiting for the goal counts.
FrameReader::Got RunningGoal::State::Wait(Frame* frame) {
  const auto mark = [this](bool awaited) {
    const std::lock_guard lock(workers->mutex);
    is_awaited = awaited;
    last_taken = Clock::now();
  };
  mark(true);
  const Clock::time_point begin = Clock::now();
  const FrameReader::Got got = reader->Next(frame, begin + time_left);
  time_left -= Clock::now() - begin;
  mark(false);
  return got;
}

// Nothing while the goal goes on.
std::optional<GoalEnd> RunningGoal::State::EndAt(FrameReader::Got got, const Frame& frame) {
  const auto fault = [](const char* kind, const char* message) {
    GoalEnd end;
    end.complete = false;
    end.fault = GoalFault{kind, message};
    return end;
  };
  if (got == FrameReader::Got::kTimeout) return fault("time", "the goal took longer than it may");
  if (got == FrameReader::Got::kFrame && frame.kind == FrameKind::kEnd) {
    if (const auto end = ReadEnd(frame.bytes)) return end;
    return fault("escape", "the goal's process talks nonsense, and was ended");
  }
  if (got == FrameReader::Got::kNonsense ||
      (got == FrameReader::Got::kFrame && !IsObject(frame.bytes))) {
    return fault("escape", "the goal's process talks nonsense, and was ended");
  }
  if (got == FrameReader::Got::kFrame) return std::nullopt;
  GoalEnd end;
  end.complete = false;
  const ProcessEnd process_end = Reap();  // from here on nobody else looks at was_idle
  end.fault = was_idle ? GoalFault{"idle", "nobody took the goal's answers for too long"}
                       : FaultOf(process_end);
  return end;
}

bool RunningGoal::MoreWithin(std::chrono::milliseconds time) const {
  return state_ == nullptr || state_->reader->InputWithin(time);
}

std::optional<std::string> RunningGoal::Next(std::stop_token stop) {
  if (state_ == nullptr) return std::nullopt;
  Frame frame;
  const FrameReader::Got got = [&] {
    const std::stop_callback on_stop(stop, [this] { state_->process->Kill(); });
    return state_->Wait(&frame);
  }();
  std::optional<GoalEnd> end = state_->EndAt(got, frame);
  if (!end && state_->bytes + frame.bytes.size() > state_->request.max_bytes) {
    end.emplace();
    end->complete = false;
  }
  if (!end) {
    state_->bytes += frame.bytes.size();
    ++end_.answers;
    return std::move(frame.bytes);
  }
  end->answers = end_.answers;
  end_ = std::move(*end);
  if (state_->process) state_->Reap();
  state_->workers->Leave(OutcomeOf(end_));
  state_.reset();
  return std::nullopt;
}

}  // namespace lares::prolog
