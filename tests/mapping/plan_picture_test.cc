#include "mapping/picture/plan_picture.h"

#include <gtest/gtest.h>
#include <png.h>

#include <limits>
#include <set>

#include "base/error.h"
#include "mapping/picture/png.h"

namespace lares::picture {
namespace {

constexpr Colour kFree{255, 255, 255};

grid::Grid Room() {
  // 4 m × 2 m of free floor with a wall at the left and one cell occupied at the top right.
  grid::Grid grid;
  grid.resolution_m = 0.1;
  grid.origin_x_m = -1;
  grid.origin_y_m = 3;
  grid.width = 40;
  grid.height = 20;
  grid.cells.assign(800, grid::Cell::kFree);
  for (std::uint32_t y = 0; y < 20; ++y) grid.cells[grid.IndexOf(0, y)] = grid::Cell::kOccupied;
  grid.cells[grid.IndexOf(39, 19)] = grid::Cell::kOccupied;
  return grid;
}

semantic::MapObject Box(double x_m, double y_m, double yaw_rad, Eigen::Vector3d extent_m) {
  semantic::MapObject object;
  object.class_iri = "x:Table";
  RigidTransform pose;
  pose.translation_m = {x_m, y_m, 0.4};
  pose.rotation = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
  object.map_from_object = pose;
  object.extent_m = extent_m;
  return object;
}

bool IsDark(const Colour& colour) { return colour[0] < 100 && colour[1] < 100 && colour[2] < 100; }

bool IsObject(const Colour& colour) {
  return !IsDark(colour) && !(colour[0] == colour[1] && colour[1] == colour[2]);
}

Colour At(const Image& image, double x_share, double y_share_from_top) {
  const auto column = static_cast<std::size_t>(x_share * image.width);
  const auto row = static_cast<std::size_t>(y_share_from_top * image.height);
  return image.pixels[row * image.width + column];
}

TEST(PlanPictureTest, GridIsDrawnWithYUpwardsAndItsShape) {
  const grid::Grid room = Room();
  const Image image = DrawPlan(&room, {}, {200});
  EXPECT_EQ(image.width, 200u);
  EXPECT_EQ(image.height, 100u);
  EXPECT_TRUE(IsDark(At(image, 0.055, 0.5)));  // the wall
  EXPECT_EQ(At(image, 0.5, 0.5), kFree);
  EXPECT_TRUE(IsDark(At(image, 0.945, 0.07)));   // the single cell, top right
  EXPECT_FALSE(IsDark(At(image, 0.945, 0.93)));  // not bottom right
}

TEST(PlanPictureTest, ThinWallStaysWhenManyCellsFallOnAPixel) {
  const grid::Grid room = Room();
  const Image image = DrawPlan(&room, {}, {16});
  bool dark = false;
  for (const Colour& colour : image.pixels) dark = dark || IsDark(colour);
  EXPECT_TRUE(dark);
}

TEST(PlanPictureTest, ObjectStandsWhereAndHowItStands) {
  const grid::Grid room = Room();
  // 2 m along x of its own frame, turned by a quarter: along y of the map.
  const Image image = DrawPlan(&room, {Box(1, 4, 1.5707963, {1.6, 0.2, 0.8})}, {200});
  EXPECT_TRUE(IsObject(At(image, 0.5, 0.5)));
  EXPECT_TRUE(IsObject(At(image, 0.5, 0.2)));
  EXPECT_FALSE(IsObject(At(image, 0.6, 0.5)));
}

TEST(PlanPictureTest, TurnsAreToTheLeftOfObjectsAndOfGrids) {
  const grid::Grid room = Room();
  // 30° to the left: its far end lies to the right and above, not below.
  const Image image = DrawPlan(&room, {Box(1, 4, 0.5235988, {1.6, 0.1, 0.8})}, {220});
  EXPECT_TRUE(IsObject(At(image, 0.5 + 0.6 / 4.4, 0.5 - 0.346 / 2.2)));
  EXPECT_FALSE(IsObject(At(image, 0.5 + 0.6 / 4.4, 0.5 + 0.346 / 2.2)));
  // A quarter to the left: the wall, at the grid's left, comes to lie below.
  grid::Grid turned = room;
  turned.yaw_rad = 1.57079632679;
  const Image upright = DrawPlan(&turned, {}, {220});
  EXPECT_EQ(upright.width, 110u);
  EXPECT_TRUE(IsDark(At(upright, 0.5, 0.945)));
  EXPECT_FALSE(IsDark(At(upright, 0.5, 0.055)));
}

TEST(PlanPictureTest, ManyLargeObjectsTakeNoLongTime) {
  std::vector<semantic::MapObject> objects(20000, Box(0, 0, 0.1, {50, 50, 1}));
  EXPECT_EQ(DrawPlan(nullptr, objects, {64}).width, 64u);
}

TEST(PlanPictureTest, SmallerObjectShowsOnTheLarger) {
  semantic::MapObject cup = Box(0, 0, 0, {0.2, 0.2, 0.1});
  cup.class_iri = "x:Bottle";
  const Image image = DrawPlan(nullptr, {cup, Box(0, 0, 0, {2, 2, 0.7})}, {100});
  EXPECT_NE(At(image, 0.5, 0.5), At(image, 0.2, 0.5));
  EXPECT_TRUE(IsObject(At(image, 0.2, 0.5)));
}

TEST(PlanPictureTest, NothingKnownIsAGreyPlateAndAbsurdPosesAreLeftOut) {
  const Image empty = DrawPlan(nullptr, {}, {32});
  EXPECT_EQ(std::set<Colour>(empty.pixels.begin(), empty.pixels.end()).size(), 1u);
  const Image far = DrawPlan(nullptr, {Box(1e300, 0, 0, {1, 1, 1})}, {32});
  EXPECT_EQ(std::set<Colour>(far.pixels.begin(), far.pixels.end()).size(), 1u);
}

TEST(PlanPictureTest, SizeOutOfRangeIsRefused) {
  EXPECT_THROW(DrawPlan(nullptr, {}, {15}), Error);
  EXPECT_THROW(DrawPlan(nullptr, {}, {2049}), Error);
}

TEST(PngTest, ReadsBackAsWritten) {
  const grid::Grid room = Room();
  const Image image = DrawPlan(&room, {Box(1, 4, 0.3, {1, 0.5, 1})}, {64});
  const std::string bytes = ToPng(image);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()), 0);
  EXPECT_EQ(png.width, image.width);
  EXPECT_EQ(png.height, image.height);
  png.format = PNG_FORMAT_RGB;
  std::vector<Colour> pixels(image.pixels.size());
  ASSERT_NE(png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_EQ(pixels, image.pixels);
  EXPECT_THROW(ToPng({}), Error);
}

}  // namespace
}  // namespace lares::picture
