#include "base/hash.h"

#include <gtest/gtest.h>

namespace lares {
namespace {

// FIPS 180-2, appendix B.1.
constexpr char kAbc[] = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(HashTest, MatchesThePublishedVector) { EXPECT_EQ(Sha256Hex("abc"), kAbc); }

TEST(HashTest, PiecesGiveTheHashOfTheWhole) {
  Sha256 hash;
  hash.Update("a");
  hash.Update("");
  hash.Update("bc");
  EXPECT_EQ(hash.FinishHex(), kAbc);
}

TEST(HashTest, OnlyLowerCaseHexOf64DigitsIsAHash) {
  EXPECT_TRUE(IsSha256Hex(kAbc));
  EXPECT_FALSE(IsSha256Hex("../../etc/passwd"));
  EXPECT_FALSE(IsSha256Hex(std::string(kAbc).substr(1)));
  EXPECT_FALSE(IsSha256Hex(std::string("B") + (kAbc + 1)));
}

}  // namespace
}  // namespace lares
