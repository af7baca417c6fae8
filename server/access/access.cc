#include "server/access/access.h"

#include <algorithm>

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "server/access/audit_record.h"
#include "server/access/token.h"
#include "server/http/log.h"
#include "server/http/problem.h"

namespace lares::access {
namespace {

using http::ProblemError;

constexpr std::chrono::seconds kBelieved{2};  // what the store said
constexpr std::size_t kMaxKnown = 4096;

ProblemError Unauthorized(const char* code, const std::string& why) {
  const bool is_missing = std::string_view(code) == "token-missing";
  ProblemError error(code, why);
  error.WithHeader("WWW-Authenticate", is_missing
                                           ? "Bearer realm=\"lares\""
                                           : "Bearer realm=\"lares\", error=\"invalid_token\"");
  return error;
}

ProblemError TooMuch(const char* code, const std::string& why, std::chrono::seconds wait) {
  ProblemError error(code, why);
  error.WithHeader("Retry-After", std::to_string(wait.count()));
  return error;
}

// The text after "Bearer".
std::string BearerToken(const http::Request& request) {
  const auto& fields = request.headers.all();
  const auto count = std::count_if(fields.begin(), fields.end(), [](const auto& field) {
    return ToLower(field.first) == "authorization";
  });
  if (count > 1) throw ProblemError("bad-request", "a request has at most one Authorization");
  const std::string_view value = Trim(request.headers.Get("Authorization"));
  const std::size_t space = value.find(' ');
  if (ToLower(value.substr(0, space)) != "bearer" || space == std::string_view::npos) {
    auto error = Unauthorized("token-missing", "this server asks for a token");
    error.WithHint(
        "send it as 'Authorization: Bearer …'; the command line takes LARES_TOKEN or "
        "--token-file");
    throw error;
  }
  return std::string(Trim(value.substr(space)));
}

std::shared_ptr<const Grant> GrantOf(const store::TokenRecord& token) {
  auto grant = std::make_shared<Grant>();
  grant->token = token.id;
  grant->label = token.label;
  grant->role = ParseRole(token.role).value_or(Role::kPublic);
  grant->environments = token.environments;
  grant->limits = {token.max_requests_per_minute, token.max_bytes_per_day, token.max_queries};
  grant->expires = token.expires;
  return grant;
}

Time MidnightBefore(Time now) { return std::chrono::floor<std::chrono::days>(now); }

// As for one that is not there.
Error NoEnvironment(const std::string& id) {
  return Error(Code::kNotFound, "there is no environment '" + id.substr(0, 200) + "'");
}

void CheckReach(const Grant& grant, const Rule& rule, const http::Request& request) {
  if (rule.environments == Rule::Environments::kPath && !Reaches(grant, request.Param("id"))) {
    throw NoEnvironment(request.Param("id"));
  }
  const auto [begin, end] = request.query.equal_range("environment");
  for (auto named = begin; named != end; ++named) {
    if (!named->second.empty() && !Reaches(grant, named->second)) {
      throw NoEnvironment(named->second);
    }
  }
}

}  // namespace

Access::Access(store::Store& store, AccessTable table, Clock now)
    : store_(store), table_(std::move(table)), now_(std::move(now)) {}

bool Access::IsOpen() {
  const Instant now = std::chrono::steady_clock::now();
  {
    const std::lock_guard lock(mutex_);
    if (has_tokens_) return false;
    if (looked_for_tokens_ != Instant{} && now - looked_for_tokens_ < kBelieved) return true;
  }
  const bool has_tokens = store_.HasTokens();
  const std::lock_guard lock(mutex_);
  has_tokens_ = has_tokens_ || has_tokens;
  looked_for_tokens_ = now;
  return !has_tokens_;
}

// The record of the token with this text, whatever its state. Throws "token-invalid".
store::TokenRecord Access::Find(const std::string& text) {
  const std::string key = Sha256Hex(text);
  const Instant now = std::chrono::steady_clock::now();
  {
    const std::lock_guard lock(mutex_);
    const auto found = known_.find(key);
    if (found != known_.end() && now - found->second.looked_up < kBelieved) {
      return found->second.record;
    }
  }
  const auto parsed = ParseToken(text);
  const auto record = parsed ? store_.FindToken(parsed->id) : std::nullopt;
  // Compared in any case, so that an id which exists takes as long as one that does not.
  const bool matches = SecretMatches(parsed ? parsed->secret : text,
                                     record ? record->secret_sha256 : std::string(64, '0'));
  if (!record || !matches) throw Unauthorized("token-invalid", "that token is not known here");
  const std::lock_guard lock(mutex_);
  if (known_.size() >= kMaxKnown) known_.clear();
  known_[key] = {*record, now};
  return *record;
}

std::shared_ptr<const Grant> Access::Identify(const http::Request& request) {
  static const auto kOpen =
      std::make_shared<const Grant>(Grant{"", "", Role::kAdmin, {}, {0, 0, 0}, {}});
  if (IsOpen()) return kOpen;
  const store::TokenRecord token = Find(BearerToken(request));
  const std::string_view state = StateOf(token, now_());
  if (state == "revoked") throw Unauthorized("token-revoked", "the token was revoked");
  if (state == "expired") {
    throw Unauthorized("token-expired", "the token has expired on " + ToRfc3339(*token.expires));
  }
  return GrantOf(token);
}

std::shared_ptr<Use> Access::UseOf(const std::string& token) {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<Use>& use = use_[token];
  if (use == nullptr) use = std::make_shared<Use>();
  return use;
}

void Access::Admit(const http::Route& route, http::Request& request) {
  const Rule rule = table_.Of(route.operation, route.method);
  if (rule.role == Role::kPublic) return;
  request.grant = Identify(request);
  const Grant& grant = *request.grant;
  const std::shared_ptr<Use> use = UseOf(grant.token);
  if (const auto wait = use->requests.Take(grant.limits.max_requests_per_minute,
                                           std::chrono::steady_clock::now())) {
    request.grant.reset();  // nothing is written down of a flood
    throw TooMuch("too-many-requests",
                  "the token may ask " + std::to_string(grant.limits.max_requests_per_minute) +
                      " times a minute",
                  *wait);
  }
  const auto held = std::make_shared<Held>(use);
  request.place = held;
  if (grant.role < rule.role) {
    throw ProblemError("role-too-low", "this takes the role " + std::string(ToString(rule.role)) +
                                           "; the token has " + std::string(ToString(grant.role)));
  }
  CheckReach(grant, rule, request);
  if (rule.kind == Rule::Kind::kQuery && !held->BeginQuery(grant.limits.max_queries)) {
    throw TooMuch("too-many-queries",
                  "the token runs " + std::to_string(grant.limits.max_queries) +
                      " queries already, as many as it may at once",
                  std::chrono::seconds(1));
  }
  if (rule.kind == Rule::Kind::kWrite && request.has_body && grant.limits.max_bytes_per_day > 0) {
    CheckBytes(grant, held->Arriving(request.content_length.value_or(0)), StoredToday(grant));
  }
}

std::uint64_t Access::StoredToday(const Grant& grant) const {
  return store_.BytesStoredSince(grant.token, MidnightBefore(now_()));
}

void Access::CheckBytes(const Grant& grant, std::uint64_t arriving, std::uint64_t stored) const {
  if (stored + arriving <= static_cast<std::uint64_t>(grant.limits.max_bytes_per_day)) return;
  const Time now = now_();
  const auto wait =
      std::chrono::ceil<std::chrono::seconds>(MidnightBefore(now) + std::chrono::days(1) - now);
  throw TooMuch("too-many-bytes",
                "the token may store " + std::to_string(grant.limits.max_bytes_per_day) +
                    " bytes a day and has stored " + std::to_string(stored) + " today",
                wait);
}

void Access::Begin(const http::Route& route, http::Request& request) {
  if (request.grant == nullptr || request.place == nullptr || !request.read_body ||
      table_.Of(route.operation, route.method).kind != Rule::Kind::kWrite) {
    return;
  }
  // Counts what arrives; a body of unknown length ends where the limit does.
  const bool is_limited = request.grant->limits.max_bytes_per_day > 0 && !request.content_length;
  const std::uint64_t stored = is_limited && request.has_body ? StoredToday(*request.grant) : 0;
  const auto held = std::static_pointer_cast<Held>(request.place);
  request.read_body = [this, held, stored, is_limited, grant = request.grant,
                       read = std::move(request.read_body)](const http::Sink& sink) {
    read([&](std::string_view piece) {
      held->Read(piece.size());
      if (is_limited) CheckBytes(*grant, held->Arriving(held->bytes_read()), stored);
      sink(piece);
    });
  };
}

void Access::Answered(const http::Route& route, const http::Request& request,
                      const http::Response& response) noexcept {
  try {
    const Rule rule = table_.Of(route.operation, route.method);
    const auto held = std::static_pointer_cast<Held>(request.place);
    // An answer that is made while it is sent holds its place until then.
    if (held && std::holds_alternative<std::string>(response.body)) held->EndQuery();
    if (rule.kind != Rule::Kind::kWrite) return;
    store_.AddAudit(
        RecordOf(route, rule, request, response, held ? held->bytes_read() : 0, now_()));
    // The request itself lives on until its connection is done with it.
    if (held) held->Arrived();
  } catch (const std::exception& error) {
    http::Log(http::LogLevel::kError, "a write is missing in the audit log",
              {{"request_id", request.id}, {"error", std::string(error.what())}});
  }
}

CreatedToken Access::Create(const NewToken& wanted) {
  const std::lock_guard one(changes_);
  CreatedToken created = CreateToken(store_, wanted, now_());
  const std::lock_guard lock(mutex_);
  has_tokens_ = true;
  return created;
}

store::TokenRecord Access::Revoke(const std::string& id) {
  const std::lock_guard one(changes_);
  const Time now = now_();
  bool is_admin = false;
  int admins = 0;
  for (const store::TokenRecord& token : store_.ListTokens()) {
    if (token.role != ToString(Role::kAdmin) || StateOf(token, now) != "active") continue;
    ++admins;
    is_admin = is_admin || token.id == id;
  }
  if (is_admin && admins == 1) {
    throw Error(Code::kConflict, "'" + id + "' is the last token of an admin")
        .WithHint("make another one first");
  }
  store::TokenRecord revoked = store_.RevokeToken(id, now);
  const std::lock_guard lock(mutex_);
  known_.clear();
  by_id_.clear();
  return revoked;
}

bool Access::IsStillGood(const Grant& grant) {
  if (grant.token.empty()) return IsOpen();
  const Instant now = std::chrono::steady_clock::now();
  {
    const std::lock_guard lock(mutex_);
    const auto found = by_id_.find(grant.token);
    if (found != by_id_.end() && now - found->second.looked_up < kBelieved) {
      return StateOf(found->second.record, now_()) == "active";
    }
  }
  const auto record = store_.FindToken(grant.token);
  if (!record) return false;
  const std::lock_guard lock(mutex_);
  by_id_[grant.token] = {*record, now};
  return StateOf(*record, now_()) == "active";
}

}  // namespace lares::access
