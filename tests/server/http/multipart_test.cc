#include "server/http/multipart.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "base/error.h"
#include "server/http/problem.h"

namespace lares::http {
namespace {

struct Part {
  PartHeader header;
  std::string data;
  bool ended = false;
};

// What the form holds when it arrives in pieces of `step` bytes.
std::vector<Part> Parse(const std::string& body, std::size_t step, const std::string& boundary,
                        const MultipartLimits& limits = {}) {
  std::vector<Part> parts;
  MultipartParser parser(boundary,
                         {[&](const PartHeader& header) {
                            parts.push_back({header, "", false});
                          },
                          [&](std::string_view piece) { parts.back().data += piece; },
                          [&] { parts.back().ended = true; }},
                         limits);
  for (std::size_t at = 0; at < body.size(); at += step) parser.Feed(body.substr(at, step));
  parser.Finish();
  return parts;
}

std::string OnePart(const std::string& disposition, const std::string& data = "x") {
  return "--B\r\nContent-Disposition: " + disposition + "\r\n\r\n" + data + "\r\n--B--\r\n";
}

TEST(MultipartTest, FindsPartsWhereverThePiecesAreCut) {
  const std::string data = "line\r\n--not the boundary\r\n--\r\n-\r--B";
  const std::string body =
      "preamble\r\n--BOUND\r\nContent-Disposition: form-data; name=\"a\"\r\n\r\n" + data +
      "\r\n--BOUND  \r\ncontent-type: text/turtle\r\n"
      "CONTENT-DISPOSITION: form-data; name=b; filename=\"m.ttl\"\r\n\r\n"
      "\r\n--BOUND--\r\nepilogue";
  for (std::size_t step = 1; step <= body.size(); ++step) {
    const auto parts = Parse(body, step, "BOUND");
    ASSERT_EQ(parts.size(), 2u) << step;
    EXPECT_EQ(parts[0].header.name, "a");
    EXPECT_EQ(parts[0].data, data) << step;
    EXPECT_EQ(parts[1].header.name, "b");
    EXPECT_EQ(parts[1].header.file_name, "m.ttl");
    EXPECT_EQ(parts[1].header.content_type, "text/turtle");
    EXPECT_EQ(parts[1].data, "");
    EXPECT_TRUE(parts[1].ended);
  }
}

TEST(MultipartTest, HoldsOnlyABoundarysLengthOfData) {
  std::size_t longest_wait = 0;
  std::size_t given = 0;
  std::size_t fed = 0;
  MultipartParser parser("B", {[](const PartHeader&) {},
                               [&](std::string_view piece) { given += piece.size(); }, [] {}});
  parser.Feed("--B\r\nContent-Disposition: form-data; name=a\r\n\r\n");
  for (int i = 0; i < 1000; ++i) {
    parser.Feed(std::string(1000, '\r'));
    fed += 1000;
    longest_wait = std::max(longest_wait, fed - given);
  }
  EXPECT_LE(longest_wait, 8u);
}

TEST(MultipartTest, ReadsQuotedNames) {
  const auto parts =
      Parse(OnePart(R"(form-data; name="a \"b\"; c"; filename="x;y\".ttl")"), 7, "B");
  EXPECT_EQ(parts[0].header.name, "a \"b\"; c");
  EXPECT_EQ(parts[0].header.file_name, "x;y\".ttl");
}

TEST(MultipartTest, HostileFileNamesLoseTheirFolders) {
  EXPECT_EQ(SafeFileName("../../etc/passwd"), "passwd");
  EXPECT_EQ(SafeFileName("C:\\Users\\me\\map.bt"), "map.bt");
  EXPECT_EQ(SafeFileName("/"), "");
  EXPECT_EQ(SafeFileName(".."), "");
  EXPECT_EQ(SafeFileName("a/."), "");
  EXPECT_EQ(SafeFileName(std::string("a\0b\n\x7f.ttl", 9)), "ab.ttl");
  EXPECT_EQ(SafeFileName(std::string(300, 'a')).size(), 255u);
  EXPECT_EQ(SafeFileName("Küche.owl"), "Küche.owl");
  EXPECT_EQ(SafeFileName("\xff\xff"), "");
}

TEST(MultipartTest, RefusesABodyThatNeverCloses) {
  const std::string body = OnePart("form-data; name=a");
  for (std::size_t length = 0; length < body.size() - 4; ++length) {
    EXPECT_THROW(Parse(body.substr(0, length), 5, "B"), ProblemError) << length;
  }
}

TEST(MultipartTest, RefusesMalformedParts) {
  for (const char* disposition :
       {"attachment; name=a", "form-data", "form-data; name", "form-data; name=\"a",
        "form-data; name=\"\"", "", "form-data name=a"}) {
    EXPECT_THROW(Parse(OnePart(disposition), 100, "B"), ProblemError) << disposition;
  }
  EXPECT_THROW(Parse("--B\r\nnocolon\r\n\r\nx\r\n--B--", 100, "B"), ProblemError);
  EXPECT_THROW(Parse("--B\r\n\r\nx\r\n--B--", 100, "B"), ProblemError);
  EXPECT_THROW(Parse("--Bx\r\n\r\nx\r\n--B--", 100, "B"), ProblemError);
}

TEST(MultipartTest, RefusesWhatGoesBeyondItsLimits) {
  EXPECT_THROW(Parse(std::string(100'000, 'x'), 4096, "B"), ProblemError);
  EXPECT_THROW(Parse("--B" + std::string(10'000, ' '), 4096, "B"), ProblemError);
  EXPECT_THROW(Parse("--B\r\nX: " + std::string(10'000, 'x'), 4096, "B"), Error);
  std::string many;
  for (int i = 0; i < 5; ++i) many += "--B\r\nContent-Disposition: form-data; name=a\r\n\r\n\r\n";
  EXPECT_EQ(Parse(many + "--B--", 10, "B").size(), 5u);
  EXPECT_THROW(Parse(many + "--B--", 10, "B", {4, 8192}), Error);
}

TEST(MultipartTest, ReadsTheBoundaryFromTheContentType) {
  EXPECT_EQ(MultipartBoundary("multipart/form-data; boundary=\"a b\""), "a b");
  EXPECT_EQ(MultipartBoundary("Multipart/Form-Data; charset=x; Boundary=abc"), "abc");
  EXPECT_THROW(MultipartBoundary("multipart/form-data"), ProblemError);
  EXPECT_THROW(MultipartBoundary("multipart/form-data; boundary=" + std::string(71, 'x')),
               ProblemError);
  EXPECT_THROW(MultipartBoundary("text/plain; boundary=a"), Error);
}

TEST(MultipartTest, WhatTheHandlerThrowsPassesThrough) {
  Request request;
  request.headers.Set("Content-Type", "multipart/form-data; boundary=B");
  request.read_body = [](const Sink& sink) { sink(OnePart("form-data; name=a")); };
  const MultipartHandler full{[](const PartHeader&) {},
                              [](std::string_view) { throw Error(Code::kUnavailable, "full"); },
                              [] {}};
  EXPECT_THROW(ReadMultipart(request, full), Error);
}

TEST(MultipartTest, ReadsWhatItsOwnWriterWrites) {
  const std::string path = ::testing::TempDir() + "lares_form_" + std::to_string(::getpid());
  std::ofstream(path) << "file content\r\n--";
  const EncodedForm form =
      EncodeForm({{"label", "Küche \"1\"", {}, "", ""},
                  {"grid \"x\"", "", path, "m\"a\\p.tar", "application/x-tar"}});
  std::string body;
  for (const FormPiece& piece : form.pieces) {
    if (piece.file.empty()) {
      body += piece.text;
    } else {
      std::ifstream file(piece.file);
      body.append(std::istreambuf_iterator<char>(file), {});
    }
  }
  std::remove(path.c_str());
  EXPECT_EQ(body.size(), form.length);
  const auto parts = Parse(body, 11, MultipartBoundary(form.content_type));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].header.name, "label");
  EXPECT_EQ(parts[0].data, "Küche \"1\"");
  EXPECT_EQ(parts[1].header.name, "grid \"x\"");
  EXPECT_EQ(parts[1].header.content_type, "application/x-tar");
  EXPECT_EQ(parts[1].data, "file content\r\n--");
  EXPECT_THROW(EncodeForm({{"a", "", "/no/such/file", "f", ""}}), Error);
}

}  // namespace
}  // namespace lares::http
