#include "server/http/tus.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "server/http/problem.h"

namespace lares::http {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

std::string ProblemOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const ProblemError& error) {
    return error.problem_code();
  }
  return "";
}

TEST(TusTest, Base64IsReadStrictly) {
  EXPECT_EQ(DecodeBase64(""), "");
  EXPECT_EQ(DecodeBase64("Zg=="), "f");
  EXPECT_EQ(DecodeBase64("Zm8="), "fo");
  EXPECT_EQ(DecodeBase64("Zm9v"), "foo");
  EXPECT_EQ(DecodeBase64("/+8A"), std::string("\xff\xef\0", 3));
  for (const char* wrong :
       {"Z", "Zg", "Zg=", "Zg===", "Zh==", "Zm9=", "Zm 9", "Zm-_", "=Zg=", "===="}) {
    EXPECT_EQ(DecodeBase64(wrong), std::nullopt) << wrong;
  }
}

TEST(TusTest, MetadataArePairs) {
  EXPECT_THAT(ParseUploadMetadata("filename cm9vbS5idA==, is_final"),
              ElementsAre(Pair("filename", "room.bt"), Pair("is_final", "")));
  EXPECT_TRUE(ParseUploadMetadata("").empty());
}

TEST(TusTest, MalformedMetadataAreRefused) {
  for (const std::string wrong :
       {",", "a,,b", "a b c", "a ?", "a Zg==,a Zg==", "\x01 Zg==", "\xc3\xa4 Zg=="}) {
    EXPECT_EQ(ProblemOf([&] { ParseUploadMetadata(wrong); }), "bad-request") << wrong;
  }
  EXPECT_EQ(ProblemOf([] { ParseUploadMetadata(std::string(5000, 'a')); }), "bad-request");
}

TEST(TusTest, AChecksumIsOfSha256) {
  EXPECT_EQ(ParseUploadChecksum(""), std::nullopt);
  EXPECT_EQ(ParseUploadChecksum("sha256 47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU="),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  for (const char* wrong : {"sha256", "sha256 ", "sha256 Zg==", "sha1 2jmj7l5rSw0yVb/vlWAYkK/YBwk=",
                            "SHA256 47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU="}) {
    EXPECT_EQ(ProblemOf([&] { ParseUploadChecksum(wrong); }), "bad-request") << wrong;
  }
}

TEST(TusTest, NumbersAreDecimalDigits) {
  const auto read = [](const std::string& text) {
    Request request;
    request.headers.Set("Upload-Length", text);
    return ReadUploadNumber(request, "Upload-Length");
  };
  EXPECT_EQ(read("0"), 0U);
  EXPECT_EQ(read("9223372036854775807"), 9223372036854775807U);
  for (const char* wrong : {"", "-1", "+1", " 1", "1 ", "0x1", "1.0", "9223372036854775808"}) {
    EXPECT_EQ(ProblemOf([&] { read(wrong); }), "bad-request") << wrong;
  }
}

TEST(TusTest, DatesAreThoseOfHttp) {
  EXPECT_EQ(FormatHttpDate(Time(std::chrono::milliseconds(784111777'999))),
            "Sun, 06 Nov 1994 08:49:37 GMT");
}

}  // namespace
}  // namespace lares::http
