// The HTTP client: what the command line and tests speak to a server with.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>

#include "base/error.h"
#include "server/http/message.h"
#include "server/http/multipart.h"

namespace lares::http {

struct ClientRequest {
  std::string method = "GET";
  std::string path;  // percent-encoded, without query
  std::multimap<std::string, std::string> query;
  Headers headers;
  // Nothing, a text (its Content-Type among the headers), or a form.
  std::variant<std::monostate, std::string, EncodedForm> body;
};

struct ClientResponse {
  int status = 0;
  Headers headers;
  std::string body;  // "" when it went to a sink
};

// Bytes done and bytes in all (0: not known).
using Progress = std::function<void(std::uint64_t, std::uint64_t)>;

struct Transfer {
  // Gets the body of a 2xx answer instead of ClientResponse::body; what it throws passes through.
  Sink sink;
  Progress uploaded;
  Progress downloaded;
};

// Gets status and headers once, before the body; what it throws passes through.
using Answered = std::function<void(const ClientResponse&)>;

struct ClientOptions {
  std::chrono::seconds answer_time{300};
  std::string token;  // "" none; sent as Authorization: Bearer
  // PEM of those who may vouch for an https server; "": the system's.
  std::filesystem::path ca_file;
};

// The connection broke, or there was none: asking again may help.
class ConnectionError : public Error {
 public:
  using Error::Error;
};

// No server at that address: its own type, as the remedy is another than for any other fault.
class NoServerError : public ConnectionError {
 public:
  using ConnectionError::ConnectionError;
};

// One connection, kept open. Not thread-safe.
class Client {
 public:
  // Throws kInvalid for a malformed address, or a CA file that cannot be read.
  explicit Client(const std::string& base_url, const ClientOptions& options = {});
  ~Client();

  // Any status is an answer. Throws NoServerError, ConnectionError (kIo), kTimeout, kTooLarge
  // (an answer of more than 256 MiB without a sink).
  ClientResponse Send(const ClientRequest& request, const Transfer& transfer = {});
  ClientResponse Send(const ClientRequest& request, const Transfer& transfer,
                      const Answered& answered);

  const std::string& base_url() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lares::http
