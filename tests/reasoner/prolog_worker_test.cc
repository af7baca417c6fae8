// Goals in processes of their own: answers, limits, and what is left afterwards.
#include "reasoner/prolog_worker/workers.h"

#include <csignal>
#include <thread>

#include "base/error.h"
#include "tests/reasoner/prolog_worker_fixture.h"

namespace lares::prolog::testing {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST_F(WorkersTest, YesNoAndErrorAreThreeThings) {
  const Answers yes = Ask("rdf(X, 'http://x/on', 'http://x/table')");
  EXPECT_THAT(yes.answers,
              ::testing::UnorderedElementsAre(R"({"X":{"type":"uri","value":"http://x/cup1"}})",
                                              R"({"X":{"type":"uri","value":"http://x/cup2"}})"));
  EXPECT_EQ(yes.kind(), "");
  EXPECT_TRUE(yes.end.complete);
  const Answers no = Ask("rdf('http://x/table', _, _)");
  EXPECT_THAT(no.answers, IsEmpty());
  EXPECT_EQ(no.kind(), "");
  const Answers error = Ask("X is foo + 1");
  EXPECT_THAT(error.answers, IsEmpty());
  EXPECT_EQ(error.kind(), "type");
  const Workers::Counts counts = workers_.counts();
  EXPECT_EQ(counts.ended.at("yes"), 1u);
  EXPECT_EQ(counts.ended.at("no"), 1u);
  EXPECT_EQ(counts.ended.at("error"), 1u);
}

TEST_F(WorkersTest, RulesAndPrefixesAreThere) {
  EXPECT_THAT(Ask("findall(X, rdf(X, rdf:type, lares:'Cup'), Cups), length(Cups, N)").answers,
              ElementsAre(HasSubstr(R"("N":2)")));
  EXPECT_THAT(Ask("subclass(lares:'Cup', lares:'Cup')").answers, ElementsAre("{}"));
  EXPECT_THAT(Ask("rdf_asserted(X, 'http://x/on', _)").answers, SizeIs(1));
  EXPECT_THAT(Ask("rdf_graph(G)").answers, ElementsAre(HasSubstr("environment:kitchen")));
}

TEST_F(WorkersTest, AnAnswerBeforeAFaultIsGiven) {
  const Answers answers = Ask("member(X, [1, a]), _ is X + 1");
  EXPECT_THAT(answers.answers, ElementsAre(R"({"X":1})"));
  EXPECT_EQ(answers.kind(), "type");
  EXPECT_EQ(answers.end.answers, 1u);
}

TEST_F(WorkersTest, NoMoreAnswersThanAskedFor) {
  const Answers answers = AskFor({.goal = "repeat", .max_answers = 3});
  EXPECT_THAT(answers.answers, SizeIs(3));
  EXPECT_FALSE(answers.end.complete);
  EXPECT_EQ(answers.kind(), "");
  EXPECT_TRUE(AskFor({.goal = "member(X, [1, 2, 3])", .max_answers = 3}).end.complete);
}

TEST_F(WorkersTest, NoMoreBytesThanAskedFor) {
  const Answers answers =
      AskFor({.goal = "repeat, X = aaaaaaaaaa", .max_answers = 1'000'000, .max_bytes = 10'000});
  EXPECT_FALSE(answers.end.complete);
  EXPECT_LT(answers.answers.size(), 1000u);
}

TEST_F(WorkersTest, TimeIsWhatTheGoalThinksNotWhatItsReaderTakes) {
  const auto goal = workers_.Start(view_, {.goal = "between(1, 5, X)", .time = 2000ms});
  EXPECT_TRUE(goal->Next());
  std::this_thread::sleep_for(2500ms);
  EXPECT_THAT(Collect(*goal).answers, SizeIs(4));
  EXPECT_EQ(goal->end().answers, 5u);
}

TEST_F(WorkersTest, AReaderThatStopsIsWaitedForInABoundedBuffer) {
  const auto goal = workers_.Start(
      view_, {.goal = "between(1, 200000, X)", .max_answers = 1'000'000, .time = 60'000ms});
  EXPECT_TRUE(goal->Next());
  const long before = ResidentBytes();
  std::this_thread::sleep_for(300ms);
  EXPECT_LT(ResidentBytes() - before, 8 << 20);
  std::size_t rest = 0;
  while (goal->Next()) ++rest;
  EXPECT_EQ(rest, 199'999u);
  EXPECT_LT(ResidentBytes() - before, 16 << 20);
}

TEST_F(WorkersTest, AGoalThatNobodyReadsFromIsEnded) {
  WorkerOptions options = Wanted();
  options.idle_time = 300ms;
  Workers workers(options);
  const auto goal = workers.Start(view_, {.goal = "repeat", .max_answers = 100'000'000});
  EXPECT_TRUE(goal->Next());
  std::this_thread::sleep_for(1000ms);
  const Answers rest = Collect(*goal);  // what was on its way
  EXPECT_EQ(rest.kind(), "idle");
  EXPECT_EQ(workers.counts().ended.at("idle"), 1u);
  EXPECT_EQ(Children(), 0);
}

TEST_F(WorkersTest, AGoalIsGoneWithItsHandle) {
  const int descriptors = OpenDescriptors();
  { const auto goal = workers_.Start(view_, {.goal = "repeat, fail"}); }
  {
    const auto goal = workers_.Start(view_, {.goal = "repeat"});
    EXPECT_TRUE(goal->Next());
  }
  EXPECT_EQ(Children(), 0);
  EXPECT_LE(OpenDescriptors(), descriptors + 1);  // the copy of the view
  EXPECT_EQ(workers_.counts().ended.at("abandoned"), 2u);
  EXPECT_EQ(workers_.counts().running, 0);
}

TEST_F(WorkersTest, ManyGoalsLeaveNothingBehind) {
  Ask("true");
  const int descriptors = OpenDescriptors();
  for (int i = 0; i < 10; ++i) EXPECT_THAT(Ask("true").answers, SizeIs(1));
  EXPECT_EQ(OpenDescriptors(), descriptors);
  EXPECT_EQ(Children(), 0);
}

TEST_F(WorkersTest, WhatHasNoRoomWaitsOrIsRefused) {
  WorkerOptions options = Wanted();
  options.max_running = 1;
  options.max_waiting = 1;
  options.wait_time = 100ms;
  Workers workers(options);
  auto first = workers.Start(view_, {.goal = "repeat, fail"});
  try {
    workers.Start(view_, {.goal = "true"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kUnavailable);
  }
  EXPECT_EQ(workers.counts().refused, 1u);
  first.reset();
  EXPECT_THAT(Collect(*workers.Start(view_, {.goal = "true"})).answers, SizeIs(1));
}

TEST_F(WorkersTest, TheViewIsNotPinnedWhileItsGoalRuns) {
  std::weak_ptr<const rdf::Layer> layer;
  std::unique_ptr<RunningGoal> goal;
  {
    const rdf::View view = Kitchen();
    layer = view.layers().front();
    goal = workers_.Start(view, {.goal = "rdf(X, 'http://x/on', _)"});
  }
  EXPECT_TRUE(layer.expired());
  EXPECT_THAT(Collect(*goal).answers, SizeIs(2));
  std::this_thread::sleep_for(700ms);
  EXPECT_EQ(workers_.counts().snapshot_bytes, 0u);
}

TEST_F(WorkersTest, AWorkerThatIsNoneIsAFault) {
  WorkerOptions options = Wanted();
  options.program = "/bin/true";
  Workers workers(options);
  EXPECT_EQ(Collect(*workers.Start(view_, {.goal = "true"})).kind(), "died");
  options.program = "/nowhere/lares";
  Workers nowhere(options);
  EXPECT_THROW(nowhere.Start(view_, {.goal = "true"}), Error);
  EXPECT_EQ(Children(), 0);
}

TEST_F(WorkersTest, EndingTheWorkersEndsTheirGoals) {
  auto workers = std::make_unique<Workers>(Wanted());
  const auto goal = workers->Start(view_, {.goal = "repeat, fail", .time = 60'000ms});
  std::thread ender([&] {
    std::this_thread::sleep_for(100ms);
    workers.reset();
  });
  EXPECT_EQ(Collect(*goal).kind(), "died");
  ender.join();
}

}  // namespace
}  // namespace lares::prolog::testing
