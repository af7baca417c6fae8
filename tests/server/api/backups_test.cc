#include <gmock/gmock.h>

#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;

class BackupsApiTest : public ApiTest {
 protected:
  http::ClientResponse Make(const std::string& name) {
    return Send("POST", "/v1/backups", "application/json", "{\"name\": \"" + name + "\"}");
  }
};

TEST_F(BackupsApiTest, BackupIsMadeListedAndRestoresToTheSameDigest) {
  context_->backups = folder_ / "backups";
  ASSERT_EQ(Send("PUT", "/v1/recipes/a", "text/turtle", kTurtle).status, 201);
  const auto made = Make("monday");
  ASSERT_EQ(made.status, 201) << made.body;
  EXPECT_EQ(Json(Get("/v1/backups"))["items"][0]["name"], "monday");
  const auto restored = store::OpenSqliteStore({folder_ / "restored"});
  restored->FillFrom(folder_ / "backups" / "monday", {});
  EXPECT_EQ(restored->Digest(), Json(made)["digest"]);
}

TEST_F(BackupsApiTest, NameThatIsTakenOrLeadsElsewhereIsRefused) {
  context_->backups = folder_ / "backups";
  EXPECT_EQ(Make("a").status, 201);
  EXPECT_EQ(Make("a").status, 409);
  for (const char* name : {"", "..", "../x", "/etc", "a/b"}) EXPECT_EQ(Make(name).status, 422);
  EXPECT_EQ(Send("POST", "/v1/backups", "application/json", "{").status, 400);
  EXPECT_EQ(Send("POST", "/v1/backups", "application/json", "[]").status, 422);
}

TEST_F(BackupsApiTest, ServerWithoutAFolderSaysHowToGetOne) {
  const auto answer = Make("a");
  EXPECT_EQ(answer.status, 403);
  EXPECT_THAT(answer.body, HasSubstr("--backups"));
}

TEST_F(BackupsApiTest, VerificationNamesWhatIsWrong) {
  ASSERT_EQ(Send("PUT", "/v1/recipes/a", "text/turtle", kTurtle).status, 201);
  EXPECT_TRUE(Json(Send("POST", "/v1/verification", "", ""))["problems"].empty());
  const std::string sha256 = store_->FindDocument(store::DocumentKind::kRecipe, "a")->blob.sha256;
  std::filesystem::resize_file(store_->BlobPath(sha256), 1);
  const auto problems = Json(Send("POST", "/v1/verification", "", ""))["problems"];
  ASSERT_FALSE(problems.empty());
  EXPECT_THAT(problems.dump(), HasSubstr(sha256));
}

}  // namespace
}  // namespace lares::testing
