#include "server/http/zstd.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "server/http/content_coding.h"
#include "server/http/etag.h"
#include "server/http/problem.h"
#include "server/http/service.h"

namespace lares::http {
namespace {

using ::testing::HasSubstr;

std::string Encode(const std::string& text) {
  std::string encoded;
  ZstdEncoder encoder;
  const Sink give = [&](std::string_view piece) { encoded += piece; };
  encoder.Feed(text, give);
  encoder.End(give);
  return encoded;
}

std::string Decode(const std::string& bytes, const DecodeLimits& limits = {}) {
  std::string decoded;
  ZstdDecoder decoder(limits);
  decoder.Feed(bytes, [&](std::string_view piece) { decoded += piece; });
  decoder.Finish();
  return decoded;
}

std::string CodeOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const ProblemError& error) {
    return error.problem_code();
  } catch (const Error& error) {
    return std::string(ToString(error.code()));
  }
  return "";
}

std::string Text(std::size_t size) {
  std::string text;
  while (text.size() < size) text += "line " + std::to_string(text.size() * 7919 % 10007) + "\n";
  return text;
}

TEST(ZstdTest, TextComesBackWhateverThePieces) {
  const std::string text = Text(1'000'000);
  const std::string encoded = Encode(text);
  EXPECT_LT(encoded.size(), text.size() / 2);
  EXPECT_EQ(Decode(encoded), text);
  ZstdDecoder decoder({});
  std::string decoded;
  for (const char c : encoded) {
    decoder.Feed({&c, 1}, [&](std::string_view piece) { decoded += piece; });
  }
  decoder.Finish();
  EXPECT_EQ(decoded, text);
  EXPECT_EQ(Decode(Encode("")), "");
  EXPECT_EQ(Decode(Encode("one ") + Encode("two")), "one two");
}

TEST(ZstdTest, WhatIsCutOrNoZstandardIsABadRequest) {
  const std::string encoded = Encode(Text(10'000));
  EXPECT_EQ(CodeOf([&] { Decode(encoded.substr(0, encoded.size() - 1)); }), "bad-request");
  EXPECT_EQ(CodeOf([&] { Decode(encoded + "rest"); }), "bad-request");
  EXPECT_EQ(CodeOf([&] { Decode("plain"); }), "bad-request");
  EXPECT_EQ(CodeOf([&] { Decode(""); }), "bad-request");
  std::string damaged = encoded;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 0x55);
  EXPECT_EQ(CodeOf([&] { Decode(damaged); }), "bad-request");
}

TEST(ZstdTest, BombsAreTooLargeBeforeTheyAreDecoded) {
  const std::string bomb = Encode(std::string(50'000'000, '\0'));
  EXPECT_LT(bomb.size(), 10'000U);
  DecodeLimits limits;
  limits.max_bytes = 1'000'000;
  std::size_t decoded = 0;
  ZstdDecoder decoder(limits);
  EXPECT_EQ(
      CodeOf([&] { decoder.Feed(bomb, [&](std::string_view piece) { decoded += piece.size(); }); }),
      "too-large");
  EXPECT_LE(decoded, limits.max_bytes);
  limits = {};
  limits.ratio_free_bytes = 1'000'000;
  EXPECT_EQ(CodeOf([&] { Decode(bomb, limits); }), "too-large");
  std::string map;  // what is real compresses much less
  for (unsigned value = 1; map.size() < 3'000'000; value = value * 1664525 + 1013904223) {
    map += std::string(1 + value % 97, static_cast<char>(value >> 24));
  }
  EXPECT_EQ(Decode(Encode(map), limits), map);
}

TEST(ZstdTest, AWindowThatWantsTooMuchMemoryIsTooLarge) {
  // A frame header that asks for a window of 2 GiB (RFC 8878 §3.1.1.1.2), and an empty block.
  const std::string frame("\x28\xb5\x2f\xfd\x00\xa8\x01\x00\x00", 9);
  EXPECT_EQ(CodeOf([&] { Decode(frame); }), "too-large");
}

TEST(ZstdTest, AFlushLetsAllBeDecodedSoFar) {
  ZstdEncoder encoder;
  std::string encoded;
  const Sink give = [&](std::string_view piece) { encoded += piece; };
  encoder.Feed("so far", give);
  encoder.Flush(give);
  std::string decoded;
  ZstdDecoder decoder({});
  decoder.Feed(encoded, [&](std::string_view piece) { decoded += piece; });
  EXPECT_EQ(decoded, "so far");
  EXPECT_EQ(CodeOf([&] { decoder.Finish(); }), "bad-request");
}

TEST(ContentCodingTest, ZstdIsSentOnlyWhenItIsNamed) {
  for (const char* yes : {"zstd", "gzip, zstd", "ZSTD;q=0.1", "br;q=1, zstd ; q=1.0"}) {
    EXPECT_TRUE(AcceptsZstd(yes)) << yes;
  }
  for (const char* no : {"", "gzip", "*", "zstd;q=0", "zstd; q=0.000", "zstdx"}) {
    EXPECT_FALSE(AcceptsZstd(no)) << no;
  }
}

TEST(ContentCodingTest, TypesThatAreCompressedAlreadyAreSentAsTheyAre) {
  for (const char* yes : {"text/turtle", "application/json; charset=utf-8", "application/rdf+xml",
                          "application/sparql-results+json", "image/x-portable-graymap",
                          "application/x-tar", "application/ply"}) {
    EXPECT_TRUE(IsCompressible(yes)) << yes;
  }
  for (const char* no : {"image/png", "image/jpeg", "application/octet-stream", "", "nonsense",
                         "text/event-stream"}) {
    EXPECT_FALSE(IsCompressible(no)) << no;
  }
}

TEST(ContentCodingTest, BothFormsOfATagAreOneForConditions) {
  EXPECT_EQ(ZstdTag("\"a\""), "\"a-zstd\"");
  EXPECT_EQ(IdentityTag("\"a-zstd\""), "\"a\"");
  EXPECT_EQ(IdentityTag("\"a\""), "\"a\"");
  Request request;
  request.headers.Set("If-Match", "\"3-abc-zstd\"");
  EXPECT_EQ(WriteCondition(request, "\"3-abc\""), "\"3-abc\"");
}

// A service with one text, one file and one that takes a body.
class CodedServiceTest : public ::testing::Test {
 protected:
  CodedServiceTest() {
    std::ofstream(file_, std::ios::binary) << Text(3'000'000);
    Router router;
    const auto add = [&router](const char* path, decltype(Response::body) body) {
      router.Add({"GET",
                  path,
                  path,
                  [body](const Request&) {
                    Response response;
                    response.headers.Set("Content-Type", "text/plain");
                    response.headers.Set("ETag", "\"t\"");
                    response.headers.Set("Accept-Ranges", "bytes");
                    response.body = body;
                    return response;
                  },
                  {},
                  0});
    };
    add("/text", Text(5000));
    add("/short", std::string("short"));
    add("/file", FileBody{file_, 0, std::filesystem::file_size(file_)});
    router.Add({"PUT",
                "/body",
                "putBody",
                [](const Request& request) {
                  Response response;
                  response.body = ReadWholeBody(request, 100'000);
                  return response;
                },
                {"text/plain"},
                50'000});
    service_ = std::make_unique<Service>(std::move(router));
  }
  ~CodedServiceTest() override { std::filesystem::remove(file_); }

  Response Get(const std::string& path, std::vector<std::pair<std::string, std::string>> headers,
               const std::string& method = "GET") {
    Request request;
    request.method = method;
    request.path = path;
    request.headers.Set("Host", "localhost");
    for (auto& [name, value] : headers) request.headers.Set(name, value);
    return service_->Answer(request);
  }
  Response Put(const std::string& body, const std::string& coding) {
    Request request;
    request.method = "PUT";
    request.path = "/body";
    request.headers.Set("Host", "localhost");
    request.headers.Set("Content-Type", "text/plain");
    request.headers.Set("Content-Encoding", coding);
    request.has_body = true;
    request.content_length = body.size();
    request.read_body = [body](const Sink& sink) { sink(body); };
    return service_->Answer(request);
  }

  std::filesystem::path file_ =
      std::filesystem::path(::testing::TempDir()) / "lares_coded_service.txt";
  std::unique_ptr<Service> service_;
};

TEST_F(CodedServiceTest, AnAnswerIsCompressedForThoseWhoAcceptIt) {
  const Response coded = Get("/text", {{"Accept-Encoding", "gzip, zstd"}});
  EXPECT_EQ(coded.headers.Get("Content-Encoding"), "zstd");
  EXPECT_EQ(coded.headers.Get("Vary"), "Accept-Encoding");
  EXPECT_EQ(coded.headers.Get("ETag"), "\"t-zstd\"");
  EXPECT_FALSE(coded.headers.Has("Accept-Ranges"));
  EXPECT_EQ(Decode(ProduceWhole(coded)), Text(5000));

  const Response plain = Get("/text", {});
  EXPECT_FALSE(plain.headers.Has("Content-Encoding"));
  EXPECT_EQ(plain.headers.Get("Vary"), "Accept-Encoding");
  EXPECT_EQ(plain.headers.Get("ETag"), "\"t\"");
  EXPECT_FALSE(Get("/short", {{"Accept-Encoding", "zstd"}}).headers.Has("Content-Encoding"));
}

TEST_F(CodedServiceTest, ALongFileIsCompressedWhileItIsSent) {
  const Response coded = Get("/file", {{"Accept-Encoding", "zstd"}});
  ASSERT_TRUE(std::holds_alternative<OpenBody>(coded.body));
  const std::string bytes = ProduceWhole(coded);
  EXPECT_LT(bytes.size(), 2'000'000U);
  EXPECT_EQ(Decode(bytes), Text(3'000'000));
}

TEST_F(CodedServiceTest, ARangeIsOfTheBytesAsTheyAre) {
  const Response part = Get("/text", {{"Accept-Encoding", "zstd"}, {"Range", "bytes=5-9"}});
  EXPECT_EQ(part.status, 206);
  EXPECT_FALSE(part.headers.Has("Content-Encoding"));
  EXPECT_EQ(ProduceWhole(part), Text(5000).substr(5, 5));
  EXPECT_EQ(part.headers.Get("ETag"), "\"t\"");
  // What was received compressed is not continued with bytes as they are.
  EXPECT_EQ(Get("/text", {{"Range", "bytes=5-9"}, {"If-Range", "\"t-zstd\""}}).status, 200);
}

TEST_F(CodedServiceTest, EitherFormThatIsKnownIs304WithItsOwnTag) {
  for (const char* accepted : {"zstd", ""}) {
    for (const char* tag : {"\"t\"", "\"t-zstd\""}) {
      const Response known = Get("/text", {{"Accept-Encoding", accepted}, {"If-None-Match", tag}});
      EXPECT_EQ(known.status, 304);
      EXPECT_EQ(known.headers.Get("ETag"), tag);
      EXPECT_FALSE(known.headers.Has("Content-Encoding"));
    }
  }
  EXPECT_EQ(Get("/text", {{"If-None-Match", "\"other-zstd\""}}).status, 200);
}

TEST_F(CodedServiceTest, BodiesAreDecodedWithinTheRoutesLimit) {
  EXPECT_EQ(ProduceWhole(Put(Encode(Text(40'000)), "zstd")), Text(40'000));
  EXPECT_EQ(ProduceWhole(Put("as it is", "identity")), "as it is");
  const Response bomb = Put(Encode(std::string(10'000'000, 'x')), "zstd");
  EXPECT_EQ(bomb.status, 413);
  EXPECT_EQ(Put("no zstd", "zstd").status, 400);
  const Response other = Put("x", "gzip");
  EXPECT_EQ(other.status, 415);
  EXPECT_EQ(other.headers.Get("Accept-Encoding"), "zstd");
}

}  // namespace
}  // namespace lares::http
