// Goals that loop, grow, escape or drown, with and without the proof in front of the process.
#include <sys/stat.h>

#include <atomic>
#include <ostream>
#include <random>
#include <thread>

#include "base/error.h"
#include "tests/reasoner/prolog_worker_fixture.h"

namespace lares::prolog::testing {
namespace {

using namespace std::chrono_literals;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

struct Hostile {
  const char* name;
  std::string goal;
  const char* kind;  // how it ends; "" for an answer; several parted by '|'
  bool prove = true;

  friend void PrintTo(const Hostile& hostile, std::ostream* out) { *out << hostile.goal; }
};

// After each of them the process lives, is as small as before, and has no child.
class HostileGoal : public WorkersTest, public ::testing::WithParamInterface<Hostile> {};

TEST_P(HostileGoal, HarmsOnlyItself) {
  constexpr std::chrono::milliseconds kTime = 1500ms;
  Ask("true");
  const long before = ResidentBytes();
  const int descriptors = OpenDescriptors();
  const Answers answers =
      AskFor({.goal = GetParam().goal, .time = kTime, .prove = GetParam().prove});
  EXPECT_LT(answers.took, kTime + 1000ms);
  EXPECT_THAT("|" + std::string(GetParam().kind) + "|", HasSubstr("|" + answers.kind() + "|"))
      << answers.kind() << ": " << answers.message();
  EXPECT_LT(ResidentBytes() - before, 32 << 20);
  EXPECT_EQ(OpenDescriptors(), descriptors);
  EXPECT_EQ(Children(), 0);
  EXPECT_THAT(Ask("true").answers, SizeIs(1));
}

std::string Name(const ::testing::TestParamInfo<Hostile>& param) { return param.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Proved, HostileGoal,
    ::testing::Values(
        Hostile{"huge_power", "X is 7**(7**10)", "time|memory"},
        Hostile{"assert_forever", "repeat, assertz(a(1)), fail", "refused"},
        Hostile{"format_forever",
                "repeat, format(atom(A), '~*c', [100000000, 0'x]), nb_setval(k, A), fail",
                "refused|memory|time"},
        Hostile{"format_huge", "format(atom(A), '~*c', [2000000000, 0'x])", "memory|time"},
        Hostile{"long_list", "numlist(1, 100000000, L)", "memory|time"},
        Hostile{"findall_forever", "findall(X, repeat, L)", "memory|time"},
        Hostile{"atoms_forever",
                "between(1, inf, N), atom_concat(aaaaaaaaaaaaaaaa, N, A), "
                "atom_length(A, 1)",
                "memory|time"},
        Hostile{"loop", "repeat, fail", "time"},
        Hostile{"loop_with_catch", "repeat, catch((repeat, fail), _, true), fail", "time"},
        Hostile{"loop_over_facts", "repeat, rdf(_, _, _), fail", "time"},
        Hostile{"deep_term",
                "numlist(1, 1000000, N), foldl([_, A, s(A)]>>true, N, z, X), "
                "copy_term(X, Y), X == Y, N = [_|_]",
                "|time|memory"},
        Hostile{"cyclic_term", "X = f(X, Y, X), Y = g(Y)", ""},
        Hostile{"cyclic_throw", "X = f(X), throw(X)", "thrown"},
        Hostile{"huge_throw", "numlist(1, 1000000, L), throw(L)", "thrown|memory|time"},
        Hostile{"sleeps", "sleep(100)", "refused|time"}, Hostile{"halt", "halt", "refused"}),
    Name);

// What only the process holds back.
INSTANTIATE_TEST_SUITE_P(
    Unproved, HostileGoal,
    ::testing::Values(
        Hostile{"assert_forever", "repeat, assertz(a(1)), fail", "time|memory", false},
        Hostile{"assert_big", "numlist(1, 1000, L), repeat, assertz(a(L)), fail", "time|memory",
                false},
        Hostile{"record_forever",
                "repeat, format(atom(A), '~*c', [1000000, 0'x]), "
                "recordz(k, A), fail",
                "time|memory", false},
        Hostile{"halt", "halt", "died", false}, Hostile{"sleeps", "sleep(100)", "time", false},
        Hostile{"aborts", "abort", "thrown|died", false},
        Hostile{"shell", "shell('touch /tmp/lares-escaped')",
                "refused|escape|existence|memory|thrown|", false},
        Hostile{"pipe", "open(pipe('touch /tmp/lares-escaped'), read, S)",
                "refused|escape|existence|memory", false},
        Hostile{"read_file", "open('/etc/passwd', read, S), read_term(S, T, [])",
                "refused|existence", false},
        Hostile{"write_file", "open('/tmp/lares-escaped', write, S), write(S, x), close(S)",
                "refused|existence", false},
        Hostile{"thread", "thread_create(true, Id)", "thrown|refused", false},
        Hostile{"foreign", "open_shared_object('/usr/lib/x86_64-linux-gnu/libgfortran.so.5', H)",
                "refused|existence|thrown", false},
        Hostile{"load", "load_files('/usr/lib/swi-prolog/library/process.pl', [])",
                "refused|existence|thrown|", false},
        Hostile{"directory", "directory_files('/', F)", "refused|existence", false},
        Hostile{"delete", "delete_file('/tmp/lares-escaped')", "refused|existence", false},
        Hostile{"descriptors", "between(1, 100000, X), open_null_stream(S), fail",
                "|time|memory|refused", false}),
    [](const auto& param) { return std::string(param.param.name); });

TEST_F(WorkersTest, NothingEscaped) {
  struct stat status {};
  EXPECT_NE(::stat("/tmp/lares-escaped", &status), 0);
}

TEST_F(WorkersTest, BinaryGarbageIsASyntaxError) {
  std::mt19937 random(7);
  for (int i = 0; i < 6; ++i) {
    std::string goal(1000, '\0');
    for (char& c : goal) c = static_cast<char>(random());
    EXPECT_EQ(Ask(goal).kind(), "syntax");
  }
}

TEST_F(WorkersTest, AGoalOfAMegabyteIsAnswered) {
  const std::string goal = "atom_length('" + std::string(1'000'000, 'a') + "', N)";
  EXPECT_THAT(Ask(goal).answers, ::testing::ElementsAre(R"({"N":1000000})"));
  EXPECT_THROW(Ask(std::string(5 << 20, 'a')), Error);
}

TEST_F(WorkersTest, ManyHostileGoalsAtOnceAreHeldApart) {
  std::atomic<int> timed_out{0}, refused{0}, other{0};
  std::vector<std::thread> threads;
  WorkerOptions options = Wanted();
  options.max_waiting = 4;
  Workers workers(options);
  for (int i = 0; i < 12; ++i) {
    threads.emplace_back([&] {
      try {
        const Answers answers =
            Collect(*workers.Start(view_, {.goal = "repeat, fail", .time = 300ms}));
        ++(answers.kind() == "time" ? timed_out : other);
      } catch (const Error& error) {
        ++(error.code() == Code::kUnavailable ? refused : other);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(other, 0);
  EXPECT_GE(timed_out, 2);
  EXPECT_GE(refused, 1);
  EXPECT_EQ(timed_out + refused, 12);
  EXPECT_EQ(workers.counts().running, 0);
  EXPECT_EQ(Children(), 0);
}

}  // namespace
}  // namespace lares::prolog::testing
