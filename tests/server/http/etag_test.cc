#include "server/http/etag.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace lares::http {
namespace {

Request With(const char* name, const char* value) {
  Request request;
  request.headers.Add(name, value);
  return request;
}

TEST(ETagTest, ReadsListsWithWeakTagsAndCommasInside) {
  const auto tags = ParseEntityTags(R"("a", W/"b" ,"c,d")");
  ASSERT_TRUE(tags);
  ASSERT_EQ(tags->size(), 3u);
  EXPECT_EQ((*tags)[0].tag, "\"a\"");
  EXPECT_TRUE((*tags)[1].weak);
  EXPECT_EQ((*tags)[2].tag, "\"c,d\"");
}

TEST(ETagTest, RefusesWhatIsNoList) {
  for (const char* text : {"", "a", "\"a", "\"a\" \"b\"", "W/", "w/\"a\"", "\"a\",b"}) {
    EXPECT_FALSE(ParseEntityTags(text)) << text;
  }
}

TEST(ETagTest, IfNoneMatchComparesWeakly) {
  EXPECT_TRUE(NoneMatchHits(R"("x", W/"a")", R"("a")"));
  EXPECT_TRUE(NoneMatchHits("*", R"("a")"));
  EXPECT_FALSE(NoneMatchHits(R"("x")", R"("a")"));
  EXPECT_FALSE(NoneMatchHits("", R"("a")"));
  EXPECT_FALSE(NoneMatchHits("*", ""));
  EXPECT_FALSE(NoneMatchHits("garbage", R"("a")"));
}

TEST(ETagTest, WritesMayBeBoundToAbsenceExistenceOrAVersion) {
  EXPECT_EQ(WriteCondition(Request{}, {}), "");
  EXPECT_EQ(WriteCondition(With("If-None-Match", "*"), {}), "none");
  EXPECT_EQ(WriteCondition(With("If-Match", "*"), {}), "*");
  EXPECT_EQ(WriteCondition(With("If-Match", R"("a")"), {}), R"("a")");
}

TEST(ETagTest, OneOfSeveralTagsSuffices) {
  EXPECT_EQ(WriteCondition(With("If-Match", R"("a", "b", "c")"), R"("b")"), R"("b")");
}

TEST(ETagTest, AWeakTagNeverAllowsAWrite) {
  const std::string condition = WriteCondition(With("If-Match", R"(W/"a")"), R"("a")");
  EXPECT_NE(condition, R"("a")");
  EXPECT_NE(condition, "");
}

TEST(ETagTest, RefusesConditionsThatMakeNoSense) {
  EXPECT_THROW(WriteCondition(With("If-Match", "abc"), {}), Error);
  EXPECT_THROW(WriteCondition(With("If-None-Match", R"("a")"), {}), Error);
  Request both = With("If-None-Match", "*");
  both.headers.Add("If-Match", "*");
  EXPECT_THROW(WriteCondition(both, {}), Error);
}

}  // namespace
}  // namespace lares::http
