#include "server/api/scope.h"

#include "base/error.h"
#include "server/access/grant.h"
#include "server/http/problem.h"
#include "server/knowledge/quarantine.h"

namespace lares::api {

bool Reaches(const http::Request& request, std::string_view environment) {
  return request.grant == nullptr || access::Reaches(*request.grant, environment);
}

void CheckReach(const http::Request& request, const std::string& environment) {
  if (environment.empty() || Reaches(request, environment)) return;
  throw Error(Code::kNotFound, "there is no environment '" + environment.substr(0, 200) + "'");
}

bool MaySee(const http::Request& request, store::DocumentKind kind, std::string_view id) {
  if (kind != store::DocumentKind::kQuarantined) return true;
  const std::string of_environment = server::QuarantineIdOfEnvironment("");
  return !id.starts_with(of_environment) || Reaches(request, id.substr(of_environment.size()));
}

void CheckIsEditor(const http::Request& request) {
  if (request.grant == nullptr || request.grant->role >= access::Role::kEditor) return;
  throw http::ProblemError("role-too-low", "?editor= takes the role editor; the token has " +
                                               std::string(access::ToString(request.grant->role)));
}

}  // namespace lares::api
