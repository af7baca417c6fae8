#include <gmock/gmock.h>

#include "base/hash.h"
#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;

class PackageApiTest : public ApiTest {
 protected:
  PackageApiTest() {
    store::NewVersion version;
    version.environment = "room";
    const auto writer = store_->NewBlob();
    writer->Append(kTrajectory);
    version.layers.push_back({"trajectory", "path.txt", "text/plain", writer->Commit(), {}});
    store_->PutVersion(version);
  }
  static constexpr const char* kGrid = "/v1/environments/room/versions/1/robot-grid/scout/";
};

TEST_F(PackageApiTest, GridIsServedAsTwoFilesWithTagAndRange) {
  const auto image = Get(std::string(kGrid) + "map.pgm");
  EXPECT_EQ(image.status, 200);
  EXPECT_EQ(image.body, "P5\n2 1\n255\nab");
  EXPECT_EQ(image.headers.Get("Content-Type"), "image/x-portable-graymap");
  const std::string tag(image.headers.Get("ETag"));
  EXPECT_EQ(tag, "\"" + Sha256Hex(image.body).substr(0, 32) + "\"");
  EXPECT_EQ(Get(std::string(kGrid) + "map.pgm", "If-None-Match", tag).status, 304);
  const auto part = Get(std::string(kGrid) + "map.pgm", "Range", "bytes=11-");
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(part.body, "ab");
  const auto yaml = Get(std::string(kGrid) + "map.yaml");
  EXPECT_EQ(yaml.status, 200);
  EXPECT_THAT(yaml.body, HasSubstr("image: map.pgm\n"));
  EXPECT_EQ(Get("/v1/environments/room/versions/latest/robot-grid/scout/map.yaml").status, 200);
}

TEST_F(PackageApiTest, UnknownNamesAreNotFound) {
  EXPECT_EQ(Get("/v1/environments/room/versions/1/robot-grid/nobody/map.pgm").status, 404);
  EXPECT_EQ(Get("/v1/environments/none/versions/1/robot-grid/scout/map.pgm").status, 404);
  EXPECT_EQ(Get("/v1/environments/room/versions/7/robot-grid/scout/map.pgm").status, 404);
  EXPECT_EQ(Get(std::string(kGrid) + "map.png").status, 404);
}

TEST_F(PackageApiTest, PlanAsJsonHoldsThePackageAndItsLinksLead) {
  const auto plan = Send("POST", "/v1/plans", "application/json",
                         R"({"task":"t","robot":"scout","environment":"room"})");
  ASSERT_EQ(plan.status, 200) << plan.body;
  const nlohmann::json package = Json(plan)["package"];
  EXPECT_EQ(package["format"], "lares-package");
  EXPECT_EQ(package["environment"]["version"], 1);
  for (const auto& file :
       {package["grid"]["yaml"], package["grid"]["image"], package["layers"][0]}) {
    const auto got = Get(file["link"]);
    EXPECT_EQ(got.status, 200) << file;
    EXPECT_EQ(got.body.size(), file["size"]);
    EXPECT_EQ(Sha256Hex(got.body), file["sha256"]);
  }
  EXPECT_FALSE(package.contains("no_grid"));
  EXPECT_EQ(package["grid"]["heights_m"][1], 1.4);
}

TEST_F(PackageApiTest, OtherFormatsHaveNoPackage) {
  const auto plan = Send("POST", "/v1/plans?as=bt-xml", "application/json",
                         R"({"task":"t","robot":"scout","environment":"room"})");
  EXPECT_THAT(plan.body, ::testing::Not(HasSubstr("lares-package")));
}

TEST_F(PackageApiTest, WithoutEnvironmentThereIsNoGridAndAReason) {
  const auto plan =
      Json(Send("POST", "/v1/plans", "application/json", R"({"task":"t","robot":"scout"})"));
  EXPECT_TRUE(plan["package"]["grid"].is_null());
  EXPECT_TRUE(plan["package"]["environment"].is_null());
  EXPECT_EQ(plan["package"]["no_grid"], "the plan was made for no environment");
}

}  // namespace
}  // namespace lares::testing
