#include "mapping/environment/magic.h"

#include <gtest/gtest.h>

namespace lares::environment {
namespace {

TEST(MagicTest, CommonFilesAreRecognised) {
  EXPECT_EQ(LooksLike("\x89PNG\r\n\x1A\n"), "a PNG image");
  EXPECT_EQ(LooksLike("\xFF\xD8\xFF\xE0"), "a JPEG image");
  EXPECT_EQ(LooksLike("\x1F\x8B\x08"), "a gzip archive");
  EXPECT_EQ(LooksLike("PK\x03\x04"), "a zip archive");
  EXPECT_EQ(LooksLike("%PDF-1.7"), "a PDF document");
  EXPECT_EQ(LooksLike("\x7F"
                      "ELF"),
            "an ELF program");
  EXPECT_EQ(LooksLike("\xEF\xBB\xBF <?xml version=\"1.0\"?>"), "an XML document");
  EXPECT_EQ(LooksLike("<!DOCTYPE html>"), "an HTML page");
}

TEST(MagicTest, PlainTextAndShortFilesAreNothing) {
  EXPECT_EQ(LooksLike("hello"), "");
  EXPECT_EQ(LooksLike(""), "");
  EXPECT_EQ(LooksLike("\x89P"), "");
}

TEST(MagicTest, RefusalSaysWhatItIsNotAndWhatItIs) {
  EXPECT_EQ(NotA("a PLY file", "%PDF-1.7"), "not a PLY file: it looks like a PDF document");
  EXPECT_EQ(NotA("a PLY file", "hello"), "not a PLY file");
  EXPECT_EQ(NotA("a PLY file", ""), "not a PLY file: it is empty");
}

}  // namespace
}  // namespace lares::environment
