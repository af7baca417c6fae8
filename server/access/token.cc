#include "server/access/token.h"

#include <sys/random.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "base/hash.h"

namespace lares::access {
namespace {

constexpr std::string_view kPrefix = "lares_";
constexpr std::string_view kDigits = "abcdefghijklmnopqrstuvwxyz234567";  // RFC 4648, base 32
constexpr std::size_t kIdLength = 10;
constexpr std::size_t kSecretLength = 40;

std::string RandomText(std::size_t length) {
  std::string text(length, '\0');
  std::size_t filled = 0;
  while (filled < length) {
    const ssize_t got = ::getrandom(text.data() + filled, length - filled, 0);
    if (got < 0 && errno != EINTR) {
      throw Error(Code::kIo, std::string("the system gives no randomness: ") + strerror(errno));
    }
    if (got > 0) filled += static_cast<std::size_t>(got);
  }
  for (char& c : text) c = kDigits[static_cast<unsigned char>(c) & 31];
  return text;
}

bool IsDigits(std::string_view text) {
  return text.find_first_not_of(kDigits) == std::string_view::npos;
}

}  // namespace

TokenText NewTokenText() { return {RandomText(kIdLength), RandomText(kSecretLength)}; }

std::string Format(const TokenText& token) {
  return std::string(kPrefix) + token.id + "_" + token.secret;
}

std::optional<TokenText> ParseToken(std::string_view text) {
  if (text.size() != kPrefix.size() + kIdLength + 1 + kSecretLength || !text.starts_with(kPrefix)) {
    return std::nullopt;
  }
  text.remove_prefix(kPrefix.size());
  const std::string_view id = text.substr(0, kIdLength);
  const std::string_view secret = text.substr(kIdLength + 1);
  if (text[kIdLength] != '_' || !IsDigits(id) || !IsDigits(secret)) return std::nullopt;
  return TokenText{std::string(id), std::string(secret)};
}

bool SecretMatches(std::string_view secret, std::string_view sha256_hex) {
  const std::string hashed = Sha256Hex(secret);
  unsigned char differs = hashed.size() == sha256_hex.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(hashed.size(), sha256_hex.size()); ++i) {
    differs = static_cast<unsigned char>(differs | (hashed[i] ^ sha256_hex[i]));
  }
  return differs == 0;
}

}  // namespace lares::access
