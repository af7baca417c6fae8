#include "server/http/url.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace lares::http {
namespace {

TEST(UrlTest, EncodesAndDecodesEveryByteButZero) {
  std::string text;
  for (int byte = 1; byte < 256; ++byte) text += static_cast<char>(byte);
  EXPECT_EQ(PercentDecode(PercentEncode(text)), text);
  EXPECT_EQ(PercentEncode("a/b c~"), "a%2Fb%20c~");
}

TEST(UrlTest, RefusesHalfAnEscapeAndZeroBytes) {
  for (const char* text : {"%", "%2", "a%2", "%zz", "%00"}) {
    EXPECT_FALSE(PercentDecode(text)) << text;
  }
}

TEST(UrlTest, ReadsQueries) {
  const auto query = ParseQuery("a=1&b=x%20y+z&c&a=2&&d=%26");
  ASSERT_TRUE(query);
  EXPECT_EQ(query->count("a"), 2u);
  EXPECT_EQ(query->find("b")->second, "x y z");
  EXPECT_EQ(query->find("c")->second, "");
  EXPECT_EQ(query->find("d")->second, "&");
  EXPECT_FALSE(ParseQuery("a=%g1"));
}

TEST(UrlTest, WritesQueriesThatItReads) {
  const std::multimap<std::string, std::string> query{{"a b", "&="}, {"c", "ü"}};
  const std::string text = FormatQuery(query);
  EXPECT_EQ(text.front(), '?');
  EXPECT_EQ(ParseQuery(text.substr(1)), query);
  EXPECT_EQ(FormatQuery({}), "");
}

TEST(UrlTest, ReadsServerAddresses) {
  EXPECT_EQ(FormatBaseUrl(ParseBaseUrl("http://localhost:8080/")), "http://localhost:8080");
  EXPECT_EQ(FormatBaseUrl(ParseBaseUrl("http://[::1]:9")), "http://[::1]:9");
  EXPECT_EQ(ParseBaseUrl("http://localhost").port, 80);
  EXPECT_EQ(FormatBaseUrl(ParseBaseUrl("https://[::1]:9/")), "https://[::1]:9");
  EXPECT_EQ(ParseBaseUrl("https://localhost").port, 443);
  EXPECT_TRUE(ParseBaseUrl("https://localhost").tls);
  EXPECT_FALSE(ParseBaseUrl("http://localhost").tls);
  for (const char* text :
       {"", "localhost", "ftp://a", "https://", "https:/a", "http://", "http://a:0",
        "http://a:99999", "http://a:b", "http://a/b", "http://[::1", "http://a:"}) {
    EXPECT_THROW(ParseBaseUrl(text), Error) << text;
  }
}

}  // namespace
}  // namespace lares::http
