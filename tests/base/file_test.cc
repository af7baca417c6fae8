#include "base/file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iterator>

#include "base/error.h"

namespace lares {
namespace {

namespace fs = std::filesystem;

class FileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "lares-file-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(FileTest, WrittenFileReadsBackAndLeavesNothingBeside) {
  const std::string bytes("a\0b\n", 4);
  WriteFileAtomically(folder_ / "x", bytes);
  EXPECT_EQ(ReadFile(folder_ / "x"), bytes);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(FileTest, OverwritingReplacesTheWhole) {
  WriteFileAtomically(folder_ / "x", "long content");
  WriteFileAtomically(folder_ / "x", "s");
  EXPECT_EQ(ReadFile(folder_ / "x"), "s");
}

TEST_F(FileTest, MissingFileIsNotFound) {
  try {
    ReadFile(folder_ / "none");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kNotFound);
    EXPECT_NE(error.FullMessage().find("none"), std::string::npos);
  }
}

TEST_F(FileTest, LimitStopsReading) {
  WriteFileAtomically(folder_ / "x", std::string(1000, 'a'));
  EXPECT_EQ(ReadFile(folder_ / "x", 1000).size(), 1000U);
  EXPECT_THROW(ReadFile(folder_ / "x", 999), Error);
}

TEST_F(FileTest, FailedWriteLeavesTheOldContent) {
  EXPECT_THROW(WriteFileAtomically(folder_ / "no-such-folder" / "x", "a"), Error);
  EXPECT_THROW(ReadFile(folder_), Error);
}

}  // namespace
}  // namespace lares
