#include "mapping/environment/ply_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/lares_data.h"
#include "tests/mapping/layer_bytes.h"

namespace lares::environment {
namespace {

using testing::Check;
using ::testing::ElementsAre;
using testing::FloatBytes;
using ::testing::HasSubstr;
using testing::Refusal;

std::string Refused(const std::string& bytes) { return Refusal(CheckCloud, bytes); }

std::string Header(const std::string& format, const std::string& count = "2") {
  return "ply\nformat " + format + " 1.0\ncomment made for a test\nelement vertex " + count +
         "\nproperty uchar red\nproperty float x\nproperty float y\nproperty float z\n";
}

std::string WithFaces(const std::string& header) {
  return header + "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string BinaryNumber(float number, bool big_endian) {
  std::string bytes = FloatBytes(number);
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string Binary(bool big_endian, float last_z = 3) {
  std::string bytes = WithFaces(Header(big_endian ? "binary_big_endian" : "binary_little_endian"));
  for (const float sign : {1.0F, -1.0F}) {
    bytes += '\xFF';
    bytes += BinaryNumber(sign * 1, big_endian) + BinaryNumber(sign * 2, big_endian);
    bytes += BinaryNumber(sign > 0 ? last_z : -3, big_endian);
  }
  return bytes + std::string("\x02\0\0\0\0\0\0\0\x01", 9);
}

TEST(PlyFormatTest, AsciiPointsAreBounded) {
  const LayerFacts facts =
      Check(CheckCloud, WithFaces(Header("ascii")) + "255 1 2 3\n255 -1 -2 -3\n2 0 1\n");
  EXPECT_EQ(facts.facts.at("points"), "2");
  EXPECT_EQ(facts.facts.at("faces"), "1");
  EXPECT_EQ(facts.facts.at("format"), "ascii");
  EXPECT_THAT(*facts.bounds_m, ElementsAre(-1, -2, -3, 1, 2, 3));
}

TEST(PlyFormatTest, BothByteOrdersGiveTheSameBounds) {
  EXPECT_THAT(*Check(CheckCloud, Binary(false)).bounds_m, ElementsAre(-1, -2, -3, 1, 2, 3));
  EXPECT_THAT(*Check(CheckCloud, Binary(true)).bounds_m, ElementsAre(-1, -2, -3, 1, 2, 3));
}

TEST(PlyFormatTest, WindowsLineEndsAreAccepted) {
  EXPECT_EQ(Refused("ply\r\nformat ascii 1.0\r\nelement vertex 1\r\nproperty double x\r\n"
                    "property double y\r\nproperty double z\r\nend_header\r\n1 2 3\r\n"),
            "");
}

TEST(PlyFormatTest, RecordedCloudsAreAccepted) {
  LARES_REQUIRE_DATA(folder, "objects");
  for (const char* name :
       {"lion/drawing_model.ply", "van/face_000.ply", "bed1/face_000.ply", "cookies-box/box.ply"}) {
    ByteReader reader = ByteReader::OfFile(folder / name, name);
    const LayerFacts facts = CheckCloud(reader);
    EXPECT_TRUE(facts.bounds_m) << name;
  }
}

TEST(PlyFormatTest, CutOffFilesNameByteAndElement) {
  const std::string whole = Binary(false);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THAT(Refused(whole.substr(0, size)), HasSubstr("file: byte ")) << size;
  }
  EXPECT_THAT(Refused(whole.substr(0, whole.size() - 1)), HasSubstr("face 1 of 1: the file ends"));
  EXPECT_THAT(Refused(WithFaces(Header("ascii")) + "255 1 2 3\n255 -1"),
              HasSubstr("vertex 2 of 2: the file ends"));
}

TEST(PlyFormatTest, CountsThatLieAreRefusedQuicklyWithoutMemory) {
  EXPECT_THAT(Refused(Header("ascii", "18446744073709551615") + "end_header\n255 1 2 3\n"),
              HasSubstr("the file ends"));
  EXPECT_THAT(Refused(Header("ascii", "99999999999999999999") + "end_header\n"),
              HasSubstr("no count of elements"));
  EXPECT_THAT(Refused(Header("ascii", "-1") + "end_header\n"), HasSubstr("no count of elements"));
  EXPECT_EQ(Refused(Header("ascii", "0") + "element nothing 18446744073709551615\nend_header\n"),
            "");
}

TEST(PlyFormatTest, CoordinatesMustBeFiniteNumbers) {
  EXPECT_THAT(Refused(Binary(true, std::numeric_limits<float>::quiet_NaN())),
              HasSubstr("vertex 1 of 2: a coordinate is not a finite number"));
  EXPECT_THAT(Refused(Header("ascii", "1") + "end_header\n255 1 inf 3\n"),
              HasSubstr("vertex 1 of 1: a coordinate is not"));
  EXPECT_THAT(Refused(Header("ascii", "1") + "end_header\n255 1 two 3\n"),
              HasSubstr("'two' is not a number"));
}

TEST(PlyFormatTest, DataAfterTheLastElementAreRefused) {
  EXPECT_THAT(Refused(Binary(false) + "x"), HasSubstr("data follow"));
  EXPECT_THAT(Refused(Header("ascii", "1") + "end_header\n255 1 2 3 4\n"),
              HasSubstr("data follow"));
  EXPECT_EQ(Refused(Header("ascii", "1") + "end_header\n255 1 2 3\n\n \n"), "");
}

TEST(PlyFormatTest, MalformedHeadersAreRefused) {
  EXPECT_THAT(Refused("ply\nformat ascii 2.0\n"), HasSubstr("format line"));
  EXPECT_THAT(Refused("ply\nformat text 1.0\n"), HasSubstr("'text' is not known"));
  EXPECT_THAT(Refused("ply\nproperty float x\n"), HasSubstr("before the first element"));
  EXPECT_THAT(Refused("ply\nelement vertex 1\nproperty quaternion x\n"), HasSubstr("no type"));
  EXPECT_THAT(Refused("ply\nelement vertex 1\nproperty list float int x\n"),
              HasSubstr("whole numbers"));
  EXPECT_THAT(Refused("ply\nelement vertex 0\nend_header\n"), HasSubstr("no format line"));
  EXPECT_THAT(Refused("ply\nformat ascii 1.0\nend_header\n"), HasSubstr("no vertex element"));
  EXPECT_THAT(Refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"),
              HasSubstr("no property y"));
  EXPECT_THAT(Refused("ply\nformat ascii 1.0\nnonsense\n"), HasSubstr("'nonsense' is no word"));
  std::string endless = "ply\n";
  while (endless.size() < 100'000) endless += "comment " + std::string(1000, 'x') + "\n";
  EXPECT_THAT(Refused(endless), HasSubstr("longer than 64 KiB"));
}

TEST(PlyFormatTest, ListsCannotHaveNegativeCounts) {
  EXPECT_THAT(
      Refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty list char int n\n"
              "property float x\nproperty float y\nproperty float z\nend_header\n-1 1 2 3\n"),
      HasSubstr("cannot have -1 entries"));
}

TEST(PlyFormatTest, OtherFilesAreRefusedByWhatTheyLookLike) {
  EXPECT_THAT(Refused("# .PCD v0.7\n"), HasSubstr("it looks like a PCD point cloud"));
}

}  // namespace
}  // namespace lares::environment
