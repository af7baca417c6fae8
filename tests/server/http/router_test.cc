#include "server/http/router.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace lares::http {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Router Make(const std::vector<std::pair<std::string, std::string>>& routes) {
  Router router;
  for (const auto& [method, path] : routes) {
    router.Add({method, path, method + path, nullptr, {}, 0});
  }
  return router;
}

std::string Operation(const Router::Match& match) {
  return match.route == nullptr ? "" : match.route->operation;
}

TEST(RouterTest, TakesTheParametersFromThePath) {
  const Router router = Make({{"GET", "/v1/environments/{id}/versions/{number}"}});
  const auto match = router.Find("GET", "/v1/environments/hospital-room/versions/3");
  ASSERT_NE(match.route, nullptr);
  EXPECT_EQ(match.params.at("id"), "hospital-room");
  EXPECT_EQ(match.params.at("number"), "3");
}

TEST(RouterTest, AnEncodedSlashStaysInItsSegment) {
  const Router router = Make({{"GET", "/v1/robots/{id}"}});
  const auto match = router.Find("GET", "/v1/robots/http%3A%2F%2Fa%2Fb%23c");
  ASSERT_NE(match.route, nullptr);
  EXPECT_EQ(match.params.at("id"), "http://a/b#c");
}

TEST(RouterTest, MoreLiteralTextWins) {
  const Router router = Make({{"GET", "/v/{n}"}, {"GET", "/v/{n}.tar"}, {"GET", "/v/latest"}});
  EXPECT_EQ(Operation(router.Find("GET", "/v/3")), "GET/v/{n}");
  EXPECT_EQ(Operation(router.Find("GET", "/v/3.tar")), "GET/v/{n}.tar");
  EXPECT_EQ(router.Find("GET", "/v/3.tar").params.at("n"), "3");
  EXPECT_EQ(Operation(router.Find("GET", "/v/latest")), "GET/v/latest");
  EXPECT_EQ(Operation(router.Find("GET", "/v/.tar")), "GET/v/{n}");
}

TEST(RouterTest, HeadIsAnsweredByGet) {
  EXPECT_EQ(Operation(Make({{"GET", "/a"}}).Find("HEAD", "/a")), "GET/a");
}

TEST(RouterTest, ListsTheMethodsOfAPathThatHasOthers) {
  const Router router = Make({{"GET", "/a/{x}"}, {"PUT", "/a/{x}"}, {"DELETE", "/a/{x}"}});
  const auto match = router.Find("PATCH", "/a/1");
  EXPECT_EQ(match.route, nullptr);
  EXPECT_THAT(match.allow, ElementsAre("DELETE", "GET", "HEAD", "PUT"));
}

TEST(RouterTest, KnowsNothingOfOtherPaths) {
  const Router router = Make({{"GET", "/a/{x}"}});
  for (const char* path : {"/", "", "/a", "/a/", "/a/1/", "/a/1/2", "/b/1", "/A/1", "/a/%zz"}) {
    const auto match = router.Find("GET", path);
    EXPECT_EQ(match.route, nullptr) << path;
    EXPECT_THAT(match.allow, IsEmpty()) << path;
  }
}

TEST(RouterTest, RefusesMalformedAndRepeatedRoutes) {
  for (const char* path : {"a", "/{", "/}", "/{}", "/}a{"}) {
    EXPECT_THROW(Make({{"GET", path}}), Error) << path;
  }
  EXPECT_THROW(Make({{"GET", "/a"}, {"GET", "/a"}}), Error);
}

}  // namespace
}  // namespace lares::http
