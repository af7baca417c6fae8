#include "server/access/token.h"

#include <gtest/gtest.h>

#include <set>

#include "base/hash.h"

namespace lares::access {
namespace {

TEST(TokenTest, IsWrittenAndReadBack) {
  const TokenText token = NewTokenText();
  const std::string text = Format(token);
  EXPECT_EQ(text.substr(0, 6), "lares_");
  const auto read = ParseToken(text);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->id, token.id);
  EXPECT_EQ(read->secret, token.secret);
  EXPECT_GE(token.secret.size() * 5, 160u);  // bits
}

TEST(TokenTest, IsNeverTheSameTwiceAndUsesEveryDigit) {
  std::set<std::string> ids, secrets;
  std::set<char> digits;
  for (int i = 0; i < 1000; ++i) {
    const TokenText token = NewTokenText();
    ids.insert(token.id);
    secrets.insert(token.secret);
    digits.insert(token.secret.begin(), token.secret.end());
  }
  EXPECT_EQ(ids.size(), 1000u);
  EXPECT_EQ(secrets.size(), 1000u);
  EXPECT_EQ(digits.size(), 32u);
}

TEST(TokenTest, WhatIsWrittenOtherwiseIsNone) {
  const std::string text = Format(NewTokenText());
  EXPECT_FALSE(ParseToken(""));
  EXPECT_FALSE(ParseToken(text + "a"));
  EXPECT_FALSE(ParseToken(text.substr(1)));
  EXPECT_FALSE(ParseToken("LARES" + text.substr(5)));
  for (std::size_t i = 6; i < text.size(); ++i) {
    std::string odd = text;
    odd[i] = '1';  // no digit of base 32
    EXPECT_FALSE(ParseToken(odd)) << i;
  }
}

TEST(TokenTest, OnlyTheSecretItselfMatches) {
  const std::string secret = NewTokenText().secret;
  const std::string hash = Sha256Hex(secret);
  EXPECT_TRUE(SecretMatches(secret, hash));
  for (std::size_t i = 0; i < hash.size(); ++i) {
    std::string other = hash;
    other[i] = other[i] == '0' ? '1' : '0';
    EXPECT_FALSE(SecretMatches(secret, other)) << i;
  }
  EXPECT_FALSE(SecretMatches(secret, ""));
  EXPECT_FALSE(SecretMatches(secret, hash.substr(0, 63)));
  EXPECT_FALSE(SecretMatches("", hash));
}

}  // namespace
}  // namespace lares::access
