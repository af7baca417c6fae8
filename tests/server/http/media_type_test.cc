#include "server/http/media_type.h"

#include <gtest/gtest.h>

namespace lares::http {
namespace {

const std::vector<std::string> kOffered{"application/rdf+xml", "text/turtle"};

TEST(MediaTypeTest, ReadsTypeAndParameters) {
  const auto media = ParseMediaType("Text/Turtle ; Charset=\"ut\\\"f;8\"; a=b");
  ASSERT_TRUE(media);
  EXPECT_EQ(media->type, "text/turtle");
  EXPECT_EQ(media->parameters.at("charset"), "ut\"f;8");
  EXPECT_EQ(media->parameters.at("a"), "b");
}

TEST(MediaTypeTest, RefusesWhatIsNone) {
  for (const char* text : {"", "text", "/turtle", "text/", "text/a b", "text/a;b", "text/a; b=\"c",
                           "text/a; =c", "te xt/a"}) {
    EXPECT_FALSE(ParseMediaType(text)) << text;
  }
}

TEST(MediaTypeTest, TheClientsLikingDecides) {
  EXPECT_EQ(ChooseMediaType("", kOffered), "application/rdf+xml");
  EXPECT_EQ(ChooseMediaType("*/*", kOffered), "application/rdf+xml");
  EXPECT_EQ(ChooseMediaType("text/turtle", kOffered), "text/turtle");
  EXPECT_EQ(ChooseMediaType("text/*, application/rdf+xml;q=0.5", kOffered), "text/turtle");
  EXPECT_EQ(ChooseMediaType("*/*;q=0.1, text/turtle;q=0", kOffered), "application/rdf+xml");
}

TEST(MediaTypeTest, SaysWhenNothingIsAcceptable) {
  EXPECT_EQ(ChooseMediaType("image/png", kOffered), std::nullopt);
  EXPECT_EQ(ChooseMediaType("*/*;q=0", kOffered), std::nullopt);
}

TEST(MediaTypeTest, KnowsFilesByTheirExtension) {
  EXPECT_EQ(MediaTypeOfFile("PR2.OWL"), "application/rdf+xml");
  EXPECT_EQ(MediaTypeOfFile("map.bt"), "application/octet-stream");
}

}  // namespace
}  // namespace lares::http
