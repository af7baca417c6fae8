#include "robots/urdf/tree_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/urdf/import.h"
#include "robots/urdf/xml_tree.h"
#include "tests/robots/robot_texts.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(TreePictureTest, EveryLinkIsABoxAndEveryJointAnEdgeWithItsKind) {
  const urdf::Imported robot = urdf::Import(Cart(), "cart.urdf");
  const std::string svg = urdf::ToSvg(robot.model, robot.body);
  for (const urdf::Link& link : robot.model.links) {
    EXPECT_THAT(svg, HasSubstr(">" + link.name + "</text>"));
  }
  EXPECT_THAT(svg, HasSubstr(">continuous</text>"));
  EXPECT_THAT(svg, HasSubstr(">RGB-D camera</text>"));
  EXPECT_THAT(svg, HasSubstr(">differential base</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("http://www.w3.org/1999")));
  const std::string dot = urdf::ToDot(robot.model, robot.body);
  EXPECT_THAT(dot, HasSubstr("laser_joint (fixed)"));
}

TEST(TreePictureTest, NamesCannotBreakOut) {
  const urdf::Imported robot =
      urdf::Import(Robot(LinkText("&lt;script&gt;alert(1)&lt;/script&gt;&quot;\\")), "cart.urdf");
  const std::string svg = urdf::ToSvg(robot.model, robot.body);
  EXPECT_THAT(svg, Not(HasSubstr("<script>")));
  EXPECT_THAT(urdf::ToDot(robot.model, robot.body), HasSubstr("\\\"\\\\"));
}

}  // namespace
}  // namespace lares::testing
