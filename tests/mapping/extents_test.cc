#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mapping/environment/layer_format.h"

namespace lares::environment {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

LayerFacts Box(double x_m, double y_m, double width_m, double height_m) {
  LayerFacts facts;
  facts.bounds_m = {x_m, y_m, 0, x_m + width_m, y_m + height_m, 2.5};
  return facts;
}

TEST(ExtentsTest, CorridorMapOfASmallRoomIsRemarkedOn) {
  EXPECT_THAT(WarnOnExtents({{"octomap", Box(-10, -5, 39.2, 15)}, {"semantic", Box(0, 0, 6, 4)}}),
              ElementsAre("the octomap layer is 39.2 m long but the semantic layer only 6 m: are "
                          "they of one environment?"));
}

TEST(ExtentsTest, LayersApartAreRemarkedOn) {
  EXPECT_THAT(WarnOnExtents({{"grid", Box(0, 0, 6, 4)}, {"cloud", Box(9, 8, 6, 4)}}),
              ElementsAre("the cloud layer and the grid layer lie 5 m apart: are they in one "
                          "frame?"));
}

TEST(ExtentsTest, SimilarLayersAreFine) {
  EXPECT_THAT(WarnOnExtents({{"octomap", Box(0, 0, 8, 6)},
                             {"semantic", Box(0.5, 0.2, 6, 4)},
                             {"trajectory", Box(3, 2, 3, 2)}}),
              IsEmpty());
}

TEST(ExtentsTest, ShortTrajectoriesAreFineButNotLongOnes) {
  EXPECT_THAT(WarnOnExtents({{"octomap", Box(0, 0, 39, 15)}, {"trajectory", Box(1, 1, 1, 1)}}),
              IsEmpty());
  EXPECT_THAT(WarnOnExtents({{"octomap", Box(0, 0, 6, 4)}, {"trajectory", Box(0, 0, 39, 4)}}),
              ElementsAre("the trajectory layer is 39 m long but the octomap layer only 6 m: are "
                          "they of one environment?"));
}

TEST(ExtentsTest, FewObjectsInALargerRoomAreFine) {
  EXPECT_THAT(WarnOnExtents({{"octomap", Box(0, 0, 8, 6)}, {"semantic", Box(1, 1, 0.1, 0.1)}}),
              IsEmpty());
}

TEST(ExtentsTest, LayersWithoutBoundsArePassedOver) {
  EXPECT_THAT(WarnOnExtents({{"octomap", Box(0, 0, 39, 15)}, {"semantic", {}}, {"features", {}}}),
              IsEmpty());
}

}  // namespace
}  // namespace lares::environment
