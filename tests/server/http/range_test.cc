#include "server/http/range.h"

#include <gtest/gtest.h>

namespace lares::http {
namespace {

using Kind = ByteRange::Kind;

TEST(RangeTest, ReadsTheThreeForms) {
  const ByteRange middle = ParseRange("bytes=2-4", 10);
  EXPECT_EQ(middle.kind, Kind::kPart);
  EXPECT_EQ(middle.offset, 2u);
  EXPECT_EQ(middle.length, 3u);
  const ByteRange tail = ParseRange("bytes=7-", 10);
  EXPECT_EQ(tail.offset, 7u);
  EXPECT_EQ(tail.length, 3u);
  const ByteRange suffix = ParseRange("bytes=-4", 10);
  EXPECT_EQ(suffix.offset, 6u);
  EXPECT_EQ(suffix.length, 4u);
}

TEST(RangeTest, CutsWhatReachesBeyondTheEnd) {
  EXPECT_EQ(ParseRange("bytes=5-99", 10).length, 5u);
  EXPECT_EQ(ParseRange("bytes=-99", 10).length, 10u);
  EXPECT_EQ(ParseRange("bytes=5-99999999999999999999999999", 10).length, 5u);
  EXPECT_EQ(ParseRange("bytes=-99999999999999999999999999", 10).length, 10u);
}

TEST(RangeTest, CallsWhatLiesOutsideUnsatisfiable) {
  for (const char* header :
       {"bytes=10-", "bytes=10-20", "bytes=-0", "bytes=99999999999999999999999999-"}) {
    EXPECT_EQ(ParseRange(header, 10).kind, Kind::kUnsatisfiable) << header;
  }
  EXPECT_EQ(ParseRange("bytes=0-", 0).kind, Kind::kUnsatisfiable);
  EXPECT_EQ(ParseRange("bytes=-1", 0).kind, Kind::kUnsatisfiable);
}

TEST(RangeTest, TakesTheWholeForWhatItCannotRead) {
  for (const char* header :
       {"", "bytes", "bytes=", "bytes=-", "bytes=a-b", "bytes=1", "bytes=5-2", "lines=1-2",
        "bytes=0-1,3-4", "bytes=--1", "bytes=0x1-2", "bytes=1-2-3", "bytes=+1-2"}) {
    EXPECT_EQ(ParseRange(header, 10).kind, Kind::kWhole) << header;
  }
}

TEST(RangeTest, ReadsTheUnitInAnyCaseAndBlanksAround) {
  EXPECT_EQ(ParseRange("  Bytes= 0 - 0 ", 10).length, 1u);
}

TEST(RangeTest, WritesContentRange) {
  EXPECT_EQ(FormatContentRange(ParseRange("bytes=0-0", 10), 10), "bytes 0-0/10");
  EXPECT_EQ(FormatContentRange(ParseRange("bytes=10-", 10), 10), "bytes */10");
}

}  // namespace
}  // namespace lares::http
