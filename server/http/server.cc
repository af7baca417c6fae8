#include "server/http/server.h"

#include <httplib.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "base/text.h"
#include "server/http/header_check.h"
#include "server/http/listen.h"
#include "server/http/log.h"
#include "server/http/long_transfers.h"
#include "server/http/open_sink.h"
#include "server/http/problem.h"
#include "server/http/url.h"

namespace lares::http {
namespace {

using Clock = std::chrono::steady_clock;

// Renamed on the way in: httplib would act on the Range itself, on every kind of body.
constexpr std::string_view kRangeAlias = "X-Lares-Range";

constexpr std::size_t kMaxTarget = 4096;

// Above these, or when the length is not known, a transfer counts as long.
constexpr std::uint64_t kShortBody = 64 * 1024;
constexpr std::uint64_t kShortAnswer = 1024 * 1024;

// One request on its way through httplib. The callbacks find it through `current`: they run on the
// thread that called process_request.
struct Exchange {
  Connection& connection;
  LongTransfers& long_transfers;
  LongTransfers& event_streams;
  Request request;
  Service::Admission admission;
  bool admitted = false;
  bool chunked = false;
  bool body_read = false;
  bool keep_open = true;
  bool is_long = false;  // counted in `long_transfers`
  bool has_ranges = false;
  bool is_http_1_0 = false;
  bool is_last = false;        // of its connection, as httplib sees it
  bool has_no_length = false;  // which httplib does not know of
  bool is_sent = false;        // by us, head and all: httplib's own answer goes nowhere
  int status = 0;
  std::uint64_t body_bytes = 0;
  std::optional<EventsBody> events;
  std::shared_ptr<void> place;  // among the event streams

  Exchange(Connection& from, LongTransfers& transfers, LongTransfers& streams)
      : connection(from), long_transfers(transfers), event_streams(streams) {}
  ~Exchange() {
    if (is_long) long_transfers.End();
  }
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  bool BeginLongTransfer() {
    is_long = is_long || long_transfers.TryBegin();
    if (is_long) connection.MarkLong();
    return is_long;
  }
  bool BeginEventStream() {
    if (!event_streams.TryBegin()) return false;
    place = std::shared_ptr<void>(nullptr, [&streams = event_streams](void*) { streams.End(); });
    return true;
  }
};
thread_local Exchange* current = nullptr;

// Takes out what httplib adds by itself and what would not be true.
std::string WithoutAdditions(std::string_view head, const Exchange& exchange) {
  std::string kept(head);
  const auto drop = [&kept](std::string_view line) {
    if (const std::size_t at = kept.find(line); at != std::string::npos) {
      kept.erase(at + 2, line.size() - 2);
    }
  };
  // A status of another protocol's (tus), for which httplib has no reason.
  constexpr std::string_view kNoReason = " 460 Internal Server Error\r\n";
  if (const std::size_t at = kept.find(kNoReason); at != std::string::npos && at < 10) {
    kept.replace(at, kNoReason.size(), " 460 Checksum Mismatch\r\n");
  }
  if (exchange.status == 304 || exchange.has_no_length) drop("\r\nContent-Length: 0\r\n");
  if (!exchange.has_ranges) drop("\r\nAccept-Ranges: bytes\r\n");
  return kept;
}

// What httplib reads from and writes to.
class ConnectionStream : public httplib::Stream {
 public:
  ConnectionStream(Connection& connection, std::size_t header_bytes)
      : connection_(connection), header_left_(header_bytes) {}

  bool is_readable() const override { return true; }
  bool is_writable() const override { return true; }
  // httplib takes more for a chunked body than is one: its bytes are checked on their way.
  ssize_t read(char* bytes, size_t size) override {
    if (header_left_ > 0) size = std::min(size, header_left_);
    const long got = connection_.Read(bytes, size);
    if (got <= 0) return got;
    if (header_left_ > 0) {
      header_left_ -= static_cast<std::size_t>(got);
    } else if (current->chunked && !body_.Accept({bytes, static_cast<std::size_t>(got)})) {
      return -1;
    }
    return got;
  }
  ssize_t write(const char* bytes, size_t size) override {
    if (current->is_sent) return static_cast<ssize_t>(size);
    if (head_written_ || current->status == 0) return Send({bytes, size}, size);
    head_written_ = true;
    return Send(WithoutAdditions({bytes, size}, *current), size);
  }
  void get_remote_ip_and_port(std::string& ip, int& port) const override {
    ip = connection_.remote();
    port = 0;
  }
  void get_local_ip_and_port(std::string& ip, int& port) const override {
    ip.clear();
    port = 0;
  }
  socket_t socket() const override { return connection_.fd(); }

 private:
  ssize_t Send(std::string_view bytes, size_t size) {
    return connection_.Write(bytes) ? static_cast<ssize_t>(size) : -1;
  }

  Connection& connection_;
  std::size_t header_left_;
  ChunkedBodyCheck body_;
  bool head_written_ = false;
};

std::string MarkRange(std::string header) {
  for (std::size_t line = header.find("\r\n"); line != std::string::npos;
       line = header.find("\r\n", line + 2)) {
    static constexpr std::string_view kName = "range:";
    if (header.size() - line - 2 < kName.size()) break;
    if (ToLower(std::string_view(header).substr(line + 2, kName.size())) != kName) continue;
    header.replace(line + 2, kName.size() - 1, kRangeAlias);
  }
  return header;
}

Request ToRequest(const httplib::Request& from) {
  Request request;
  request.method = from.method;
  request.remote = from.remote_addr;
  for (const auto& [name, value] : from.headers) {
    if (name == "REMOTE_ADDR" || name == "REMOTE_PORT" || name == "LOCAL_ADDR" ||
        name == "LOCAL_PORT") {
      continue;  // httplib's own additions
    }
    request.headers.Add(name == kRangeAlias ? "Range" : name, value);
  }
  const std::size_t question = from.target.find('?');
  request.path = from.target.substr(0, question);
  const bool chunked = ToLower(request.headers.Get("Transfer-Encoding")).ends_with("chunked");
  if (const std::string* length = request.headers.Find("Content-Length"); length && !chunked) {
    request.content_length = std::strtoull(length->c_str(), nullptr, 10);
  }
  request.has_body = chunked || request.content_length.value_or(0) > 0;
  return request;
}

// Refuses what the header alone shows to be wrong.
void CheckHeader(const httplib::Request& from, Request& request) {
  if (from.target.size() > kMaxTarget) {
    throw ProblemError("uri-too-long", "the address is longer than 4096 bytes");
  }
  const std::size_t question = from.target.find('?');
  auto query = ParseQuery(question == std::string::npos ? "" : from.target.substr(question + 1));
  if (!query) throw ProblemError("bad-request", "the address's query cannot be read");
  request.query = std::move(*query);
}

ProblemError TooManyTransfers() {
  return ProblemError("unavailable", "too many long transfers are in progress")
      .WithHeader("Retry-After", "5");
}

// Called by httplib once the header is read: decides before a byte of the body is.
void AdmitRequest(const Service& service, httplib::Request& from) {
  Exchange& exchange = *current;
  exchange.request = ToRequest(from);
  exchange.request.watch_client = [&connection = exchange.connection] {
    return connection.WatchPeer();
  };
  exchange.is_http_1_0 = from.version == "HTTP/1.0";
  exchange.is_last = exchange.is_last || from.get_header_value("Connection") == "close";
  exchange.chunked = exchange.request.has_body && !exchange.request.content_length;
  try {
    CheckHeader(from, exchange.request);
    exchange.admission = service.Admit(exchange.request);
    // What is short came with the header, unless its client waits to be asked for it.
    const bool is_long = exchange.request.has_body &&
                         (exchange.request.content_length.value_or(UINT64_MAX) > kShortBody ||
                          from.has_header("Expect"));
    if (!exchange.admission.refusal && is_long && !exchange.BeginLongTransfer()) {
      exchange.admission.refusal = Service::Refuse(TooManyTransfers(), exchange.request.id);
    }
  } catch (const std::exception& error) {
    exchange.request.id = RequestId(exchange.request.headers.Get("X-Request-Id"));
    exchange.admission.refusal = Service::Refuse(error, exchange.request.id);
  }
  exchange.admitted = true;
  // httplib is to neither parse forms, nor decompress, nor compress, nor slice.
  from.headers.erase("Content-Type");
  from.headers.erase("Accept-Encoding");
  from.ranges.clear();
}

void SendFile(const FileBody& file, httplib::DataSink& sink) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> handle(std::fopen(file.path.c_str(), "rb"),
                                                               &std::fclose);
  if (handle == nullptr || ::fseeko(handle.get(), static_cast<off_t>(file.offset), SEEK_SET) != 0) {
    throw Error(Code::kIo, "cannot read '" + file.path.string() + "': " + std::strerror(errno));
  }
  std::array<char, 64 * 1024> piece;
  std::uint64_t left = file.length;
  while (left > 0) {
    const std::size_t wanted = std::min<std::uint64_t>(piece.size(), left);
    const std::size_t got = std::fread(piece.data(), 1, wanted, handle.get());
    if (got == 0) throw Error(Code::kIo, "'" + file.path.string() + "' is shorter than it was");
    if (!sink.write(piece.data(), got)) throw Error(Code::kIo, "the client has gone");
    left -= got;
  }
}

// Refuses what would hold more threads or places than there are for its kind.
void LimitTransfers(Exchange& exchange, Response& response) {
  if (exchange.request.method == "HEAD") return;
  const bool is_long =
      BodyLength(response) > kShortAnswer || std::holds_alternative<OpenBody>(response.body);
  if (is_long && !exchange.BeginLongTransfer()) {
    response = Service::Refuse(TooManyTransfers(), exchange.request);
  }
  if (std::holds_alternative<EventsBody>(response.body) && !exchange.BeginEventStream()) {
    response = Service::Refuse(
        ProblemError("unavailable", "every place for an event stream is taken: " +
                                        std::to_string(exchange.event_streams.max()) +
                                        " clients are being told of events")
            .WithHeader("Retry-After", "5"),
        exchange.request);
  }
}

// The head of an answer whose length is not known.
std::string OpenHead(const Response& response, const Exchange& exchange) {
  std::string head = "HTTP/1.1 " + std::to_string(response.status) +
                     (response.status == 200 ? " OK\r\n" : " \r\n");
  for (const auto& [name, value] : response.headers.all()) {
    head += name + ": " + value + "\r\n";
  }
  if (!exchange.is_http_1_0) head += "Transfer-Encoding: chunked\r\n";
  if (!exchange.keep_open || exchange.is_last) head += "Connection: close\r\n";
  return head + "\r\n";
}

// Too late for a problem document.
void CutShort(Exchange& exchange, const std::exception& error) {
  exchange.keep_open = false;
  Log(LogLevel::kWarning, "a response was cut short",
      {{"request_id", exchange.request.id}, {"error", std::string(error.what())}});
}

// Runs an open body; what is left for httplib to send: the short answer, a problem, or nothing.
Response RunOpenBody(Response response, Exchange& exchange) {
  const OpenBody body = std::move(std::get<OpenBody>(response.body));
  BufferedSink sink(
      exchange.connection, [&] { return OpenHead(response, exchange); }, !exchange.is_http_1_0);
  exchange.keep_open = exchange.keep_open && !exchange.is_http_1_0;
  try {
    body.produce(sink);
    if (sink.begun()) sink.End();
  } catch (const std::exception& error) {
    if (!sink.begun()) return Service::Refuse(error, exchange.request);
    CutShort(exchange, error);
    sink.TryFlush();  // what came before is the client's too
  }
  if (!sink.begun()) {
    response.body = sink.TakeBuffered();
    return response;
  }
  exchange.is_sent = true;
  exchange.status = response.status;
  exchange.body_bytes = sink.bytes();
  return response;
}

void GiveResponse(Response response, httplib::Response& to) {
  Exchange& exchange = *current;
  LimitTransfers(exchange, response);
  if (exchange.request.has_body && !exchange.body_read) exchange.keep_open = false;
  if (std::holds_alternative<OpenBody>(response.body) && exchange.request.method != "HEAD") {
    response = RunOpenBody(std::move(response), exchange);
    if (exchange.is_sent) {
      to.status = response.status;
      return;
    }
  }
  exchange.has_ranges = response.headers.Get("Accept-Ranges") == "bytes";
  exchange.status = to.status = response.status;
  exchange.body_bytes = exchange.request.method == "HEAD" ? 0 : BodyLength(response);
  // httplib sets the length by the content; the type goes with it.
  const std::string type(response.headers.Get("Content-Type"));
  for (const auto& [name, value] : response.headers.all()) {
    if (ToLower(name) != "content-length") to.headers.emplace(name, value);
  }
  if (!exchange.keep_open) to.set_header("Connection", "close");
  if (auto* text = std::get_if<std::string>(&response.body)) {
    to.body = std::move(*text);
    return;
  }
  auto* events = std::get_if<EventsBody>(&response.body);
  if (events != nullptr || std::holds_alternative<OpenBody>(response.body)) {
    exchange.has_no_length = true;
    if (!exchange.is_http_1_0) to.set_header("Transfer-Encoding", "chunked");
    if (events == nullptr || exchange.request.method == "HEAD") return;
    if (exchange.keep_open && !exchange.is_last) to.set_header("Connection", "close");
    exchange.keep_open = false;
    exchange.events = std::move(*events);
    return;
  }
  const std::uint64_t length = BodyLength(response);
  if (length == 0) return;
  to.headers.erase("Content-Type");
  to.set_content_provider(
      length, type, [body = std::move(response.body)](size_t, size_t, httplib::DataSink& sink) {
        if (const auto* file = std::get_if<FileBody>(&body)) {
          SendFile(*file, sink);
        } else {
          std::get<StreamBody>(body).produce([&sink](std::string_view piece) {
            if (!sink.write(piece.data(), piece.size())) {
              throw Error(Code::kIo, "the client has gone");
            }
          });
        }
        return true;
      });
}

// Gives the body to `sink` through httplib's reader, which takes no exceptions.
void ReadBody(const httplib::ContentReader& reader, std::uint64_t max_bytes, const Sink& sink) {
  Exchange& exchange = *current;
  std::exception_ptr fault;
  std::uint64_t total = 0;
  const bool whole = reader([&](const char* bytes, size_t size) {
    try {
      total += size;
      if (total > max_bytes) {
        throw Error(Code::kTooLarge, "the body is longer than the " + std::to_string(max_bytes) +
                                         " bytes allowed here");
      }
      sink({bytes, size});
      return true;
    } catch (...) {
      fault = std::current_exception();
      return false;
    }
  });
  if (fault) std::rethrow_exception(fault);
  if (!whole && exchange.connection.stalled()) {
    throw ProblemError("request-timeout", "the body came too slowly");
  }
  if (!whole) {
    throw ProblemError("bad-request", exchange.chunked
                                          ? "the body's chunks are malformed, or it ends early"
                                          : "the body ends before it is complete");
  }
  exchange.body_read = true;
}

// httplib as the protocol's engine: its own sockets and threads are not used.
class Engine : public httplib::Server {
 public:
  explicit Engine(const Service& service) : service_(service) {
    svr_sock_ = 0;  // "running": content is sent to its end; never used as a descriptor
    set_payload_max_length(std::numeric_limits<size_t>::max());
    set_pre_routing_handler([this](const httplib::Request&, httplib::Response& to) {
      return BeforeBody(to) ? HandlerResponse::Handled : HandlerResponse::Unhandled;
    });
    const auto with_body = [this](const httplib::Request&, httplib::Response& to,
                                  const httplib::ContentReader& reader) { AfterBody(to, reader); };
    Post("[^]*", with_body);
    Put("[^]*", with_body);
    Patch("[^]*", with_body);
    Delete("[^]*", with_body);
    set_expect_100_continue_handler([](const httplib::Request&, httplib::Response& to) {
      if (!current->admission.refusal) return 100;
      GiveResponse(*current->admission.refusal, to);
      return to.status;
    });
    set_error_handler(httplib::Server::Handler(
        [](const httplib::Request&, httplib::Response& to) { RefuseMalformed(to); }));
  }
  ~Engine() override { svr_sock_ = INVALID_SOCKET; }

  bool Process(Connection& connection, std::size_t header_bytes, bool close) {
    current->is_last = close;
    ConnectionStream stream(connection, header_bytes);
    bool closed = false;
    const bool fine = process_request(stream, close, closed, [this](httplib::Request& request) {
      AdmitRequest(service_, request);
    });
    return fine && !closed;
  }

 private:
  // True when the answer is given already.
  bool BeforeBody(httplib::Response& to) const {
    Exchange& exchange = *current;
    if (exchange.admission.refusal) {
      GiveResponse(*exchange.admission.refusal, to);
      return true;
    }
    if (exchange.request.has_body) return false;
    exchange.request.read_body = [](const Sink&) {};
    GiveResponse(service_.Run(*exchange.admission.route, exchange.request), to);
    return true;
  }

  void AfterBody(httplib::Response& to, const httplib::ContentReader& reader) const {
    Exchange& exchange = *current;
    const Route& route = *exchange.admission.route;
    exchange.request.read_body = [&](const Sink& sink) {
      ReadBody(reader, route.max_body_bytes, sink);
    };
    GiveResponse(service_.Run(route, exchange.request), to);
  }

  // What httplib refused by itself, before it gave us the request.
  static void RefuseMalformed(httplib::Response& to) {
    Exchange& exchange = *current;
    if (exchange.status != 0) return;  // the answer is ours already
    exchange.keep_open = false;
    exchange.request.id = RequestId("");
    const bool too_long = to.status == 414;
    Response problem = Service::Refuse(
        ProblemError(too_long ? "uri-too-long" : "bad-request",
                     too_long ? "the address is longer than 4096 bytes"
                              : "the request line or a header field cannot be read"),
        exchange.request.id);
    GiveResponse(std::move(problem), to);
    to.set_header("Connection", "close");
  }

  const Service& service_;
};

std::string RawProblem(const ProblemError& error) {
  const std::string& problem_code = error.problem_code();
  const Response problem = Service::Refuse(error, RequestId(""));
  const std::string& body = std::get<std::string>(problem.body);
  return "HTTP/1.1 " + std::to_string(problem.status) + " " +
         std::string(FindProblemKind(problem_code).title) +
         "\r\nContent-Type: application/problem+json\r\nConnection: close\r\nContent-Length: " +
         std::to_string(body.size()) + "\r\n\r\n" + body;
}

std::string RawRefusal(const std::string& problem_code) {
  return RawProblem(
      ProblemError(problem_code, problem_code == "request-timeout"
                                     ? "the request did not arrive in time"
                                     : "the request's header is larger than allowed"));
}

}  // namespace

struct Server::State {
  std::shared_ptr<const Service> service;
  ServerOptions options;
  int port = 0;
  std::unique_ptr<Engine> engine;
  std::unique_ptr<LongTransfers> long_transfers;
  std::unique_ptr<LongTransfers> event_streams;
  std::unique_ptr<TlsContext> tls;
  std::unique_ptr<ConnectionLoop> loop;

  Served Serve(Connection& connection, bool closing) const;
  void Record(const Exchange& exchange, Clock::duration duration) const;
};

Served Server::State::Serve(Connection& connection, bool closing) const {
  const Clock::time_point start = Clock::now();
  std::string header = connection.TakeHeader();
  Exchange exchange(connection, *long_transfers, *event_streams);
  try {
    CheckRawHeader(header);
  } catch (const ProblemError& error) {
    connection.Write(RawProblem(error));
    exchange.status = FindProblemKind(error.problem_code()).status;
    connection.Linger(kShortBody);
    Record(exchange, Clock::now() - start);
    return {};
  }
  header = MarkRange(std::move(header));
  const std::size_t header_bytes = header.size();
  connection.PutBack(std::move(header));
  current = &exchange;
  bool open = false;
  try {
    open = engine->Process(connection, header_bytes, closing);
  } catch (const std::exception& error) {
    CutShort(exchange, error);
  }
  current = nullptr;
  const bool flushed = connection.Flush();
  Record(exchange, Clock::now() - start);
  if (!flushed) return {};
  if (exchange.request.has_body && !exchange.body_read) {
    connection.Linger(exchange.request.content_length.value_or(UINT64_MAX));
    return {};
  }
  if (exchange.events) {
    return {false, std::move(exchange.events->subscribe), !exchange.is_http_1_0,
            std::move(exchange.place)};
  }
  return {open && exchange.keep_open, {}, false, {}};
}

void Server::State::Record(const Exchange& exchange, Clock::duration duration) const {
  const Route* route = exchange.admission.route;
  const std::string operation = route != nullptr ? route->operation : "none";
  service->metrics().Record(operation, exchange.status, duration,
                            exchange.request.content_length.value_or(0), exchange.body_bytes);
  if (!options.access_log) return;
  const double milliseconds = std::chrono::duration<double, std::milli>(duration).count();
  Log(exchange.status >= 500 ? LogLevel::kError : LogLevel::kInfo, "request",
      {{"request_id", exchange.request.id},
       {"method", exchange.request.method},
       {"path", exchange.request.path},
       {"operation", operation},
       {"status", static_cast<std::int64_t>(exchange.status)},
       {"duration_ms", milliseconds},
       {"bytes_in", static_cast<std::int64_t>(exchange.connection.bytes_in())},
       {"bytes_out", static_cast<std::int64_t>(exchange.connection.bytes_out())},
       {"remote", exchange.connection.remote()}});
}

Server::Server(std::shared_ptr<const Service> service, const ServerOptions& options)
    : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.service = std::move(service);
  state.options = options;
  state.engine = std::make_unique<Engine>(*state.service);
  state.long_transfers = std::make_unique<LongTransfers>(std::max(1, options.loop.threads / 2));
  const int half_of_connections =
      static_cast<int>(std::min<std::size_t>(options.loop.max_connections / 2, INT32_MAX));
  state.event_streams = std::make_unique<LongTransfers>(
      std::max(1, std::min(options.loop.max_event_streams, half_of_connections)));
  if (options.tls) state.tls = std::make_unique<TlsContext>(*options.tls);
  const Listener listener = options.beyond_loopback ? ListenOn(options.host, options.port)
                                                    : ListenOnLoopback(options.host, options.port);
  state.port = listener.port;
  state.loop =
      std::make_unique<ConnectionLoop>(listener.descriptor, options.loop,
                                       LoopHandlers{[&state](Connection& connection, bool closing) {
                                                      return state.Serve(connection, closing);
                                                    },
                                                    RawRefusal},
                                       state.tls.get());
}

Server::~Server() = default;

int Server::port() const { return state_->port; }

std::string Server::url() const {
  return FormatBaseUrl({state_->options.host, state_->port, state_->tls != nullptr});
}

bool Server::Stop(std::chrono::milliseconds grace) { return state_->loop->Stop(grace); }

}  // namespace lares::http
