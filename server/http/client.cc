#include "server/http/client.h"

#include <httplib.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <exception>

#include "server/http/url.h"

namespace lares::http {
namespace {

constexpr std::uint64_t kMaxBody = 256u << 20;

// Writes the form's pieces in order; a file that shrank meanwhile is a fault, not a short body.
class FormSender {
 public:
  FormSender(const EncodedForm& form, const Progress& progress)
      : form_(form), progress_(progress) {}

  void Send(httplib::DataSink& sink) {
    for (const FormPiece& piece : form_.pieces) {
      if (piece.file.empty()) {
        Give(piece.text.data(), piece.text.size(), sink);
      } else {
        SendFile(piece, sink);
      }
    }
  }

 private:
  void SendFile(const FormPiece& piece, httplib::DataSink& sink) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(piece.file.c_str(), "rb"),
                                                               &std::fclose);
    if (file == nullptr || ::fseeko(file.get(), static_cast<off_t>(piece.offset), SEEK_SET) != 0) {
      throw Error(Code::kIo, "cannot read '" + piece.file.string() + "': " + std::strerror(errno));
    }
    std::array<char, 64 * 1024> bytes;
    for (std::uint64_t left = piece.length; left > 0;) {
      const std::size_t got =
          std::fread(bytes.data(), 1, std::min<std::uint64_t>(bytes.size(), left), file.get());
      if (got == 0) throw Error(Code::kIo, "'" + piece.file.string() + "' became shorter");
      Give(bytes.data(), got, sink);
      left -= got;
    }
  }

  void Give(const char* bytes, std::size_t size, httplib::DataSink& sink) {
    if (!sink.write(bytes, size))
      throw ConnectionError(Code::kIo, "the server closed the connection");
    done_ += size;
    if (progress_) progress_(done_, form_.length);
  }

  const EncodedForm& form_;
  const Progress& progress_;
  std::uint64_t done_ = 0;
};

httplib::Request ToHttplib(const ClientRequest& request) {
  httplib::Request to;
  to.method = request.method;
  to.path = request.path + FormatQuery(request.query);
  for (const auto& [name, value] : request.headers.all()) to.headers.emplace(name, value);
  if (const auto* text = std::get_if<std::string>(&request.body)) {
    to.body = *text;
  } else if (const auto* form = std::get_if<EncodedForm>(&request.body)) {
    to.set_header("Content-Type", form->content_type);
  }
  return to;
}

[[noreturn]] void ThrowFailure(httplib::Error error, const std::string& base_url) {
  switch (error) {
    case httplib::Error::Connection:
    case httplib::Error::ConnectionTimeout:
    case httplib::Error::BindIPAddress:
      throw NoServerError(Code::kUnavailable, "no Lares server answers at " + base_url);
    case httplib::Error::SSLConnection:
    case httplib::Error::SSLLoadingCerts:
    case httplib::Error::SSLServerVerification:
      throw Error(Code::kForbidden, "the server at " + base_url +
                                        " does not prove to be who it says it is, or speaks no TLS")
          .WithHint("--ca FILE (or LARES_CA) names the certificates that may vouch for it");
    case httplib::Error::Read:
      throw ConnectionError(Code::kIo, "the server at " + base_url +
                                           " closed the connection or did not answer in time");
    default:
      throw ConnectionError(
          Code::kIo, "the connection to " + base_url + " broke: " + httplib::to_string(error));
  }
}

}  // namespace

struct Client::State {
  BaseUrl address;
  std::string base_url;
  std::string token;
  httplib::Client client;

  explicit State(const std::string& url)
      : address(ParseBaseUrl(url)),
        base_url(FormatBaseUrl(address)),
        client(address.tls ? httplib::Client(base_url)
                           : httplib::Client(address.host, address.port)) {}
};

Client::Client(const std::string& base_url, const ClientOptions& options)
    : state_(std::make_unique<State>(base_url)) {
  httplib::Client& client = state_->client;
  client.set_tcp_nodelay(true);
  client.set_keep_alive(true);
  client.set_url_encode(false);
  client.set_connection_timeout(5);
  client.set_read_timeout(options.answer_time.count());
  client.set_write_timeout(60);
  state_->token = options.token;
  if (options.ca_file.empty()) return;
  if (!std::filesystem::is_regular_file(options.ca_file)) {
    throw Error(Code::kInvalid, "'" + options.ca_file.string() + "' is no file of certificates");
  }
  client.set_ca_cert_path(options.ca_file.c_str());
}

Client::~Client() = default;

const std::string& Client::base_url() const { return state_->base_url; }

ClientResponse Client::Send(const ClientRequest& request, const Transfer& transfer) {
  return Send(request, transfer, nullptr);
}

ClientResponse Client::Send(const ClientRequest& request, const Transfer& transfer,
                            const Answered& answered) {
  httplib::Request to = ToHttplib(request);
  to.set_header("Host", state_->base_url.substr(state_->base_url.find("//") + 2));
  if (!state_->token.empty()) to.set_header("Authorization", "Bearer " + state_->token);
  // Exceptions must not cross httplib: they are kept and rethrown.
  std::exception_ptr fault;
  const auto guarded = [&fault](auto&& work) {
    try {
      work();
      return true;
    } catch (...) {
      fault = std::current_exception();
      return false;
    }
  };
  if (const auto* form = std::get_if<EncodedForm>(&request.body)) {
    to.content_length_ = form->length;
    to.content_provider_ = [&, form](size_t, size_t, httplib::DataSink& sink) {
      return guarded([&] { FormSender(*form, transfer.uploaded).Send(sink); });
    };
  }
  ClientResponse response;
  std::uint64_t received = 0;
  to.response_handler = [&](const httplib::Response& from) {
    response.status = from.status;
    for (const auto& [name, value] : from.headers) response.headers.Add(name, value);
    // A 304 has no body, and httplib would wait for one until the server closes: it is told to
    // stop here, which costs this connection.
    if (from.status == 304) return false;
    return !answered || guarded([&] { answered(response); });
  };
  to.content_receiver = [&](const char* bytes, size_t size, uint64_t, uint64_t total) {
    return guarded([&] {
      received += size;
      if (transfer.sink && response.status >= 200 && response.status < 300) {
        transfer.sink({bytes, size});
      } else if (response.body.size() + size > kMaxBody) {
        throw Error(Code::kTooLarge, "the answer is larger than 256 MiB");
      } else {
        response.body.append(bytes, size);
      }
      if (transfer.downloaded) transfer.downloaded(received, total);
    });
  };
  const httplib::Result result = state_->client.send(to);
  if (fault) std::rethrow_exception(fault);
  if (response.status == 304) return response;
  if (!result) ThrowFailure(result.error(), state_->base_url);
  if (response.status == 0) {  // an answer without a body to hand over
    response.status = result->status;
    for (const auto& [name, value] : result->headers) response.headers.Add(name, value);
  }
  return response;
}

}  // namespace lares::http
