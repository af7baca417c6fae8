// What goals may say, how answers are written, and how faults are told; in this process.
#include "reasoner/prolog/expert.h"

#include "reasoner/prolog/rdf_predicates.h"
#include "tests/reasoner/prolog_worker_fixture.h"

namespace lares::prolog::testing {
namespace {

using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class ExpertTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { StartExpertProlog(); }

  Answers Ask(const std::string& goal, const ExpertLimits& limits = {}) {
    Answers answers;
    answers.end = RunExpertGoal(view_, goal, limits, [&](std::string answer) {
      answers.answers.push_back(std::move(answer));
      return true;
    });
    return answers;
  }
  // The one answer's text.
  std::string One(const std::string& goal) {
    const Answers answers = Ask(goal);
    EXPECT_THAT(answers.answers, SizeIs(1)) << goal << ": " << answers.message();
    return answers.answers.empty() ? "" : answers.answers.front();
  }

  rdf::View view_ = Kitchen();
};

TEST_F(ExpertTest, ValuesAreWrittenByTheirKind) {
  EXPECT_EQ(One("X = 1, Y = 2.5, Z = \"text\""), R"({"X":1,"Y":2.5,"Z":"text"})");
  EXPECT_EQ(One("X = foo"), R"({"X":{"type":"atom","value":"foo"}})");
  EXPECT_EQ(One("rdf_equal(X, lares:'Cup')"),
            R"({"X":{"type":"uri","value":"https://w3id.org/lares#Cup"}})");
  EXPECT_EQ(One("rdf(_, 'http://x/name', X)"),
            R"({"X":{"type":"literal","value":"grüne Tasse","xml:lang":"de"}})");
  EXPECT_EQ(One("X = [1, [a], []]"), R"({"X":[1,[{"type":"atom","value":"a"}],[]]})");
  EXPECT_EQ(One("X = f(1)"), R"({"X":{"type":"compound","name":"f","arguments":[1]}})");
  EXPECT_EQ(One("X = f()"), R"({"X":{"type":"compound","name":"f","arguments":[]}})");
  EXPECT_EQ(One("X is 2**64"), R"({"X":{"type":"integer","value":"18446744073709551616"}})");
  EXPECT_EQ(One("X is 1 rdiv 3"), R"({"X":{"type":"rational","value":"1r3"}})");
  EXPECT_EQ(One("X = literal(a, b, _)"),
            R"({"X":{"type":"compound","name":"literal","arguments":[)"
            R"({"type":"atom","value":"a"},{"type":"atom","value":"b"},)"
            R"({"type":"variable","name":"_1"}]}})");
}

TEST_F(ExpertTest, UnboundVariablesKeepWhatTheyShare) {
  EXPECT_EQ(One("X = f(Y, Z, Y)"),
            R"({"X":{"type":"compound","name":"f","arguments":[)"
            R"({"type":"variable","name":"_1"},{"type":"variable","name":"_2"},)"
            R"({"type":"variable","name":"_1"}]},"Y":{"type":"variable","name":"_1"},)"
            R"("Z":{"type":"variable","name":"_2"}})");
  EXPECT_EQ(One("X = [1|_]"), R"({"X":{"type":"partial-list","elements":[1],)"
                              R"("rest":{"type":"variable","name":"_1"}}})");
}

TEST_F(ExpertTest, HugeAndCyclicValuesAreCutWithAMark) {
  EXPECT_EQ(One("X = f(X)"), R"({"X":{"type":"cyclic"}})");
  EXPECT_EQ(One("X = [a|X]"), R"({"X":{"type":"cyclic"}})");
  EXPECT_LT(One("numlist(1, 200000, X)").size(), 2u << 20);
  EXPECT_THAT(One("numlist(1, 200000, X)"), HasSubstr(R"({"type":"cut","why":"size"})"));
  EXPECT_THAT(One("length(L, 10000), foldl([_, A, s(A)]>>true, L, z, X), L = []; "
                  "numlist(1, 500, N), foldl([_, A, s(A)]>>true, N, z, X)"),
              HasSubstr(R"({"type":"cut","why":"depth"})"));
  EXPECT_LT(One("numlist(1, 100000, L), atomic_list_concat(L, X), L1 = L, L1 = [_|_]").size(),
            2u << 20);
}

TEST_F(ExpertTest, VariablesWithAnUnderscoreAreNotAnswered) {
  EXPECT_EQ(One("_X = 1, Y = 2"), R"({"Y":2})");
}

TEST_F(ExpertTest, APromptAndAFullStopMayBeThere) {
  EXPECT_EQ(One("?- X = 1."), R"({"X":1})");
  EXPECT_EQ(One("  X = 1 . % done"), R"({"X":1})");
}

TEST_F(ExpertTest, SyntaxErrorsNameTheirPlace) {
  const Answers answers = Ask("member(X, [1, 2]),\n  foo bar");
  EXPECT_EQ(answers.kind(), "syntax");
  EXPECT_EQ(answers.end.fault->line, 2);
  EXPECT_GT(answers.end.fault->column, 1);
  EXPECT_THAT(answers.message(), HasSubstr("perator"));
  EXPECT_EQ(Ask("").kind(), "syntax");
  EXPECT_EQ(Ask("X = 1. Y = 2.").kind(), "syntax");
  EXPECT_EQ(Ask("foo(").kind(), "syntax");
  EXPECT_EQ(Ask("'abc").kind(), "syntax");
  EXPECT_EQ(Ask(std::string("a\0b", 3)).kind(), "syntax");
  EXPECT_EQ(Ask("\xff\xfe").kind(), "syntax");
}

TEST_F(ExpertTest, FaultsOfGoalsAreToldApart) {
  EXPECT_EQ(Ask("X is foo + 1").kind(), "type");
  EXPECT_EQ(Ask("X is 1 / 0").kind(), "evaluation");
  EXPECT_EQ(Ask("X is Y + 1").kind(), "unbound");
  EXPECT_EQ(Ask("no_such_predicate(1)").kind(), "existence");
  EXPECT_THAT(Ask("no_such_predicate(1)").message(), HasSubstr("no_such_predicate/1"));
  EXPECT_EQ(Ask("rdf(X, nowhere:p, Y)").kind(), "existence");
  EXPECT_EQ(Ask("atom_length(1, a)").kind(), "type");
  EXPECT_EQ(Ask("throw(oops)").kind(), "thrown");
  EXPECT_THAT(Ask("throw(oops)").message(), HasSubstr("oops"));
  EXPECT_EQ(Ask("X").kind(), "unbound");
  EXPECT_EQ(Ask("1").kind(), "type");
  EXPECT_EQ(Ask("call(X)").kind(), "unbound");
}

struct Refused {
  const char* goal;
  const char* named;

  friend void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.goal; }
};

class RefusedGoal : public ExpertTest, public ::testing::WithParamInterface<Refused> {};

TEST_P(RefusedGoal, IsNamed) {
  const Answers answers = Ask(GetParam().goal);
  EXPECT_EQ(answers.kind(), "refused") << answers.message();
  EXPECT_THAT(answers.message(), HasSubstr(GetParam().named));
  EXPECT_THAT(answers.answers, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedGoal,
    ::testing::Values(
        Refused{"assertz(a(1))", "assertz/1"}, Refused{"asserta(a(1))", "asserta/1"},
        Refused{"retract(a(1))", "retract/1"}, Refused{"retractall(a(_))", "retractall/1"},
        Refused{"repeat, assertz(a(1)), fail", "assertz/1"},
        Refused{"forall(member(X, [1]), assertz(a(X)))", "assertz/1"},
        Refused{"maplist(assertz, [a, b])", "assertz/1"},
        Refused{"findall(X, (member(X, [1]), \\+ \\+ assertz(a)), _)", "assertz/1"},
        Refused{"system:assertz(a)", "assertz/1"}, Refused{"halt", "halt/0"},
        Refused{"halt(1)", "halt/1"}, Refused{"consult(x)", "consult/1"},
        Refused{"use_module(library(process))", "use_module/1"},
        Refused{"open('/etc/passwd', read, S)", "open/3"},
        Refused{"open('/tmp/x', write, S)", "open/3"}, Refused{"shell('id')", "shell/"},
        Refused{"shell('id', _)", "shell/2"}, Refused{"tmp_file(x, F)", "tmp_file/2"},
        Refused{"thread_create(true, Id)", "thread_create/"},
        Refused{"thread_self(X), thread_send_message(X, a)", "thread_s"},
        Refused{"see('/etc/passwd')", "see/1"}, Refused{"getenv('HOME', X)", "getenv/2"},
        Refused{"rdf_edge:match(S, P, O, all)", "match/4"},
        Refused{"edge:load_test_file('/etc/passwd')", "load_test_file/1"},
        Refused{"directory_files('/', X)", "directory_files/2"},
        Refused{"set_prolog_flag(gc, false)", "set_prolog_flag/2"},
        Refused{"op(700, xfx, ===>)", "op/3"}));

TEST_F(ExpertTest, LibrariesThatReachOutAreNotThere) {
  EXPECT_THAT(Ask("process_create(path(id), [], [])").kind(), AnyOf("existence", "refused"));
  EXPECT_THAT(Ask("fork(X)").kind(), AnyOf("existence", "refused"));
  EXPECT_THAT(Ask("tcp_socket(X)").kind(), AnyOf("existence", "refused"));
}

TEST_F(ExpertTest, TheViewIsFreedHoweverAGoalEnds) {
  std::weak_ptr<const rdf::Layer> layer = view_.layers().front();
  const auto run = [&](const std::string& goal, std::size_t max_answers) {
    RunExpertGoal(view_, goal, ExpertLimits{.max_answers = max_answers},
                  [](const std::string&) { return true; });
    EXPECT_EQ(LiveChoicePoints(), 0) << goal;
    EXPECT_EQ(layer.use_count(), 1) << goal;
  };
  run("rdf(S, P, O)", 1000);                                    // exit
  run("rdf(S, P, O), !", 1000);                                 // cut
  run("once(rdf(S, P, O))", 1000);                              //
  run("rdf(S, P, O), X is foo + 1", 1000);                      // exception
  run("catch((rdf(S, P, O), throw(x)), x, true)", 1000);        //
  run("rdf(S, P, O), rdf(A, B, C)", 2);                         // left alone in the middle
  run("findall(S, (rdf(S, P, O), rdf(A, B, C), !), L)", 1000);  //
  run("rdf_in(S, P, O, 'environment:kitchen')", 1);
}

TEST_F(ExpertTest, ATextOfAMegabyteIsRead) {
  std::string goal = "X = [0";
  while (goal.size() < 1'000'000) goal += ", 12345678";
  EXPECT_THAT(Ask(goal + "], length(X, N)").answers, SizeIs(1));
  EXPECT_EQ(Ask("X = '" + std::string(1'000'000, 'a') + "'").kind(), "");
}

}  // namespace
}  // namespace lares::prolog::testing
