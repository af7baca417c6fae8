// Goals in worker processes, for tests.
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "reasoner/prolog_worker/workers.h"
#include "tests/reasoner/prolog_fixture.h"

namespace lares::prolog::testing {

// All answers of a goal and how it ended.
struct Answers {
  std::vector<std::string> answers;
  GoalEnd end;
  std::chrono::milliseconds took{};

  std::string kind() const { return end.fault ? end.fault->kind : ""; }
  std::string message() const { return end.fault ? end.fault->message : ""; }
};

inline Answers Collect(RunningGoal& goal) {
  Answers answers;
  const auto begin = std::chrono::steady_clock::now();
  while (auto answer = goal.Next()) answers.answers.push_back(std::move(*answer));
  answers.end = goal.end();
  answers.took = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - begin);
  return answers;
}

// Children of this process, zombies included.
inline int Children() {
  int children = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream file(task.path() / "children");
    for (int pid = 0; file >> pid;) ++children;
  }
  return children;
}

inline int OpenDescriptors() {
  int count = 0;
  for ([[maybe_unused]] const auto& fd : std::filesystem::directory_iterator("/proc/self/fd")) {
    ++count;
  }
  return count;
}

inline long ResidentBytes() {
  long size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return resident * 4096;
}

// A few cups on two tables.
inline rdf::View Kitchen() {
  const rdf::Term type = rdf::Term::Iri("http://www.w3.org/1999/02/22-rdf-syntax-ns#type");
  const rdf::Term cup = rdf::Term::Iri("https://w3id.org/lares#Cup");
  return With(EmptyView(), "environment:kitchen",
              {{Named("cup1"), type, cup},
               {Named("cup2"), type, cup},
               {Named("cup1"), Named("on"), Named("table")},
               {Named("cup1"), Named("name"), rdf::Term::Literal("grüne Tasse", "", "de")}},
              {{Named("cup2"), Named("on"), Named("table")}});
}

class WorkersTest : public ::testing::Test {
 protected:
  static WorkerOptions Wanted() {
    WorkerOptions options;
    options.memory_bytes = std::size_t{256} << 20;
    return options;
  }

  Answers Ask(const std::string& goal) { return AskFor(GoalRequest{.goal = goal}); }
  Answers AskFor(const GoalRequest& request) { return Collect(*workers_.Start(view_, request)); }

  rdf::View view_ = Kitchen();
  Workers workers_{Wanted()};
};

}  // namespace lares::prolog::testing
