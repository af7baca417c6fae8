#include "mapping/environment/byte_reader.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "mapping/environment/facts.h"

namespace lares::environment {
namespace {

TEST(ByteReaderTest, OffsetCountsAcrossBuffers) {
  const std::string bytes(200'000, 'x');
  ByteReader reader = ByteReader::OfBytes(bytes, "f");
  EXPECT_EQ(reader.PeekFront(8), "xxxxxxxx");
  EXPECT_EQ(reader.offset(), 0U);
  std::string into(150'000, '\0');
  ASSERT_TRUE(reader.Read(into.data(), into.size()));
  EXPECT_EQ(reader.offset(), 150'000U);
  EXPECT_FALSE(reader.Read(into.data(), 50'001));
  EXPECT_EQ(reader.Get(), -1);
}

TEST(ByteReaderTest, LinesEndWithOrWithoutCarriageReturnOrAtTheEnd) {
  ByteReader reader = ByteReader::OfBytes("a\r\n\nb", "f");
  EXPECT_EQ(reader.ReadLine(10), "a");
  EXPECT_EQ(reader.ReadLine(10), "");
  EXPECT_EQ(reader.ReadLine(10), "b");
  EXPECT_EQ(reader.ReadLine(10), std::nullopt);
}

TEST(ByteReaderTest, MissingFileIsNotFound) {
  try {
    ByteReader::OfFile("/nonexistent/layer", "f");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kNotFound);
  }
}

TEST(FactsTest, ForeignTextIsShortAndPrintable) {
  EXPECT_EQ(Excerpt("a\x01\xC3"), "a??");
  EXPECT_EQ(Excerpt(std::string(100, 'y')), std::string(40, 'y') + "…");
}

}  // namespace
}  // namespace lares::environment
