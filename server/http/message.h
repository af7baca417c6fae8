// Requests and responses as values, without any HTTP library in sight.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace lares::access {
struct Grant;
}

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

  // A token that is stopped when the client goes away (or ends its side of the connection) while
  // the request is answered, and when the server gives up waiting at its end. The connection is
  // watched from the first call on. Empty where there is no connection.
  std::function<std::stop_token()> watch_client;
  // The same; a token that never stops where there is no connection.
  std::stop_token WatchClient() const { return watch_client ? watch_client() : std::stop_token(); }

  // Who asks, as the service's gatekeeper found out; null without one.
  std::shared_ptr<const access::Grant> grant;
  // Held until the request is answered: its place among those that may run at once.
  std::shared_ptr<void> place;

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

// What an OpenBody is written to. Used by one thread.
class OpenSink {
 public:
  virtual ~OpenSink() = default;
  // Buffers up to 32 KiB; beyond it, or 100 ms after the beginning or what was sent last, sends
  // and waits for a client that reads slowly (not longer than ConnectionLimits allow). Throws kIo
  // once the client has gone.
  virtual void Write(std::string_view bytes) = 0;
  // Sends what is buffered: before a pause, so that the client has it.
  virtual void Flush() = 0;
  // Stopped when the client goes away; for what runs long between two writes.
  virtual std::stop_token gone() = 0;
};

// Made while it is sent, of a length that nobody knows beforehand: chunked in HTTP/1.1, ended by
// the connection's end in 1.0. What is over before anything was sent becomes an ordinary answer
// with a length, and what `produce` throws before that a problem document of its own; thrown later
// it cuts the answer off, so that the client sees that it is not whole. Counts as a long transfer:
// it holds a thread, and is refused with 503 when too many are.
struct OpenBody {
  std::function<void(OpenSink&)> produce;
};

class EventChannel;

// A text/event-stream without an end. Once the head is sent, `subscribe` gets the channel, and the
// thread goes on to other requests; it must not wait. Their number is limited: 503 beyond.
struct EventsBody {
  std::function<void(std::shared_ptr<EventChannel>)> subscribe;
};

struct Response {
  int status = 200;
  Headers headers;
  std::variant<std::string, FileBody, StreamBody, OpenBody, EventsBody> body;
};

// The whole body in memory. Throws kTooLarge beyond `max_bytes`.
std::string ReadWholeBody(const Request& request, std::uint64_t max_bytes);

// 0 for a length that is not known.
std::uint64_t BodyLength(const Response& response);

// What an OpenBody produces, or the other bodies' text, in memory: for tests. Throws kInternal for
// the other kinds.
std::string ProduceWhole(const Response& response);

}  // namespace lares::http
