// Robots put as URDF over HTTP.
#include <gmock/gmock.h>

#include "server/api/robots.h"
#include "tests/robots/robot_texts.h"
#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;

class RobotsApiTest : public ApiTest {
 protected:
  // Turtle whose first bytes look like the element <robot.
  static constexpr const char* kRobotIri = "<robot#scout1> a <urn:Robot> .\n";
};

TEST_F(RobotsApiTest, AUrdfBecomesSrdlWithAReport) {
  const auto put = Send("PUT", "/v1/robots/turned", api::kUrdfType, TurnedRobot());
  ASSERT_EQ(put.status, 201) << put.body;
  const nlohmann::json import = Json(put)["import"];
  EXPECT_EQ(import["base_frame"], "base_footprint");
  EXPECT_EQ(import["base"]["kind"], "differential");
  EXPECT_EQ(import["height"]["is_lower_bound"], false);
  const nlohmann::json eye = import["sensors"][0];
  EXPECT_EQ(eye["link"], "mount");
  const double position_m[] = {0.982965919573, 2.456930555717, 0.692252844082};
  const double rotation_xyzw[] = {0.013718696344, 0.218703003506, 0.504646230490, 0.835052678387};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(eye["position_m"][i], position_m[i], 1e-9) << i;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(eye["rotation_xyzw"][i], rotation_xyzw[i], 1e-9) << i;
  }
  const auto srdl = Get("/v1/robots/turned");
  EXPECT_EQ(srdl.status, 200);
  EXPECT_THAT(srdl.body, HasSubstr("lares:urdfName \"mount\""));
}

TEST_F(RobotsApiTest, ThePosesFrameIsChosenByTheQuery) {
  const auto put =
      Send("PUT", "/v1/robots/turned?base_frame=base_link", api::kUrdfType, TurnedRobot());
  ASSERT_EQ(put.status, 201) << put.body;
  EXPECT_NEAR(Json(put)["import"]["sensors"][0]["position_m"][0], 0.204115365839, 1e-9);
  EXPECT_THAT(Get("/v1/robots/turned").body, HasSubstr("lares:baseFrameLink :base_link"));
  EXPECT_EQ(
      Send("PUT", "/v1/robots/turned?base_frame=base_lonk", api::kUrdfType, TurnedRobot()).status,
      404);
}

TEST_F(RobotsApiTest, AUrdfIsKnownByItsRootWhereTheTypeLeavesItOpen) {
  for (const char* type : {"application/octet-stream", "application/xml"}) {
    const auto put = Send("PUT", "/v1/robots/cart", type, Cart());
    ASSERT_LT(put.status, 300) << type << put.body;
    EXPECT_TRUE(Json(put).contains("import")) << type;
  }
}

TEST_F(RobotsApiTest, TurtleThatBeginsLikeAUrdfIsTurtle) {
  for (const char* type : {"text/turtle", "application/octet-stream"}) {
    const auto put = Send("PUT", "/v1/robots/scout?file_name=scout.ttl", type, kRobotIri);
    ASSERT_LT(put.status, 300) << type << put.body;
    EXPECT_FALSE(Json(put).contains("import")) << type;
    EXPECT_EQ(Get("/v1/robots/scout").body, kRobotIri) << type;
  }
  // What says to be Turtle is not looked into; whether it is, the reader says.
  const auto put = Send("PUT", "/v1/robots/cart", "text/turtle", Cart());
  EXPECT_FALSE(Json(put).contains("import"));
}

TEST_F(RobotsApiTest, TheUrdfIsKeptAsItCame) {
  Send("PUT", "/v1/robots/cart?file_name=my.urdf", api::kUrdfType, Cart());
  const auto urdf = Get("/v1/robots/cart/urdf");
  EXPECT_EQ(urdf.status, 200);
  EXPECT_EQ(urdf.body, Cart());
  EXPECT_EQ(urdf.headers.Get("Content-Type"), api::kUrdfType);
  Send("PUT", "/v1/robots/cart?file_name=my.urdf", api::kUrdfType, TurnedRobot());
  EXPECT_EQ(Get("/v1/robots/cart/urdf").body, TurnedRobot());
  EXPECT_EQ(Get("/v1/robots/cart/urdf?version=1").body, Cart());
  Send("PUT", "/v1/robots/scout", "text/turtle", kRobotIri);
  EXPECT_EQ(Get("/v1/robots/scout/urdf").status, 404);
}

TEST_F(RobotsApiTest, TheTreeIsAPicture) {
  Send("PUT", "/v1/robots/cart", api::kUrdfType, Cart());
  const auto svg = Get("/v1/robots/cart/tree");
  EXPECT_EQ(svg.status, 200);
  EXPECT_EQ(svg.headers.Get("Content-Type"), "image/svg+xml");
  EXPECT_THAT(std::string(svg.headers.Get("Content-Security-Policy")),
              HasSubstr("default-src 'none'"));
  EXPECT_THAT(svg.body, HasSubstr(">left_wheel</text>"));
  EXPECT_THAT(Get("/v1/robots/cart/tree?as=dot").body, HasSubstr("laser_joint (fixed)"));
  EXPECT_EQ(Get("/v1/robots/cart/tree?as=png").status, 422);
}

TEST_F(RobotsApiTest, TheDoctorFindsInStoredAndSentUrdfs) {
  Send("PUT", "/v1/robots/cart", api::kUrdfType, Cart());
  const auto stored = Json(Get("/v1/robots/cart/doctor"));
  EXPECT_EQ(stored["errors"], 0);
  EXPECT_GT(stored["warnings"], 0);
  const auto sent = Json(Send("POST", "/v1/robots/doctor?file_name=two.urdf", api::kUrdfType,
                              Robot(LinkText("a") + LinkText("b"))));
  EXPECT_EQ(sent["errors"], 1);
  EXPECT_EQ(sent["findings"][0]["code"], "two-roots");
  EXPECT_EQ(sent["findings"][0]["place"]["line"], 4);
  EXPECT_EQ(sent["findings"][0]["place"]["source"], "two.urdf");
}

TEST_F(RobotsApiTest, AMalformedUrdfStoresNothing) {
  const auto put = Send("PUT", "/v1/robots/bad", api::kUrdfType, "<robot name=\"r\">\n<link");
  EXPECT_EQ(put.status, 422) << put.body;
  EXPECT_EQ(Get("/v1/robots/bad").status, 404);
}

}  // namespace
}  // namespace lares::testing
