// Tokens as text: lares_<id>_<secret>. The text is shown once; what is kept of the secret is its
// SHA-256.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lares::access {

struct TokenText {
  std::string id;      // 10 characters: no secret
  std::string secret;  // 40 characters of base 32: 200 random bits of the system's source
};

// Throws kIo when the system has no randomness.
TokenText NewTokenText();
std::string Format(const TokenText& token);
// Nothing for what is not written as a token.
std::optional<TokenText> ParseToken(std::string_view text);

// Takes as long whether they agree early, late or not at all.
bool SecretMatches(std::string_view secret, std::string_view sha256_hex);

}  // namespace lares::access
