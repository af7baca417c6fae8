#include "tests/recipes/plan_walker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/recipes/xml.h"

namespace lares::testing {
namespace {

using nlohmann::json;
using Kind = SkillEvent::Kind;

constexpr long long kNever_ms = std::numeric_limits<long long>::max();

long long NextTick(long long time_ms) { return (time_ms + kTick_ms - 1) / kTick_ms * kTick_ms; }

struct TimedEvent {
  long long time_ms = 0;
  SkillEvent event;
};

// What is around a skill, outermost first: {"retry", attempts}, {"limit", ms}, {"wait", ms}.
struct Around {
  std::string what;
  long long number = 0;
};

void ReadFragment(const XmlElement& element, std::vector<Around>& around) {
  static const std::map<std::string, std::pair<std::string, std::string>> kNames = {
      {"RetryUntilSuccessful", {"retry", "num_attempts"}},
      {"Timeout", {"limit", "msec"}},
      {"Delay", {"wait", "delay_msec"}}};
  if (element.name == "Skill") return;
  const auto& [what, attribute] = kNames.at(element.name);
  around.push_back({what, std::stoll(element.attributes.at(attribute))});
  ReadFragment(element.children.at(0), around);
}

std::vector<Around> AroundSkill(const json& state) {
  std::vector<Around> around;
  if (state.contains("tree_fragment")) {
    ReadFragment(ParseXml(state.at("tree_fragment").get<std::string>()), around);
    return around;
  }
  around.push_back({"retry", 1 + state.value("retries", 0)});
  const double limit_s = state.value("time_limit_s", 0.0);
  if (limit_s > 0) around.push_back({"limit", std::llround(limit_s * 1000)});
  return around;
}

// One skill with what is around it, alone: nothing stops it but its own limits.
class SkillCourse {
 public:
  SkillCourse(const json& state, const SkillScript& script, int attempts_before)
      : id_(state.at("id")),
        around_(AroundSkill(state)),
        script_(script),
        attempt_(attempts_before) {}

  struct End {
    long long time_ms = 0;
    bool success = false;
    bool cut = false;  // by a limit further out, which is over at `time_ms`
  };
  End Run() { return Run(0, 0, kNever_ms); }
  const std::vector<TimedEvent>& events() const { return events_; }

 private:
  // From the tick `start_ms`, while `limit_ms` is not over.
  End Run(std::size_t depth, long long start_ms, long long limit_ms) {
    if (limit_ms <= start_ms) return {limit_ms, false, true};
    if (depth == around_.size()) return Attempt(start_ms, limit_ms);
    const Around& around = around_[depth];
    if (around.what == "retry") return Retry(depth, start_ms, limit_ms);
    if (around.what == "wait") {
      return Run(depth + 1, NextTick(start_ms + around.number), limit_ms);
    }
    const long long own_ms = start_ms + around.number;
    const End end = Run(depth + 1, start_ms, std::min(limit_ms, own_ms));
    if (!end.cut || limit_ms <= own_ms) return end;
    const long long seen_ms = NextTick(own_ms);
    if (limit_ms <= seen_ms) return {limit_ms, false, true};
    return {seen_ms, false, false};
  }

  End Retry(std::size_t depth, long long start_ms, long long limit_ms) {
    for (long long tried = 1;; ++tried) {
      const End end = Run(depth + 1, start_ms, limit_ms);
      if (end.cut || end.success || tried == around_[depth].number) return end;
      start_ms = end.time_ms == start_ms ? start_ms + kTick_ms : end.time_ms;
    }
  }

  End Attempt(long long start_ms, long long limit_ms) {
    const SkillAttempt attempt = script_(id_, attempt_++);
    Add(start_ms, {Kind::kStart, id_, ""});
    const long long end_ms = NextTick(start_ms + attempt.duration_ms);
    if (limit_ms <= end_ms) {
      Add(limit_ms, {Kind::kHalt, id_, ""});
      return {limit_ms, false, true};
    }
    Add(end_ms, {Kind::kEnd, id_, attempt.outcome});
    outcome_ = attempt.outcome;
    return {end_ms, attempt.outcome != "failed", false};
  }

  void Add(long long time_ms, SkillEvent event) { events_.push_back({time_ms, std::move(event)}); }

  const std::string id_;
  const std::vector<Around> around_;
  const SkillScript& script_;
  int attempt_ = 0;
  std::vector<TimedEvent> events_;
  std::string outcome_;

 public:
  // How the last attempt that came to its end went.
  const std::string& outcome() const { return outcome_; }
};

class Walker {
 public:
  Walker(const json& plan, const SkillScript& script) : plan_(plan), script_(script) {}

  PlanWalk Walk(std::size_t max_starts) {
    std::string id = plan_.at("start");
    for (;;) {
      const json& state = State(id);
      if (state.at("kind") == "end") {
        walk_.ended = true;
        walk_.success = state.at("success");
        break;
      }
      id = Next(id, state.at("kind") == "parallel" ? RunParallel(state) : RunSkill(state));
      if (Starts() > max_starts) break;
    }
    Truncate(max_starts);
    return walk_;
  }

 private:
  const json& State(const std::string& id) const {
    for (const json& state : plan_.at("states")) {
      if (state.at("id") == id) return state;
    }
    throw std::runtime_error("no state " + id);
  }

  std::string Next(const std::string& from, const std::string& outcome) const {
    for (const json& way : plan_.at("transitions")) {
      if (way.at("from") == from && way.at("outcome") == outcome) return way.at("to");
    }
    throw std::runtime_error("no way on from " + from + " after " + outcome);
  }

  std::string RunSkill(const json& state) {
    SkillCourse course(state, script_, attempts_[state.at("id")]);
    const auto end = course.Run();
    for (const TimedEvent& event : course.events()) Happen(event.event);
    return end.success ? course.outcome() : "failed";
  }

  // Each member's course alone, then all by time; of the same time the members in their order.
  std::string RunParallel(const json& state) {
    const json& members = state.at("members");
    std::vector<SkillCourse> courses;
    std::vector<SkillCourse::End> ends;
    for (const json& id : members) {
      courses.emplace_back(State(id), script_, attempts_[id]);
      ends.push_back(courses.back().Run());
    }
    const auto first = std::min_element(ends.begin(), ends.end(), [](auto& a, auto& b) {
      return std::pair(a.success, a.time_ms) < std::pair(b.success, b.time_ms);
    });
    const bool fails = !first->success;
    const auto failing = static_cast<std::size_t>(first - ends.begin());
    struct Moment {
      long long time_ms;
      std::size_t member;
      const SkillEvent* event;
    };
    std::vector<Moment> moments;
    for (std::size_t member = 0; member < courses.size(); ++member) {
      for (const TimedEvent& each : courses[member].events()) {
        const bool before = std::pair(each.time_ms, member) <= std::pair(first->time_ms, failing);
        // A limit is over before the tick of the same time.
        const bool halted = each.event.kind == Kind::kHalt && each.time_ms <= first->time_ms;
        if (!fails || before || halted) moments.push_back({each.time_ms, member, &each.event});
      }
    }
    std::stable_sort(moments.begin(), moments.end(), [](const Moment& a, const Moment& b) {
      const auto key = [](const Moment& each) {
        return std::tuple(each.time_ms, each.event->kind != Kind::kHalt, each.member);
      };
      return key(a) < key(b);
    });
    std::map<std::size_t, const SkillEvent*> last;
    for (const Moment& moment : moments) {
      Happen(*moment.event);
      last[moment.member] = moment.event;
    }
    for (const auto& [member, event] : last) {
      if (fails && event->kind == Kind::kStart) Happen({Kind::kHalt, event->state, ""});
    }
    return fails ? "failed" : "succeeded";
  }

  void Happen(const SkillEvent& event) {
    if (event.kind == Kind::kStart) ++attempts_[event.state];
    walk_.events.push_back(event);
  }

  std::size_t Starts() const {
    return static_cast<std::size_t>(
        std::count_if(walk_.events.begin(), walk_.events.end(),
                      [](const SkillEvent& event) { return event.kind == Kind::kStart; }));
  }

  void Truncate(std::size_t max_starts) {
    std::size_t starts = 0;
    for (std::size_t i = 0; i < walk_.events.size(); ++i) {
      if (walk_.events[i].kind != Kind::kStart || ++starts <= max_starts) continue;
      walk_.events.resize(i);
      walk_.ended = walk_.success = false;
      return;
    }
  }

  const json& plan_;
  const SkillScript& script_;
  std::map<std::string, int> attempts_;
  PlanWalk walk_;
};

}  // namespace

PlanWalk WalkPlan(const json& plan, const SkillScript& script, std::size_t max_starts) {
  return Walker(plan, script).Walk(max_starts);
}

}  // namespace lares::testing
