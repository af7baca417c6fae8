#include <gmock/gmock.h>

#include <thread>

#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class EnvironmentVersionsTest : public ApiTest {
 protected:
  int Put(const std::string& layer, const std::string& bytes,
          std::vector<http::FormPart> more = {}) {
    http::FormPart part;
    part.name = layer;
    part.file_name = layer == "semantic" ? "map.ttl" : "path.txt";
    part.text = bytes;
    more.push_back(part);
    const auto answer = SendForm("POST", "/v1/environments/flat/versions", more);
    EXPECT_EQ(answer.status, 201) << answer.body;
    return answer.status == 201 ? Json(answer)["version"]["number"].get<int>() : 0;
  }
  int PutPath(int poses) {
    std::string text;
    for (int i = 0; i < poses; ++i) text += std::to_string(i) + ".0 0 0 0 0 0 0 1\n";
    return Put("trajectory", text);
  }
  int PutBranch(const std::string& layer, const std::string& bytes, int parent) {
    http::FormPart field;
    field.name = "parent";
    field.text = std::to_string(parent);
    return Put(layer, bytes, {field});
  }
  http::ClientResponse Post(const std::string& what, const std::string& json) {
    return Send("POST", "/v1/environments/flat/" + what, "application/json", json);
  }
  http::ClientResponse Query(const std::string& path,
                             std::multimap<std::string, std::string> query) {
    return client_->Send({"GET", path, std::move(query), {}, {}});
  }
};

TEST_F(EnvironmentVersionsTest, DiffNamesLayersAndBytes) {
  PutPath(2);
  PutPath(3);
  const auto diff = Json(Get("/v1/environments/flat/diff"));
  EXPECT_EQ(diff["from"], 1);
  EXPECT_EQ(diff["to"], 2);
  EXPECT_EQ(diff["layers"][0]["change"], "changed");
  EXPECT_LT(diff["layers"][0]["bytes_before"], diff["layers"][0]["bytes_after"]);
  EXPECT_EQ(diff["objects"]["same"], 1);
  EXPECT_EQ(Query("/v1/environments/flat/diff", {{"from", "9"}}).status, 404);
  EXPECT_EQ(Query("/v1/environments/flat/diff", {{"tolerance_m", "nan"}}).status, 422);
  EXPECT_EQ(Get("/v1/environments/none/diff").status, 404);
}

TEST_F(EnvironmentVersionsTest, RollbackMakesAnOlderVersionTheNewest) {
  PutPath(2);
  PutPath(3);
  const auto answer = Post("rollback", R"({"to": 1, "author": "ann", "robot": "amigo"})");
  ASSERT_EQ(answer.status, 201) << answer.body;
  const auto version = Json(answer)["version"];
  EXPECT_EQ(version["number"], 3);
  EXPECT_EQ(version["origin"], "rollback");
  EXPECT_EQ(version["robot"], "amigo");
  EXPECT_EQ(version["layers"][0]["sha256"],
            Json(Get("/v1/environments/flat/versions/1"))["layers"][0]["sha256"]);
  EXPECT_EQ(Post("rollback", "{}").status, 422);
  EXPECT_EQ(Post("rollback", R"({"to": 99})").status, 404);
  EXPECT_EQ(Post("rollback", R"({"to": 1, "colour": "red"})").status, 422);
}

TEST_F(EnvironmentVersionsTest, BranchIsMergedPropertyByProperty) {
  Put("semantic", "<urn:a> <urn:p> 1 . <urn:b> <urn:p> 1 .");
  Put("semantic", "<urn:a> <urn:p> 2 . <urn:b> <urn:p> 1 .");
  EXPECT_EQ(PutBranch("semantic", "<urn:a> <urn:p> 1 . <urn:b> <urn:p> 3 .", 1), 3);
  EXPECT_EQ(Json(Get("/v1/environments/flat"))["latest"], 2);
  const auto dry = Post("merge", R"({"theirs": 3, "dry_run": true})");
  EXPECT_EQ(dry.status, 200);
  EXPECT_TRUE(Json(dry)["conflicts"].empty());
  const auto merged = Post("merge", R"({"theirs": 3})");
  ASSERT_EQ(merged.status, 201) << merged.body;
  EXPECT_THAT(Json(merged)["version"]["parents"], ElementsAre(2, 3));
  const std::string text = Get("/v1/environments/flat/versions/4/layers/semantic").body;
  EXPECT_THAT(text, HasSubstr("2"));
  EXPECT_THAT(text, HasSubstr("3"));
  EXPECT_EQ(Json(Post("merge", R"({"theirs": 3})"))["up_to_date"], true);
}

TEST_F(EnvironmentVersionsTest, ConflictsAreListedAndDecided) {
  Put("semantic", "<urn:a> <urn:p> 1 .");
  PutPath(2);  // 2
  Put("semantic", "<urn:a> <urn:p> 2 .");
  PutPath(5);  // 4
  PutBranch("semantic", "<urn:a> <urn:p> 3 .", 2);
  const auto refused = Post("merge", R"({"theirs": 5})");
  EXPECT_EQ(refused.status, 409);
  EXPECT_EQ(Json(refused)["code"], "merge-conflict");
  EXPECT_EQ(Json(refused)["conflicts"][0]["subject"], "urn:a");
  EXPECT_EQ(Json(Get("/v1/environments/flat"))["latest"], 4);
  EXPECT_EQ(Post("merge", R"({"theirs": 5, "take": {"urn:a": "mine"}})").status, 422);
  const auto merged = Post("merge", R"({"theirs": 5, "take": {"urn:a": "theirs"}})");
  ASSERT_EQ(merged.status, 201) << merged.body;
  EXPECT_THAT(Get("/v1/environments/flat/versions/6/layers/semantic").body, HasSubstr("3"));
  // The layer that only our side changed stayed ours.
  EXPECT_EQ(Get("/v1/environments/flat/versions/6/layers/trajectory").body,
            Get("/v1/environments/flat/versions/4/layers/trajectory").body);
}

TEST_F(EnvironmentVersionsTest, TagStandsForAVersionWhereverOneIsAskedFor) {
  PutPath(2);
  PutPath(3);
  EXPECT_EQ(
      Send("PUT", "/v1/environments/flat/tags/old", "application/json", R"({"version": 1})").status,
      200);
  EXPECT_EQ(Json(Get("/v1/environments/flat/versions/old"))["number"], 1);
  EXPECT_EQ(Get("/v1/environments/flat/versions/old/layers/trajectory").body,
            Get("/v1/environments/flat/versions/1/layers/trajectory").body);
  EXPECT_EQ(Json(Query("/v1/environments/flat/diff", {{"from", "old"}}))["to"], 2);
  EXPECT_EQ(Send("PUT", "/v1/environments/flat/tags/old", "application/json", "{}").status, 409);
  EXPECT_EQ(
      Send("PUT", "/v1/environments/flat/tags/old", "application/json", R"({"move": true})").status,
      200);
  EXPECT_EQ(Json(Get("/v1/environments/flat/tags"))["items"][0]["version"], 2);
  EXPECT_EQ(Get("/v1/environments/flat/versions/odl").status, 404);
  EXPECT_EQ(Send("DELETE", "/v1/environments/flat/tags/old", "", "").status, 204);
  EXPECT_EQ(Get("/v1/environments/flat/versions/old").status, 404);
}

TEST_F(EnvironmentVersionsTest, PinnedRobotGetsItsVersion) {
  PutPath(2);
  PutPath(3);
  Send("PUT", "/v1/robots/amigo", "text/turtle", kTurtle);
  ASSERT_EQ(
      Send("PUT", "/v1/robots/amigo/pins/flat", "application/json", R"({"version": 1})").status,
      200);
  EXPECT_EQ(Json(Query("/v1/environments/flat/versions/latest", {{"robot", "amigo"}}))["number"],
            1);
  EXPECT_EQ(Json(Get("/v1/robots/amigo/pins"))["items"][0]["environment"], "flat");
  EXPECT_EQ(Send("DELETE", "/v1/robots/amigo/pins/flat", "", "").status, 204);
  EXPECT_EQ(Json(Query("/v1/environments/flat/versions/latest", {{"robot", "amigo"}}))["number"],
            2);
  EXPECT_EQ(Send("DELETE", "/v1/robots/amigo/pins/flat", "", "").status, 404);
}

TEST_F(EnvironmentVersionsTest, AsOfATimeIsWhatWasTheNewestThen) {
  PutPath(2);
  const std::string time = Json(Get("/v1/environments/flat"))["changed"];
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  PutPath(3);
  EXPECT_EQ(Json(Query("/v1/environments/flat/versions/latest", {{"as_of", time}}))["number"], 1);
  EXPECT_EQ(Query("/v1/environments/flat/versions/latest", {{"as_of", "yesterday"}}).status, 422);
  EXPECT_EQ(
      Query("/v1/environments/flat/versions/latest", {{"as_of", "2001-01-01T00:00:00Z"}}).status,
      404);
  EXPECT_EQ(Query("/v1/environments/flat/versions/1", {{"as_of", time}}).status, 422);
}

TEST_F(EnvironmentVersionsTest, ListNarrowsAndPages) {
  PutPath(2);
  EXPECT_EQ(Json(Query("/v1/environments", {{"q", "flat"}}))["items"].size(), 1u);
  EXPECT_EQ(Json(Query("/v1/environments", {{"q", "house"}}))["items"].size(), 0u);
  EXPECT_EQ(Json(Query("/v1/environments", {{"layer", "trajectory"}}))["items"].size(), 1u);
  EXPECT_EQ(Query("/v1/environments", {{"changed_from", "x"}}).status, 422);
  EXPECT_TRUE(Json(Query("/v1/environments", {{"limit", "1"}}))["next"].is_null());
}

}  // namespace
}  // namespace lares::testing
