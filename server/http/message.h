// Requests and responses as values, without any HTTP library in sight.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace lares::http {

// Field names compare without case; order and repetition are kept.
class Headers {
 public:
  // The first value of that name; null when there is none.
  const std::string* Find(std::string_view name) const;
  // The same, "" when there is none.
  std::string_view Get(std::string_view name) const;
  bool Has(std::string_view name) const { return Find(name) != nullptr; }
  // All values of that name joined by ", ", as RFC 9110 §5.3 reads lists.
  std::string GetList(std::string_view name) const;
  void Set(std::string_view name, std::string value);  // replaces every value of that name
  void Add(std::string_view name, std::string value);
  void Remove(std::string_view name);
  const std::vector<std::pair<std::string, std::string>>& all() const { return fields_; }

 private:
  std::vector<std::pair<std::string, std::string>> fields_;
};

using Sink = std::function<void(std::string_view)>;

struct Request {
  std::string method;
  std::string path;                           // as sent: still percent-encoded, without query
  std::map<std::string, std::string> params;  // what the route's {names} stood for, decoded
  std::multimap<std::string, std::string> query;
  Headers headers;
  std::string remote;  // address of the peer
  std::string id;      // X-Request-Id, ours when the client sent none

  // Hands the body to the sink in pieces, once. Throws kInvalid (cut short), kTooLarge, kTimeout
  // and whatever the sink throws. Empty for a request without a body.
  std::function<void(const Sink&)> read_body;
  std::optional<std::uint64_t> content_length;  // as announced; nothing for chunked bodies
  bool has_body = false;

  // The parameter's value; nothing when absent.
  std::optional<std::string> Query(const std::string& name) const;
  const std::string& Param(const std::string& name) const;  // kInternal when the route has none
};

// A part of a file, read while it is sent.
struct FileBody {
  std::filesystem::path path;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

// Made while it is sent: `produce` gives exactly `length` bytes to the sink, which throws when the
// client has gone.
struct StreamBody {
  std::uint64_t length = 0;
  std::function<void(const Sink&)> produce;
};

struct Response {
  int status = 200;
  Headers headers;
  std::variant<std::string, FileBody, StreamBody> body;
};

// The whole body in memory. Throws kTooLarge beyond `max_bytes`.
std::string ReadWholeBody(const Request& request, std::uint64_t max_bytes);

std::uint64_t BodyLength(const Response& response);

}  // namespace lares::http
