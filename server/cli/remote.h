// The server as the commands see it: requests, and problem documents as errors.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/error.h"
#include "server/http/client.h"

namespace lares::cli {

using Json = nlohmann::ordered_json;

// A problem document of the server.
class RemoteError : public Error {
 public:
  RemoteError(std::string problem_code, const std::string& message, std::string document);
  RemoteError(std::string problem_code, const std::string& message, Place place,
              std::string document);
  const std::string& problem_code() const { return problem_code_; }
  const std::string& document() const { return document_; }  // as received

 private:
  std::string problem_code_;
  std::string document_;
};

struct ServerAddress {
  std::string url = "http://127.0.0.1:8080";
  std::string token_file;  // "": the token is in LARES_TOKEN, or there is none
  std::string ca_file;     // "": the system's
};

// Not thread-safe.
class Remote {
 public:
  // Throws kForbidden for a token that would go to another machine without TLS.
  explicit Remote(const ServerAddress& server);

  // The answer of a 2xx, or of a 304 to a request with If-None-Match; else throws RemoteError, or
  // as http::Client::Send does.
  http::ClientResponse Send(const http::ClientRequest& request,
                            const http::Transfer& transfer = {});
  http::ClientResponse Send(const http::ClientRequest& request, const http::Transfer& transfer,
                            const http::Answered& answered);
  // With `body` as JSON, none when it is null; the answer's JSON, null when it has no body.
  Json SendJson(const std::string& method, const std::string& path, const Json& body);
  Json GetJson(const std::string& path, const std::multimap<std::string, std::string>& query = {});
  // Every page of a list as one: {"items": […], "count": n}.
  Json GetList(const std::string& path, std::multimap<std::string, std::string> query = {});

  const std::string& url() const { return client_.base_url(); }

 private:
  http::Client client_;
};

// "/v1/recipes" + "/" + the segments, percent-encoded.
std::string PathOf(const std::string& collection, const std::vector<std::string>& segments);

}  // namespace lares::cli
