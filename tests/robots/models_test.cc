// Our own robots: they load, and FindBottle finds in each what it needs or says what lacks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "recipes/match/capabilities.h"
#include "tests/lares_data.h"
#include "tests/recipes/world.h"

namespace lares::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct Expected {
  const char* file;
  const char* robot;  // local name
  std::vector<std::string> lacks;
};

std::string RobotIri(const Expected& expected) {
  const std::string stem =
      std::string(expected.file).substr(0, std::string(expected.file).size() - 4);
  return "https://w3id.org/lares/robots/" + stem + "#" + expected.robot;
}

const std::vector<Expected>& Robots() {
  static const std::vector<std::string> kRecognition = {"object recognition component",
                                                        "object recognition model"};
  static const std::vector<Expected> robots = {{"pioneer-p3dx.ttl", "pioneer_p3dx1", {}},
                                               {"amigo.ttl", "amigo1", {}},
                                               {"tiago.ttl", "tiago1", kRecognition},
                                               {"turtlebot4.ttl", "turtlebot41", kRecognition},
                                               {"hsr.ttl", "hsr1", kRecognition}};
  return robots;
}

TEST(ModelsTest, FindBottleIsMatchedWithEachOfOurRobots) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/object-search-recipe.owl");
  for (const Expected& expected : Robots()) {
    World world = Catalogue();
    world.PutFile("recipe:search", recipe, true);
    world.PutFile("robot:model", Source(std::string("robots/models/") + expected.file));
    const recipes::MatchReport report =
        recipes::Match(Engines(), world.view(), Lares("FindBottle"), RobotIri(expected));
    EXPECT_EQ(report.feasible, expected.lacks.empty()) << expected.file;
    EXPECT_EQ(Labels(report.smallest_repair), expected.lacks) << expected.file;
  }
}

TEST(ModelsTest, WhatTheyCanIsInferredFromTheirParts) {
  World world = Catalogue();
  world.PutFile("robot:model", Source("robots/models/turtlebot4.ttl"));
  const auto report = recipes::Capabilities(Engines(), world.view(),
                                            "https://w3id.org/lares/robots/turtlebot4#turtlebot41");
  std::vector<std::string> there;
  for (const recipes::Finding& finding : report.capabilities) {
    if (finding.availability == recipes::Availability::kAvailable) {
      there.push_back(finding.what.label);
    }
  }
  EXPECT_THAT(there, ::testing::IsSupersetOf({"base motion capability", "navigation capability",
                                              "localization capability"}));
  EXPECT_THAT(there, ::testing::Not(::testing::Contains("arm motion capability")));
  EXPECT_GT(report.capabilities.size(), 30u);
}

}  // namespace
}  // namespace lares::testing
