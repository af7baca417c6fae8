#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "server/access/access.h"
#include "server/access/token.h"

namespace lares::access {
namespace {

constexpr std::size_t kMaxLabel = 200;  // bytes
constexpr std::size_t kMaxPatterns = 1000;

void Check(const NewToken& wanted, Time now) {
  const auto refuse = [](const std::string& why) { throw Error(Code::kInvalid, why); };
  if (Trim(wanted.label).empty()) refuse("a token needs a label that says whose it is");
  if (wanted.label.size() > kMaxLabel) refuse("the label is longer than 200 bytes");
  if (wanted.role == Role::kPublic) refuse("a token has the role reader, robot, editor or admin");
  if (wanted.environments.size() > kMaxPatterns) refuse("a token names at most 1000 environments");
  for (const std::string& pattern : wanted.environments) CheckPattern(pattern);
  if (wanted.role == Role::kAdmin && !wanted.environments.empty()) {
    refuse("an admin reaches every environment: leave them out, or choose another role");
  }
  if (wanted.expires && *wanted.expires <= now) refuse("the token would have expired already");
  const Limits& limits = wanted.limits;
  if (limits.max_requests_per_minute < 0 || limits.max_bytes_per_day < 0 ||
      limits.max_queries < 0) {
    refuse("a limit is 0 (none) or above");
  }
}

}  // namespace

CreatedToken CreateToken(store::Store& store, const NewToken& wanted, Time now) {
  Check(wanted, now);
  if (wanted.role != Role::kAdmin && !store.HasTokens()) {
    throw Error(Code::kConflict, "the first token must be an admin's: nobody could make another")
        .WithHint("make one with the role admin first");
  }
  const TokenText text = NewTokenText();
  CreatedToken created;
  created.record.id = text.id;
  created.record.label = std::string(Trim(wanted.label));
  created.record.role = ToString(wanted.role);
  created.record.environments = wanted.environments;
  created.record.secret_sha256 = Sha256Hex(text.secret);
  created.record.created = now;
  created.record.expires = wanted.expires;
  created.record.max_requests_per_minute = wanted.limits.max_requests_per_minute;
  created.record.max_bytes_per_day = wanted.limits.max_bytes_per_day;
  created.record.max_queries = wanted.limits.max_queries;
  store.AddToken(created.record);
  created.token = Format(text);
  return created;
}

std::string_view StateOf(const store::TokenRecord& token, Time now) {
  if (token.revoked) return "revoked";
  return token.expires && *token.expires <= now ? "expired" : "active";
}

}  // namespace lares::access
