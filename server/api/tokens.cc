// Tokens: made, listed, revoked. An admin's business.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "server/access/access.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/json_body.h"
#include "server/http/problem.h"
#include "server/http/url.h"

namespace lares::api {
namespace {

constexpr const char* kCollection = "/v1/tokens";
constexpr std::uint64_t kMaxBody = 256 * 1024;

Json TimeOrNull(const std::optional<Time>& time) {
  return time ? Json(ToRfc3339(*time)) : Json(nullptr);
}

Json ToJson(const store::TokenRecord& token, Time now) {
  return {{"id", token.id},
          {"label", token.label},
          {"role", token.role},
          {"environments", token.environments},
          {"state", access::StateOf(token, now)},
          {"created", ToRfc3339(token.created)},
          {"expires", TimeOrNull(token.expires)},
          {"revoked", TimeOrNull(token.revoked)},
          {"max_requests_per_minute", token.max_requests_per_minute},
          {"max_bytes_per_day", token.max_bytes_per_day},
          {"max_queries", token.max_queries}};
}

template <typename Value>
void Read(const Json& json, const char* name, const char* type, Value& value) {
  const auto found = json.find(name);
  if (found == json.end() || found->is_null()) return;
  try {
    value = found->get<Value>();
  } catch (const Json::exception&) {
    throw Error(Code::kInvalid, std::string("'") + name + "' must be " + type);
  }
}

void ReadLimit(const Json& json, const char* name, std::int64_t& limit) {
  const auto found = json.find(name);
  if (found == json.end() || found->is_null()) return;
  if (!found->is_number_integer() || *found < 0) {
    throw Error(Code::kInvalid, std::string("'") + name + "' must be a whole number, 0 for none");
  }
  limit = found->get<std::int64_t>();
}

access::NewToken ReadToken(const http::Request& request) {
  const Json json = ReadJsonObject(http::ReadWholeBody(request, kMaxBody),
                                   {"label", "role", "environments", "expires",
                                    "max_requests_per_minute", "max_bytes_per_day", "max_queries"});
  access::NewToken token;
  std::string role, expires;
  Read(json, "label", "a text", token.label);
  Read(json, "role", "a text", role);
  Read(json, "environments", "an array of texts", token.environments);
  Read(json, "expires", "a text", expires);
  const auto parsed = access::ParseRole(role);
  if (!parsed) throw Error(Code::kInvalid, "'role' must be reader, robot, editor or admin");
  token.role = *parsed;
  if (!expires.empty()) {
    token.expires = FromRfc3339(expires);
    if (!token.expires) {
      throw Error(Code::kInvalid, "'expires' must be a time such as 2030-01-31T12:00:00Z");
    }
  }
  ReadLimit(json, "max_requests_per_minute", token.limits.max_requests_per_minute);
  ReadLimit(json, "max_bytes_per_day", token.limits.max_bytes_per_day);
  ReadLimit(json, "max_queries", token.limits.max_queries);
  return token;
}

http::Response Create(const http::Request& request, Context& context) {
  const access::CreatedToken created = context.access->Create(ReadToken(request));
  Json json = ToJson(created.record, context.access->now());
  json["token"] = created.token;
  http::Response response = JsonAnswer(json, 201);
  response.headers.Set("Location", std::string(kCollection) + "/" + created.record.id);
  response.headers.Set("Cache-Control", "no-store");
  return response;
}

http::Response List(const http::Request& request, Context& context) {
  const std::vector<store::TokenRecord> tokens = context.store.ListTokens();
  const Time now = context.access->now();
  return Page(
      request, tokens.size(), [&](std::size_t i) { return tokens[i].id; },
      [&](std::size_t i) { return ToJson(tokens[i], now); });
}

http::Response Get(const http::Request& request, Context& context) {
  const std::string& id = request.Param("id");
  if (const auto token = context.store.FindToken(id)) {
    return JsonAnswer(ToJson(*token, context.access->now()));
  }
  throw Error(Code::kNotFound, "there is no token '" + id.substr(0, 200) + "'");
}

http::Response Revoke(const http::Request& request, Context& context) {
  return JsonAnswer(ToJson(context.access->Revoke(request.Param("id")), context.access->now()));
}

}  // namespace

void AddTokenRoutes(http::Router& router, Context& context) {
  const auto add = [&](const char* method, const std::string& path, const char* operation,
                       auto handler) {
    const bool has_body = std::string_view(method) == "POST";
    router.Add(
        {method, path, operation,
         [&context, handler](const http::Request& request) { return handler(request, context); },
         has_body ? std::vector<std::string>{"application/json"} : std::vector<std::string>{},
         has_body ? kMaxBody : 0});
  };
  const std::string one = std::string(kCollection) + "/{id}";
  add("POST", kCollection, "createToken", Create);
  add("GET", kCollection, "listTokens", List);
  add("GET", one, "getToken", Get);
  add("DELETE", one, "revokeToken", Revoke);
}

}  // namespace lares::api
