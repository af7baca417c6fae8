// One text as a token, as a pattern of environments, and as an environment that one might reach.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"
#include "server/access/grant.h"
#include "server/access/token.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lares::access;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto token = ParseToken(text);
  if (token && Format(*token) != text) std::abort();
  if (SecretMatches(text, text)) std::abort();  // no secret is its own hash
  Grant grant;
  grant.environments = {"flat-*", "lab"};
  const bool reaches = Reaches(grant, text);
  if (reaches != (text == "lab" || text.starts_with("flat-"))) std::abort();
  try {
    CheckPattern(text);
  } catch (const lares::Error&) {
    return 0;
  }
  if (text.empty() || text.substr(0, text.size() - 1).find('*') != std::string_view::npos) {
    std::abort();
  }
  return 0;
}
