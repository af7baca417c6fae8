#include "base/text.h"

#include "base/xml_text.h"

#include <gtest/gtest.h>

namespace lares {
namespace {

TEST(TextTest, SplitKeepsEmptyParts) {
  EXPECT_EQ(Split("a\t\tb", '\t'), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(Join(Split("x,y", ','), ", "), "x, y");
}

TEST(TextTest, Utf8RefusesOverlongSurrogatesAndTruncation) {
  EXPECT_TRUE(IsUtf8("Küche \xF0\x9F\xA4\x96"));
  EXPECT_FALSE(IsUtf8("\xC0\xAF"));
  EXPECT_FALSE(IsUtf8("\xED\xA0\x80"));
  EXPECT_FALSE(IsUtf8("\xE2\x82"));
  EXPECT_FALSE(IsUtf8("\xF4\x90\x80\x80"));
}

TEST(TextTest, SimilarNamesPutTheNearestFirst) {
  EXPECT_EQ(SimilarNames("FindBotle", {"FindBottle", "FindBowl", "ServeADrink"}),
            (std::vector<std::string>{"FindBottle", "FindBowl"}));
  EXPECT_TRUE(SimilarNames("zzzz", {"FindBottle"}).empty());
}

TEST(TextTest, IdentifiersAreSafeFileNames) {
  EXPECT_TRUE(IsIdentifier("hospital-room_2.b"));
  for (const char* bad : {"", ".", "..", "-x", "a/b", "a b", "ü"}) EXPECT_FALSE(IsIdentifier(bad));
}

TEST(TextTest, LocalNameIsWhatPeopleSay) {
  EXPECT_EQ(LocalName("http://a/b#Cup"), "Cup");
  EXPECT_EQ(LocalName("http://a/b/Cup"), "Cup");
  EXPECT_EQ(LocalName("Cup"), "Cup");
  EXPECT_EQ(LocalName("http://a/b#"), "http://a/b#");
}

TEST(TextTest, ShorteningCountsCodePointsAndCutsNone) {
  EXPECT_EQ(CodePoints("größe"), 5U);
  EXPECT_EQ(Shortened("größe", 5), "größe");
  EXPECT_EQ(Shortened("größe", 4), "grö…");
  EXPECT_EQ(Shortened("größe", 1), "…");
  EXPECT_EQ(Shortened("", 3), "");
}

TEST(XmlTextTest, AReaderGetsTheTextBack) {
  EXPECT_EQ(EscapedXml("a<b>&\"c\n\t\r", XmlUse::kAttribute),
            "a&lt;b&gt;&amp;&quot;c&#10;&#9;&#13;");
  EXPECT_EQ(EscapedXml("a<b>&\"c\n\t\r", XmlUse::kText), "a&lt;b&gt;&amp;\"c\n\t&#13;");
  EXPECT_EQ(EscapedXml("a\x01"
                       "b",
                       XmlUse::kText),
            "a\xEF\xBF\xBD"
            "b");
}

}  // namespace
}  // namespace lares
