#include "server/access/audit_record.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "server/access/grant.h"

namespace lares::access {
namespace {

constexpr std::size_t kMaxTarget = 500;
constexpr std::string_view kOfEnvironment = "environment.";  // ids of what is kept aside

std::string EnvironmentOf(const Rule& rule, const http::Request& request) {
  const auto id = request.params.find("id");
  if (id == request.params.end()) return "";
  if (rule.environments == Rule::Environments::kPath) return id->second;
  const bool is_aside = request.path.starts_with("/v1/quarantine/");
  return is_aside && id->second.starts_with(kOfEnvironment)
             ? id->second.substr(kOfEnvironment.size())
             : "";
}

// What clients write into addresses is not theirs to choose here.
std::string Printable(std::string_view text) {
  std::string printable(text.substr(0, kMaxTarget));
  std::replace_if(
      printable.begin(), printable.end(), [](char c) { return c < 0x20 || c > 0x7e; }, '?');
  return printable;
}

int Number(std::string_view digits) {
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return error == std::errc() && end == digits.data() + digits.size() ? number : 0;
}

// "3-ab12…" of documents, "kitchen-3" of environments.
int VersionOf(std::string_view etag, bool is_environment) {
  if (etag.size() < 2) return 0;
  etag = etag.substr(1, etag.size() - 2);
  const std::size_t dash = is_environment ? etag.rfind('-') : etag.find('-');
  if (dash == std::string_view::npos) return 0;
  return Number(is_environment ? etag.substr(dash + 1) : etag.substr(0, dash));
}

std::string ResultOf(const http::Response& response) {
  if (response.status < 300) return "done";
  const auto* body = std::get_if<std::string>(&response.body);
  if (body == nullptr) return std::to_string(response.status);
  const auto problem = nlohmann::json::parse(*body, nullptr, false);
  if (!problem.is_object()) return std::to_string(response.status);
  return problem.value("code", std::to_string(response.status));
}

}  // namespace

store::AuditRecord RecordOf(const http::Route& route, const Rule& rule,
                            const http::Request& request, const http::Response& response,
                            std::uint64_t bytes, Time now) {
  store::AuditRecord record;
  record.time = now;
  record.token = request.grant->token;
  record.label = request.grant->label;
  record.operation = route.operation;
  const std::string_view location = response.headers.Get("Location");
  record.target = Printable(location.empty() ? std::string_view(request.path) : location);
  record.environment = Printable(EnvironmentOf(rule, request));
  const bool made = response.status < 300;
  const bool is_environment = record.target.starts_with("/v1/environments/");
  record.version = made ? VersionOf(response.headers.Get("ETag"), is_environment) : 0;
  record.status = response.status;
  record.result = ResultOf(response);
  record.request_id = request.id;
  record.bytes = bytes;
  return record;
}

}  // namespace lares::access
