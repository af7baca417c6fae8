// A plan's behaviour tree does what its JSON says: both are walked, by programs that know nothing
// of each other, with the same skills.
#include "tests/recipes/behavior_tree.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <random>

#include "recipes/plan/export.h"
#include "recipes/plan/shape.h"
#include "tests/lares_data.h"
#include "tests/recipes/plan_walker.h"
#include "tests/recipes/random_plan.h"
#include "tests/recipes/world.h"
#include "tests/recipes/xml_schema.h"

namespace lares::testing {
namespace {

using recipes::Plan;
using recipes::State;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Kind = SkillEvent::Kind;

const XmlSchema& Schema() {
  static const XmlSchema schema(Source("docs/schemas/behavior-tree.xsd"));
  return schema;
}

// What an attempt does depends on the seed, the state and its number alone.
SkillScript RandomSkills(const Plan& plan, unsigned seed) {
  return [&plan, seed](const std::string& id, int attempt) {
    std::seed_seq mix{seed, static_cast<unsigned>(std::hash<std::string>{}(id)),
                      static_cast<unsigned>(attempt)};
    std::mt19937 random(mix);
    const auto below = [&](std::size_t limit) {
      return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
    };
    static constexpr int kDurations_ms[] = {0, 0, 5, 10, 40, 90, 100, 101, 250};
    const std::vector<std::string>& outcomes = recipes::FindState(plan, id)->outcomes;
    SkillAttempt run;
    run.outcome = outcomes[below(outcomes.size())];
    run.duration_ms = kDurations_ms[below(std::size(kDurations_ms))];
    // Even a skill that says too early that all is well has failed when its time is over.
    if (below(3) == 0) run.early_outcome = outcomes.front();
    return run;
  };
}

struct OutOfStarts {};

PlanWalk RunTree(const Plan& plan, const SkillScript& script, std::size_t max_starts) {
  std::map<std::string, int> attempts;
  std::size_t starts = 0;
  BehaviorTree tree(recipes::ToBehaviorTreeXml(plan), [&](const std::string& id) {
    if (++starts > max_starts) throw OutOfStarts{};
    return script(id, attempts[id]++);
  });
  PlanWalk walk;
  try {
    const TickStatus status = tree.RunToEnd(100'000);
    walk.ended = status != TickStatus::kRunning;
    walk.success = status == TickStatus::kSuccess;
  } catch (const OutOfStarts&) {
  }
  walk.events = tree.events();
  return walk;
}

std::string Text(const PlanWalk& walk) {
  std::string text;
  for (const SkillEvent& event : walk.events) {
    text += event.kind == Kind::kStart ? "start " : event.kind == Kind::kEnd ? "end " : "halt ";
    text += event.state + " " + event.outcome + "\n";
  }
  return text + (walk.ended ? walk.success ? "succeeded" : "failed" : "goes on");
}

// Both ways of walking `plan`, `runs` times; the walks through the JSON.
std::vector<PlanWalk> ExpectSameWalks(const Plan& plan, unsigned seed, int runs) {
  std::vector<PlanWalk> walks;
  const nlohmann::json json = recipes::ToJson(plan);
  for (int run = 0; run < runs; ++run) {
    const SkillScript script = RandomSkills(plan, seed + static_cast<unsigned>(run));
    walks.push_back(WalkPlan(json, script, 40));
    EXPECT_EQ(Text(RunTree(plan, script, 40)), Text(walks.back()))
        << recipes::ToBehaviorTreeXml(plan) << json.dump(1);
  }
  return walks;
}

void ExpectValid(const Plan& plan) {
  const std::string xml = recipes::ToBehaviorTreeXml(plan);
  EXPECT_THAT(Schema().Violations(xml), IsEmpty()) << xml;
}

TEST(BehaviorTreeExport, WalksThroughExactlyTheStatesOfTheJson) {
  std::mt19937 random(7);
  int ended = 0, succeeded = 0, loops = 0, halts = 0, retried = 0, parallels = 0;
  for (int i = 0; i < 400 && !::testing::Test::HasFailure(); ++i) {
    const Plan plan = i % 4 == 0 ? RandomPlan(random, 8) : RandomFullPlan(random, 8);
    ExpectValid(plan);
    loops += recipes::LinearSteps(plan).empty();
    for (const State& state : plan.states) parallels += state.kind == State::Kind::kParallel;
    for (const PlanWalk& walk : ExpectSameWalks(plan, random(), 5)) {
      ended += walk.ended;
      succeeded += walk.success;
      for (std::size_t n = 0; n < walk.events.size(); ++n) {
        halts += walk.events[n].kind == Kind::kHalt;
        retried += n > 0 && walk.events[n].kind == Kind::kStart &&
                   walk.events[n].state == walk.events[n - 1].state;
      }
    }
  }
  EXPECT_GT(ended, 500);
  EXPECT_GT(succeeded, 100);
  EXPECT_GT(loops, 100);
  EXPECT_GT(halts, 500);
  EXPECT_GT(retried, 500);
  EXPECT_GT(parallels, 100);
}

std::string TaskIri(const std::string& recipe, const std::string& task) {
  return "https://w3id.org/lares/recipes/" + recipe + "#" + task;
}

Plan LibraryPlan(const std::string& recipe, const std::string& task, const std::string& robot) {
  World world = Catalogue();
  world.PutFile("robot", Source("robots/models/" + robot + ".ttl"))
      .PutFile("recipe", Source("recipes/library/" + recipe + ".ttl"));
  return *recipes::MakePlan(Engines(), world.view(), TaskIri(recipe, task),
                            "https://w3id.org/lares/robots/" + robot + "#" + robot + "1")
              .plan;
}

// Values for what our recipes leave open.
recipes::PlanOptions OptionsFor(const recipes::Task& task, const recipes::Resource& thing) {
  const std::map<std::string, std::string> kValues = {
      {"object", "Cup"}, {"to", "1 2 0"}, {"places", thing.iri}, {"environment_type", "Kitchen"}};
  recipes::PlanOptions options;
  for (const auto& parameter : task.parameters) {
    const auto value = kValues.find(parameter.name);
    if (value != kValues.end()) options.set.insert(*value);
  }
  return options;
}

TEST(BehaviorTreeExport, EveryPlanOfTheLibraryForEveryRobotOfOursIsValidAndWalked) {
  int plans = 0;
  for (const auto& robot : std::filesystem::directory_iterator(Source("robots/models"))) {
    if (robot.path().extension() != ".ttl") continue;
    for (const auto& recipe : std::filesystem::directory_iterator(Source("recipes/library"))) {
      World world = Catalogue();
      world.PutFile("robot", robot.path()).PutFile("recipe", recipe.path());
      for (const auto& task : recipes::FindTasks(Engines(), world.view(), "recipe")) {
        for (const auto& who : recipes::FindRobots(Engines(), world.view(), "robot")) {
          const auto result = recipes::MakePlan(Engines(), world.view(), task.task.iri, who.iri,
                                                OptionsFor(task, who));
          if (!result.plan) continue;
          ++plans;
          ExpectValid(*result.plan);
          ExpectSameWalks(*result.plan, 5, 50);
        }
      }
    }
  }
  EXPECT_GE(plans, 8);
}

TEST(BehaviorTreeExport, EveryPlanOfRoboEarthsRecipesIsValidAndWalked) {
  LARES_REQUIRE_DATA(folder, "roboearth/recipes");
  int plans = 0;
  for (const char* robot : {"pioneer.owl", "amigo.owl", "PR2.owl"}) {
    for (const auto& recipe : std::filesystem::directory_iterator(folder)) {
      World world = Catalogue();
      world.PutFile("robot", DataFolder() / "roboearth/robots" / robot);
      world.PutFile("recipe", recipe.path(), true);
      const auto robots = recipes::FindRobots(Engines(), world.view(), "robot");
      ASSERT_EQ(robots.size(), 1u);
      for (const auto& task : recipes::FindTasks(Engines(), world.view(), "recipe")) {
        if (!task.top_level) continue;
        const auto result =
            recipes::MakePlan(Engines(), world.view(), task.task.iri, robots.front().iri);
        if (!result.plan) continue;
        ++plans;
        ExpectValid(*result.plan);
        ExpectSameWalks(*result.plan, 5, 50);
      }
    }
  }
  EXPECT_GE(plans, 5);
}

TEST(BehaviorTreeExport, APlainRowIsAPlainSequence) {
  const std::string xml =
      recipes::ToBehaviorTreeXml(LibraryPlan("fetch-drink", "FetchDrink", "helper"));
  EXPECT_THAT(xml, Not(HasSubstr("<Script")));
  EXPECT_THAT(xml, Not(HasSubstr("<Fallback")));
}

// A plan of one skill and two ends.
Plan OneSkill() {
  Plan plan;
  State skill;
  skill.id = "look";
  skill.skill = "Look";
  skill.outcomes = {"succeeded", "empty", "failed"};
  State good;
  good.id = "good";
  good.kind = State::Kind::kEnd;
  good.success = true;
  State bad = good;
  bad.id = "bad";
  bad.success = false;
  plan.states = {skill, good, bad};
  plan.start = "look";
  plan.transitions = {{"look", "succeeded", "good", false, ""},
                      {"look", "empty", "good", false, ""},
                      {"look", "failed", "bad", false, ""}};
  return plan;
}

TEST(BehaviorTreeExport, ATimeLimitIsThatOfOneAttemptAndLeavesNoStaleOutcome) {
  Plan plan = OneSkill();
  plan.states[0].retries = 2;
  plan.states[0].time_limit_s = 0.1;
  const auto xml = recipes::ToBehaviorTreeXml(plan);
  EXPECT_THAT(xml, HasSubstr("<RetryUntilSuccessful num_attempts=\"3\">"));
  EXPECT_THAT(xml, HasSubstr("<Timeout msec=\"100\">"));
  // Each attempt says at once that all is well, and then never ends.
  const SkillScript hangs = [](const std::string&, int) {
    return SkillAttempt{"succeeded", 1'000'000, "succeeded"};
  };
  EXPECT_EQ(Text(RunTree(plan, hangs, 10)),
            "start look \nhalt look \nstart look \nhalt look \nstart look \nhalt look \nfailed");
  // The third attempt is in time: 90 ms each would be too long for one limit over all.
  const SkillScript slow = [](const std::string&, int attempt) {
    return SkillAttempt{attempt < 2 ? "failed" : "empty", 90, ""};
  };
  const PlanWalk walk = RunTree(plan, slow, 10);
  EXPECT_TRUE(walk.success);
  EXPECT_EQ(walk.events.back(), (SkillEvent{Kind::kEnd, "look", "empty"}));
}

TEST(BehaviorTreeExport, OneFailureHaltsTheMembersBesideIt) {
  Plan plan = OneSkill();
  State& parallel = plan.states[0];
  State a = parallel, b = parallel;
  parallel.kind = State::Kind::kParallel;
  parallel.skill.clear();
  parallel.outcomes = {"succeeded", "failed"};
  plan.transitions.erase(plan.transitions.begin() + 1);
  a.id = "a", b.id = "b", a.parallel = b.parallel = parallel.id;
  parallel.members = {"a", "b"};
  plan.states.insert(plan.states.begin() + 1, {a, b});
  const auto fails = [](const std::string& id, int) {
    return SkillAttempt{id == "a" ? "succeeded" : "failed", id == "a" ? 500 : 200, ""};
  };
  EXPECT_EQ(Text(RunTree(plan, fails, 10)), "start a \nstart b \nend b failed\nhalt a \nfailed");
  const auto works = [](const std::string& id, int) {
    return SkillAttempt{"succeeded", id == "a" ? 500 : 200, ""};
  };
  EXPECT_EQ(Text(RunTree(plan, works, 10)),
            "start a \nstart b \nend b succeeded\nend a succeeded\nsucceeded");
}

TEST(BehaviorTreeExport, ATemplatesFragmentStandsInPlaceOfRetriesAndLimit) {
  Plan plan = OneSkill();
  plan.states[0].retries = 5;
  plan.states[0].time_limit_s = 7;
  plan.states[0].tree_fragment =
      "<Delay delay_msec=\"30\"> <Timeout msec='20'><Skill/></Timeout></Delay>";
  const std::string xml = recipes::ToBehaviorTreeXml(plan);
  EXPECT_THAT(xml, Not(HasSubstr("Retry")));
  EXPECT_THAT(xml, HasSubstr("<Delay delay_msec=\"30\">"));
  ExpectValid(plan);
  ExpectSameWalks(plan, 1, 100);
}

TEST(BehaviorTreeSchema, RefusesWhatTheExportNeverWrites) {
  Plan plan = OneSkill();
  plan.states[0].retries = 1;
  plan.states[0].time_limit_s = 1;
  const std::string xml = recipes::ToBehaviorTreeXml(plan);
  ASSERT_THAT(Schema().Violations(xml), IsEmpty());
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = xml;
    const std::size_t at = other.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return other.replace(at, from.size(), to);
  };
  const std::vector<std::pair<std::string, std::string>> changes = {
      {"BTCPP_format=\"4\"", "BTCPP_format=\"3\""},
      {"num_attempts=\"2\"", "num_attempts=\"0\""},
      {"num_attempts=\"2\"", "num_cycles=\"2\""},
      {"msec=\"1000\"", "msec=\"soon\""},
      {"msec=\"1000\"", "msec=\"-5\""},
      {"<Timeout msec=\"1000\">", "<Timeout>"},
      {"<KeepRunningUntilFailure>", "<KeepRunningUntilFailure><Sequence/>"},
      {"<ScriptCondition code=\"state ==", "<ScriptCondition code=\"stat ="},
      {"main_tree_to_execute=\"", "main_tree_to_execute=\"Other"},
      {"<Fallback>", "<Fallback><Inverter><Look/></Inverter>"},
      {"<Fallback>", "<Fallback><BehaviorTree ID=\"x\"/>"},
      {"<Fallback>", "<Fallback wrong=\"1\">"},
      {"type=\"std::string\"", "type=\"int\""},
      {"<TreeNodesModel>", "<TreeNodesModel><Action ID=\"Empty\"/>"}};
  for (const auto& [from, to] : changes) {
    EXPECT_THAT(Schema().Violations(changed(from, to)), Not(IsEmpty())) << from << " → " << to;
  }
}

}  // namespace
}  // namespace lares::testing
