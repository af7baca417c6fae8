// Goals: yes, no and error; limits; engines shared by threads.
#include "reasoner/prolog/engine_pool.h"

#include <atomic>
#include <csignal>
#include <thread>

#include "base/error.h"
#include "reasoner/prolog/thread_engine.h"
#include "tests/reasoner/prolog_fixture.h"

namespace lares::prolog::testing {
namespace {

using namespace std::chrono_literals;
using EnginePoolTest = PrologTest;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(EnginePoolTest, YesNoAndErrorAreThreeThings) {
  EXPECT_EQ(Once("yes", {A("x")}), A("yes"));
  EXPECT_EQ(Once("no", {A("x")}), std::nullopt);
  EXPECT_THAT(All("no", {A("x")}), IsEmpty());
  EXPECT_THAT(All("none", {}), IsEmpty());
  EXPECT_EQ(ErrorOf("throw_term", {A("oops")}).code(), Code::kInternal);
}

TEST_F(EnginePoolTest, AllAnswersComeInOrder) {
  EXPECT_THAT(All("count", {I(3)}), ElementsAre(I(1), I(2), I(3)));
  EXPECT_EQ(Once("count", {I(3)}), I(1));
}

// Nothing of it is lost, whoever asks: dicts and strings, and atoms that nothing else holds.
TEST_F(EnginePoolTest, AnAnswerThatIsKeptIsAnInputOfOtherGoals) {
  const Value value = C("f", {{Dict{{"text", S("grüße")}, {"number", {2.5}}}},
                              {List{A("an atom of this test alone"), I(7)}}});
  EnginePool pool;
  RecordRef kept = pool.Keep(EmptyView(), "prolog_test_rules", "echo", {value});
  EXPECT_EQ(pool.Keep(EmptyView(), "prolog_test_rules", "no", {value}), nullptr);
  std::thread([&] {
    EXPECT_EQ(Once("echo", {{List{{kept}, I(1)}}}), (Value{List{value, I(1)}}));
  }).join();
  std::thread([last = std::move(kept)]() mutable { last.reset(); }).join();  // without an engine
}

TEST_F(EnginePoolTest, MoreAnswersThanAllowedAreTooLarge) {
  EXPECT_EQ(All("count", {I(5)}, EmptyView(), Limits{.max_answers = 5}).size(), 5u);
  EXPECT_EQ(ErrorOf("count", {I(6)}, EmptyView(), Limits{.max_answers = 5}).code(),
            Code::kTooLarge);
}

TEST_F(EnginePoolTest, ARuleChoosesTheCodeOfItsError) {
  for (int i = 0; i <= static_cast<int>(Code::kInternal); ++i) {
    const Code code = static_cast<Code>(i);
    const Error error = ErrorOf("throw_text", {A(std::string(ToString(code))), S("grüße")});
    EXPECT_EQ(error.code(), code);
    EXPECT_STREQ(error.what(), "grüße");
  }
  const Value inner = C("lares_error", {A("not-found"), A("no cup")});
  EXPECT_EQ(ErrorOf("throw_term", {C("error", {inner, A("context")})}).code(), Code::kNotFound);
  EXPECT_EQ(ErrorOf("throw_text", {A("no-such-code"), S("text")}).code(), Code::kInternal);
}

TEST_F(EnginePoolTest, OtherExceptionsReadAsPrologWouldPrintThem) {
  EXPECT_THAT(ErrorOf("unknown_predicate", {}).what(), HasSubstr("Unknown procedure"));
  EXPECT_THAT(ErrorOf("print_and_throw", {}).what(), HasSubstr("not sufficiently instantiated"));
  EXPECT_THAT(ErrorOf("throw_term", {C("odd", {A("thing")})}).what(), HasSubstr("odd(thing)"));
  EXPECT_THAT(ErrorOf("never_heard_of", {}).what(), HasSubstr("never_heard_of/1"));
}

TEST_F(EnginePoolTest, AMessageOfARuleDoesNotEndTheProcess) {
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Once("complain", {}), A("survived"));
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("an error that a rule prints"));
}

TEST_F(EnginePoolTest, ErrorsPrintNothing) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  ErrorOf("throw_term", {A("oops")});
  ErrorOf("unknown_predicate", {});
  ErrorOf("long_list", {});
  ErrorOf("loop", {}, EmptyView(), Limits{.time = 20ms});
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

class EndlessRule : public EnginePoolTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(EndlessRule, IsStopped) {
  EXPECT_EQ(ErrorOf(GetParam(), {}, Numbered(3), Limits{.time = 50ms}).code(), Code::kTimeout);
  EXPECT_EQ(Once("yes", {A("x")}), A("yes"));
}

INSTANTIATE_TEST_SUITE_P(All, EndlessRule,
                         ::testing::Values("loop", "loop_stubbornly", "loop_over_triples",
                                           "loop_over_lookups", "loop_over_builtin"),
                         [](const auto& param) { return std::string(param.param); });

TEST_F(EnginePoolTest, AnEngineThatRanOutOfStackIsUsableAfterwards) {
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(ErrorOf("long_list", {}).code(), Code::kTooLarge);
    EXPECT_EQ(Once("yes", {A("x")}), A("yes"));
  }
}

TEST_F(EnginePoolTest, AGoalWaitsForAnEngineButNotForever) {
  std::thread first([&] { ErrorOf("loop", {}, EmptyView(), Limits{.time = 400ms}); });
  std::thread second([&] { ErrorOf("loop", {}, EmptyView(), Limits{.time = 400ms}); });
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(ErrorOf("yes", {A("x")}, EmptyView(), Limits{.time = 20ms}).code(), Code::kTimeout);
  EXPECT_EQ(Once("yes", {A("x")}), A("yes"));
  first.join();
  second.join();
}

TEST_F(EnginePoolTest, GoalsOfDifferentThreadsNeverMixTheirViews) {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  std::vector<std::thread> threads;
  std::atomic<int> wrong{0};
  for (int i = 1; i <= 6; ++i) {
    threads.emplace_back([&, i] {
      const rdf::View view = Numbered(i, rdf::View(dictionary));
      for (int round = 0; round < 20; ++round) {
        if (Once("wait_then_count", {I(10)}, view) != Value{List{I(i)}}) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

TEST_F(EnginePoolTest, AThreadKeepsItsEngineUntilItEnds) {
  const int before = LiveThreadEngines();
  std::thread thread([&] {
    EXPECT_EQ(Once("yes", {A("x")}), A("yes"));
    EXPECT_EQ(Once("yes", {A("x")}), A("yes"));
    EXPECT_EQ(LiveThreadEngines(), before + 1);
  });
  thread.join();
  EXPECT_EQ(LiveThreadEngines(), before);
}

TEST_F(EnginePoolTest, ThreadsThatHaveTheirGoalBehindThemHoldFewEngines) {
  std::atomic<int> done{0};
  std::atomic<bool> end{false};
  std::vector<std::thread> threads;
  for (int i = 0; i < 50; ++i) {
    threads.emplace_back([&] {
      Once("yes", {A("x")});
      ++done;
      while (!end) std::this_thread::sleep_for(1ms);
    });
  }
  while (done < 50) std::this_thread::sleep_for(1ms);
  EXPECT_LE(LiveThreadEngines(), 32 + 2);
  end = true;
  for (std::thread& thread : threads) thread.join();
}

// An engine that moved between threads aborted the process once a deep term was written.
TEST_F(EnginePoolTest, GoalsOfOnePoolMayRunOnManyThreads) {
  for (int i = 0; i < 10; ++i) {
    std::thread([&] {
      EXPECT_THAT(ErrorOf("throw_term", {C("odd", {A("thing")})}).what(), HasSubstr("odd(thing)"));
    }).join();
  }
}

TEST_F(EnginePoolTest, PoolsMayComeAndGo) {
  for (int i = 0; i < 5; ++i) {
    EnginePool pool(Options{.engines = 1});
    EXPECT_EQ(pool.Once(EmptyView(), "prolog_test_rules", "yes", {A("x")}), A("yes"));
  }
  EXPECT_THROW(EnginePool(Options{.engines = 0}), Error);
}

TEST_F(EnginePoolTest, SignalHandlersStayTheProcesss) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGUSR2, SIGPIPE, SIGCHLD, SIGALRM}) {
    struct sigaction action {};
    ASSERT_EQ(sigaction(number, nullptr, &action), 0);
    EXPECT_EQ(action.sa_handler, SIG_DFL) << number;
  }
}

}  // namespace
}  // namespace lares::prolog::testing
