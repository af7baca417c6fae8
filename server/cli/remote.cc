#include "server/cli/remote.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "server/cli/print.h"
#include "server/http/origin_check.h"
#include "server/http/url.h"

namespace lares::cli {
namespace {

constexpr std::uintmax_t kMaxTokenFile = 4096;

std::string Text(const Json& document, const char* name) {
  const auto found = document.find(name);
  return found != document.end() && found->is_string() ? found->get<std::string>() : "";
}

int Number(const Json& place, const char* name) {
  const auto found = place.find(name);
  return found != place.end() && found->is_number_integer() ? found->get<int>() : 0;
}

std::string TokenOf(const ServerAddress& server) {
  if (!server.token_file.empty()) {
    return std::string(Trim(ReadLocalFile(server.token_file, kMaxTokenFile)));
  }
  const char* token = std::getenv("LARES_TOKEN");
  return token == nullptr ? "" : std::string(Trim(token));
}

http::ClientOptions ClientOptionsOf(const ServerAddress& server) {
  http::ClientOptions options;
  options.ca_file = server.ca_file;
  options.token = TokenOf(server);
  if (options.token.find_first_of(" \r\n\t") != std::string::npos) {
    throw Error(Code::kInvalid, "the token has spaces or line breaks in it");
  }
  const http::BaseUrl address = http::ParseBaseUrl(server.url);
  if (!options.token.empty() && !address.tls && !http::IsLoopbackHost(address.host)) {
    throw Error(Code::kForbidden,
                "a token is not sent to " + server.url + ": everybody on the way could read it")
        .WithHint("give the server's https address");
  }
  return options;
}

[[noreturn]] void ThrowProblem(const http::ClientResponse& response, const std::string& url) {
  const Json document = Json::parse(response.body, nullptr, false);
  if (!document.is_object() || !document.contains("code")) {
    throw Error(Code::kIo, "what answers at " + url + " with status " +
                               std::to_string(response.status) + " is no Lares server");
  }
  RemoteError error(Text(document, "code"), Text(document, "detail"), response.body);
  if (const auto place = document.find("place"); place != document.end() && place->is_object()) {
    error =
        RemoteError(Text(document, "code"), Text(document, "detail"),
                    Place{Text(*place, "source"), Number(*place, "line"), Number(*place, "column")},
                    response.body);
  }
  error.WithHint(Text(document, "hint"));
  std::vector<std::string> candidates;
  if (const auto found = document.find("candidates");
      found != document.end() && found->is_array()) {
    for (const Json& candidate : *found) {
      if (candidate.is_string()) candidates.push_back(candidate);
    }
  }
  error.WithCandidates(std::move(candidates));
  throw error;
}

}  // namespace

RemoteError::RemoteError(std::string problem_code, const std::string& message, std::string document)
    : Error(Code::kInvalid, message),
      problem_code_(std::move(problem_code)),
      document_(std::move(document)) {}

RemoteError::RemoteError(std::string problem_code, const std::string& message, Place place,
                         std::string document)
    : Error(Code::kInvalid, message, std::move(place)),
      problem_code_(std::move(problem_code)),
      document_(std::move(document)) {}

Remote::Remote(const ServerAddress& server) : client_(server.url, ClientOptionsOf(server)) {}

http::ClientResponse Remote::Send(const http::ClientRequest& request,
                                  const http::Transfer& transfer) {
  return Send(request, transfer, nullptr);
}

http::ClientResponse Remote::Send(const http::ClientRequest& request,
                                  const http::Transfer& transfer, const http::Answered& answered) {
  http::ClientResponse response = client_.Send(request, transfer, answered);
  if (request.method == "HEAD" && response.status == 404) {  // comes without a document
    throw RemoteError("not-found", "there is no '" + request.path + "' at " + url(), "{}\n");
  }
  const bool unchanged = response.status == 304 && request.headers.Has("If-None-Match");
  if (!unchanged && (response.status < 200 || response.status >= 300))
    ThrowProblem(response, url());
  return response;
}

Json Remote::SendJson(const std::string& method, const std::string& path, const Json& body) {
  http::ClientRequest request;
  request.method = method;
  request.path = path;
  if (!body.is_null()) {
    request.headers.Set("Content-Type", "application/json");
    request.body = body.dump();
  }
  const std::string answer = Send(request).body;
  return answer.empty() ? Json() : Json::parse(answer);
}

Json Remote::GetJson(const std::string& path,
                     const std::multimap<std::string, std::string>& query) {
  const http::ClientResponse response = Send({"GET", path, query, {}, {}});
  Json json = Json::parse(response.body, nullptr, false);
  if (json.is_discarded()) {
    throw Error(Code::kIo, "what answers at " + url() + " sent no JSON: it is no Lares server");
  }
  return json;
}

Json Remote::GetList(const std::string& path, std::multimap<std::string, std::string> query) {
  query.emplace("limit", "1000");
  Json all{{"items", Json::array()}, {"count", 0}};
  while (true) {
    const Json page = GetJson(path, query);
    for (const Json& item : page.at("items")) all["items"].push_back(item);
    all["count"] = page.value("count", all["items"].size());
    if (!page.at("next").is_string()) return all;
    query.erase("after");
    query.emplace("after", page.at("next").get<std::string>());
  }
}

std::string PathOf(const std::string& collection, const std::vector<std::string>& segments) {
  std::string path = collection;
  for (const std::string& segment : segments) path += "/" + http::PercentEncode(segment);
  return path;
}

}  // namespace lares::cli
