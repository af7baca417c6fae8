// The gatekeeper of the interface: who asks, whether they may, and what they wrote.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/time.h"
#include "server/access/grant.h"
#include "server/access/table.h"
#include "server/access/use.h"
#include "server/http/service.h"
#include "server/store/store.h"

namespace lares::access {

struct NewToken {
  std::string label;
  Role role = Role::kReader;
  std::vector<std::string> environments;  // as in Grant
  std::optional<Time> expires;
  Limits limits;
};

struct CreatedToken {
  store::TokenRecord record;
  std::string token;  // its text: shown once, kept nowhere
};

// Throws kInvalid: no label, kPublic, an admin with environments, a time that is over, a negative
// limit; and kConflict when the store's first token would be no admin, as nobody could make
// another.
CreatedToken CreateToken(store::Store& store, const NewToken& wanted, Time now);

// "active", "expired", "revoked"
std::string_view StateOf(const store::TokenRecord& token, Time now);

// While the store has no token everybody may do everything; from the first one on a token is
// needed, also after all have expired. What a token may do is looked up in the store at most every
// two seconds, so that another server's revocation holds here that soon; this one's at once.
// All members are thread-safe.
class Access final : public http::Gatekeeper {
 public:
  using Clock = std::function<Time()>;
  // `store` must outlive it.
  Access(store::Store& store, AccessTable table, Clock now = Now);

  // 401 "token-…" with WWW-Authenticate; 403 "role-too-low"; 404, as for one that is not there, for
  // an environment that the token does not reach; 429 "too-many-…" with Retry-After.
  void Admit(const http::Route& route, http::Request& request) override;
  void Begin(const http::Route& route, http::Request& request) override;
  void Answered(const http::Route& route, const http::Request& request,
                const http::Response& response) noexcept override;

  CreatedToken Create(const NewToken& wanted);
  // Throws kNotFound, and kConflict for the last admin's.
  store::TokenRecord Revoke(const std::string& id);
  // For what lasts longer than a request: false once the token was revoked or has expired.
  bool IsStillGood(const Grant& grant);

  const AccessTable& table() const { return table_; }
  Time now() const { return now_(); }

 private:
  using Instant = std::chrono::steady_clock::time_point;
  struct Known {
    store::TokenRecord record;
    Instant looked_up;
  };

  bool IsOpen();
  std::shared_ptr<const Grant> Identify(const http::Request& request);
  store::TokenRecord Find(const std::string& text);
  std::shared_ptr<Use> UseOf(const std::string& token);
  void CheckBytes(const Grant& grant, std::uint64_t arriving, std::uint64_t stored) const;
  std::uint64_t StoredToday(const Grant& grant) const;

  store::Store& store_;
  const AccessTable table_;
  const Clock now_;
  std::mutex changes_;  // one change of tokens at a time
  std::mutex mutex_;    // of what follows
  bool has_tokens_ = false;
  Instant looked_for_tokens_{};
  std::map<std::string, Known> known_;  // by the SHA-256 of the whole text
  std::map<std::string, Known> by_id_;  // for IsStillGood
  std::map<std::string, std::shared_ptr<Use>> use_;
};

}  // namespace lares::access
