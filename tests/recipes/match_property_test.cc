// Random worlds: the judgement of whole tasks and that of single conditions agree, and a robot that
// is ranked by itself is judged as one that is matched with the recipe in one view.
#include <gmock/gmock.h>

#include <random>

#include "recipes/match/assess.h"
#include "recipes/match/rank.h"
#include "tests/recipes/world.h"

namespace lares::testing {
namespace {

using prolog::Atom;
using prolog::Value;

std::string Name(const char* kind, std::size_t i) {
  return std::string(":") + kind + std::to_string(i);
}

// Capabilities :C0…, components :P0…, with circles, unions, special cases and requirements.
class RandomWorld {
 public:
  explicit RandomWorld(std::uint32_t seed) : random_(seed) {
    capabilities_ = 3 + random_() % 6;
    components_ = 3 + random_() % 6;
  }

  std::string Recipe() {
    std::vector<StepText> steps;
    const std::size_t count = 1 + random_() % 3;
    for (std::size_t i = 0; i < count; ++i) {
      steps.push_back({"step" + std::to_string(i), "lares:PurposefulAction , " + Dependency()});
    }
    std::string text = PartialOrder(steps, {});
    for (std::size_t i = 0; i < capabilities_; ++i) {
      text += Name("C", i) + " a owl:Class ; rdfs:subClassOf " +
              Parent("C", "lares:Capability", i) + Dependencies(i < 2 ? 2 : 3) + " .\n" +
              Requirement(Name("C", i), 8);
    }
    for (std::size_t i = 0; i < components_; ++i) {
      text += Name("P", i) + " a owl:Class ; rdfs:subClassOf " +
              Parent("P", "lares:SoftwareComponent", i) + (Chance(4) ? " , " + Uses() : "") +
              " .\n" + Requirement(Name("P", i), 10);
    }
    return text + Requirement(":step0", 4);
  }

  std::string Robot() {
    std::string text =
        Turtle(":Kind a owl:Class ; rdfs:subClassOf lares:Robot .\n:robot a :Kind .\n");
    for (std::size_t i = 0; i < components_; ++i) {
      if (!Chance(2)) continue;
      text += ":robot lares:subComponent :part" + std::to_string(i) + " . :part" +
              std::to_string(i) + " a " + Name("P", i);
      if (Chance(2)) text += " ; lares:maxRange_m " + std::to_string(random_() % 6);
      if (Chance(2)) text += " ; lares:imageWidth_px " + std::to_string(random_() % 6);
      text += " .\n";
    }
    for (std::size_t i = 0; i < capabilities_; ++i) {
      if (Chance(4)) {
        text += ":robot lares:hasCapability " + Name("claim", i) + " . " + Name("claim", i) +
                " a " + Name("C", i) + " .\n";
      }
    }
    return text;
  }

 private:
  bool Chance(unsigned in) { return random_() % in == 0; }
  std::string Capability() { return Name("C", random_() % capabilities_); }
  std::string Component() { return Name("P", random_() % components_); }

  std::string Parent(const char* kind, const std::string& top, std::size_t i) {
    return i > 0 && Chance(3) ? Name(kind, random_() % i) : top;
  }
  std::string Uses() {
    if (Chance(5)) {
      return Some("lares:dependsOnComponent",
                  "[ a owl:Class ; owl:unionOf ( " + Component() + " " + Component() + " ) ]");
    }
    return Some("lares:dependsOnComponent", Component());
  }
  std::string Dependency() {
    if (Chance(6)) {
      return Some("lares:dependsOnCapability",
                  "[ a owl:Class ; owl:unionOf ( " + Capability() + " " + Capability() + " ) ]");
    }
    return Chance(2) ? Uses() : Some("lares:dependsOnCapability", Capability());
  }
  std::string Dependencies(unsigned most) {
    std::string text;
    for (std::size_t i = random_() % most; i > 0; --i) text += " , " + Dependency();
    return text;
  }
  std::string Requirement(const std::string& subject, unsigned in) {
    if (!Chance(in)) return "";
    return subject + " lares:requires [ a lares:NumericRequirement ; lares:ofPart " + Component() +
           " ; lares:quantity " + (Chance(2) ? "lares:maxRange_m" : "lares:imageWidth_px") + " ; " +
           (Chance(2) ? "lares:atLeast " : "lares:atMost ") + std::to_string(random_() % 6) +
           " ] .\n";
  }

  std::mt19937 random_;
  std::size_t capabilities_;
  std::size_t components_;
};

bool SaysAvailable(const rdf::View& view, const std::vector<std::string>& claims, bool strict,
                   const std::string& what) {
  prolog::List list;
  for (const std::string& claim : claims) list.push_back(Value{Atom{claim}});
  const Value context{prolog::Compound{
      "context",
      {Value{Atom{Example("robot")}}, Value{list}, Value{Atom{strict ? "true" : "false"}}}}};
  const auto answer =
      Engines().Once(view, "availability", "availability_of", {context, Value{Atom{what}}});
  return answer && answer->text() == "true";
}

TEST(MatchProperty, SingleConditionsAndWholeTasksAreJudgedAlike) {
  int there = 0;
  int missing = 0;
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    RandomWorld random(seed);
    const std::string recipe = random.Recipe();
    const std::string robot = random.Robot();
    World world = Catalogue();
    world.Put("robot", robot).Put("recipe", recipe);
    const rdf::View& view = world.view();
    const auto needs = recipes::FindNeeds(Engines(), view, Example("Task"), Example("robot"));
    const auto profile = recipes::DescribeRobot(Engines(), view, Example("robot"));
    std::vector<std::string> claims;
    for (const auto& claim : profile.claims) claims.push_back(claim.what.iri);
    for (const bool strict : {false, true}) {
      const auto assessment = recipes::Assess(needs, profile, {strict, {}});
      for (std::size_t i = 0; i < needs.nodes.size(); ++i) {
        const bool is_there = assessment.nodes[i].is_there;
        EXPECT_EQ(SaysAvailable(view, claims, strict, needs.nodes[i].what.iri), is_there)
            << "seed " << seed << (strict ? " strict " : " ") << needs.nodes[i].what.label;
        ++(is_there ? there : missing);
      }
    }
    if (HasFailure()) break;
  }
  EXPECT_GT(there, 300);
  EXPECT_GT(missing, 300);
}

TEST(MatchProperty, ARankedRobotIsJudgedAsOneThatIsMatched) {
  int feasible = 0;
  for (std::uint32_t seed = 0; seed < 80; ++seed) {
    RandomWorld random(seed);
    const std::string recipe = random.Recipe();
    World together = Catalogue();
    World alone = Catalogue();
    alone.Put("recipe", recipe);
    // The robot is of classes that the recipe makes, so they are in a module both know.
    const std::string robot = random.Robot();
    together.Put("robot", robot).Put("recipe", recipe);
    World body = Catalogue();
    body.Put("robot", robot);
    const auto report =
        recipes::Match(Engines(), together.view(), Example("Task"), Example("robot"));
    const auto ranked =
        recipes::Rank(recipes::FindNeeds(Engines(), alone.view(), Example("Task")),
                      recipes::DescribeRobot(Engines(), body.view(), Example("robot")));
    ASSERT_EQ(report.feasible, ranked.feasible) << seed;
    ASSERT_EQ(report.repairs.empty(), ranked.repair.add.empty()) << seed;
    if (!report.repairs.empty()) {
      EXPECT_EQ(report.repairs[0].cost, ranked.cost) << seed;
      ASSERT_EQ(report.repairs[0].add.size(), ranked.repair.add.size()) << seed;
      for (std::size_t i = 0; i < ranked.repair.add.size(); ++i) {
        EXPECT_EQ(report.repairs[0].add[i].what, ranked.repair.add[i].what) << seed;
      }
    }
    feasible += report.feasible ? 1 : 0;
  }
  EXPECT_GT(feasible, 5);
  EXPECT_LT(feasible, 75);
}

}  // namespace
}  // namespace lares::testing
