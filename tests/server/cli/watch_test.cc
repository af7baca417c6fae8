#include <gmock/gmock.h>

#include <mutex>
#include <thread>

#include "tests/server/cli/cli_fixture.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;

class WatchCommandTest : public CliTest {
 protected:
  WatchCommandTest() {
    Answers().view = [this](const server::ViewRequest&) {
      const std::lock_guard lock(mutex_);
      return ViewOfTurtle("@prefix : <https://w3id.org/lares#> . " + facts_);
    };
  }
  ~WatchCommandTest() override {
    server_.reset();
    context_.reset();
    Answers() = {};
  }
  // Once somebody watches.
  void CommitSoon(const std::string& facts) {
    committing_ = std::jthread([this, facts] {
      for (int i = 0; i < 2000 && context_->watches->subscribers() == 0; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      }
      {
        const std::lock_guard lock(mutex_);
        facts_ = facts;
      }
      knowledge_->changes().Notify();
    });
  }

  std::mutex mutex_;
  std::string facts_ = ":cup1 a :Cup .";
  std::jthread committing_;
};

TEST_F(WatchCommandTest, PrintsTheAnswerAndThenWhatCameAndWent) {
  CommitSoon(":cup2 a :Cup .");
  const Outcome watched = Lares({"watch", "-q", "SELECT ?c { ?c a lares:Cup }", "--events", "2"});
  EXPECT_EQ(watched.code, 0) << watched.err;
  EXPECT_EQ(watched.out,
            "generation 0: 1 row\n"
            "  ?c = lares:cup1\n"
            "generation 1: 1 row\n"
            "- ?c = lares:cup1\n"
            "+ ?c = lares:cup2\n");
}

TEST_F(WatchCommandTest, TakesAPatternAndCounts) {
  const Outcome watched = Lares({"watch", "--predicate", "rdf:type", "--count", "--events", "1"});
  EXPECT_EQ(watched.code, 0) << watched.err;
  EXPECT_EQ(watched.out, "generation 0: 1 row\n");
}

TEST_F(WatchCommandTest, SaysWhatIsWrongByItsExitCode) {
  EXPECT_EQ(Lares({"watch"}).code, 3);
  EXPECT_EQ(Lares({"watch", "-q", "nonsense"}).code, 3);
  EXPECT_EQ(Lares({"watch", "-q", "ASK {}", "--object", "lares:Cup"}).code, 2);
  url_ = "http://127.0.0.1:9";
  EXPECT_EQ(Lares({"watch", "-q", "ASK {}"}).code, 6);
}

}  // namespace
}  // namespace lares::testing
