#include "server/http/tls.h"

#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <climits>

#include "base/error.h"

namespace lares::http {
namespace {

// TLS 1.2: ECDHE with AEAD. (1.3 has no others.)
constexpr const char* kCiphers =
    "ECDHE-ECDSA-AES128-GCM-SHA256:ECDHE-RSA-AES128-GCM-SHA256:ECDHE-ECDSA-AES256-GCM-SHA384:"
    "ECDHE-RSA-AES256-GCM-SHA384:ECDHE-ECDSA-CHACHA20-POLY1305:ECDHE-RSA-CHACHA20-POLY1305";

// A socket that neither waits nor raises SIGPIPE; OpenSSL's own does both.
int DescriptorOf(BIO* bio) {
  return static_cast<int>(reinterpret_cast<std::intptr_t>(BIO_get_data(bio)));
}

bool IsWorthAnotherTry(ssize_t moved) {
  return moved < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
}

int WriteSocket(BIO* bio, const char* bytes, int size) {
  BIO_clear_retry_flags(bio);
  const ssize_t sent =
      ::send(DescriptorOf(bio), bytes, static_cast<std::size_t>(size), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (IsWorthAnotherTry(sent)) BIO_set_retry_write(bio);
  return static_cast<int>(sent);
}

int ReadSocket(BIO* bio, char* bytes, int size) {
  BIO_clear_retry_flags(bio);
  const ssize_t got =
      ::recv(DescriptorOf(bio), bytes, static_cast<std::size_t>(size), MSG_DONTWAIT);
  if (IsWorthAnotherTry(got)) BIO_set_retry_read(bio);
  return static_cast<int>(got);
}

long ControlSocket(BIO*, int command, long, void*) { return command == BIO_CTRL_FLUSH ? 1 : 0; }

const BIO_METHOD* SocketMethod() {
  static BIO_METHOD* const method = [] {
    BIO_METHOD* made = BIO_meth_new(BIO_get_new_index() | BIO_TYPE_SOURCE_SINK, "lares socket");
    BIO_meth_set_write(made, WriteSocket);
    BIO_meth_set_read(made, ReadSocket);
    BIO_meth_set_ctrl(made, ControlSocket);
    return made;
  }();
  return method;
}

std::string LastReason() {
  const unsigned long code = ERR_peek_last_error();
  ERR_clear_error();
  const char* reason = ERR_reason_error_string(code);
  return reason != nullptr ? reason : "it cannot be read";
}

[[noreturn]] void Refuse(const std::string& what, const std::filesystem::path& file) {
  throw Error(Code::kInvalid, what + " '" + file.string() + "': " + LastReason());
}

// A key with a passphrase is refused instead of asked for on the terminal.
int NoPassphrase(char*, int, int, void*) { return 0; }

}  // namespace

struct TlsSession::State {
  SSL* ssl = nullptr;
  bool is_open = false;
  bool failed = false;

  ~State() { SSL_free(ssl); }

  TlsResult Judge(int result, std::size_t bytes) {
    if (result > 0) return {TlsResult::Kind::kMoved, bytes};
    const int error = SSL_get_error(ssl, result);
    if (error == SSL_ERROR_WANT_READ) return {TlsResult::Kind::kWantsRead, 0};
    if (error == SSL_ERROR_WANT_WRITE) return {TlsResult::Kind::kWantsWrite, 0};
    if (error == SSL_ERROR_ZERO_RETURN) return {TlsResult::Kind::kEnd, 0};
    failed = true;
    return {TlsResult::Kind::kFailed, 0};
  }
};

TlsSession::TlsSession(std::unique_ptr<State> state) : state_(std::move(state)) {}
TlsSession::~TlsSession() = default;

bool TlsSession::is_open() const { return state_->is_open; }

TlsResult TlsSession::Handshake() {
  if (state_->is_open) return {TlsResult::Kind::kMoved, 0};
  ERR_clear_error();
  const TlsResult result = state_->Judge(SSL_accept(state_->ssl), 0);
  state_->is_open = result.kind == TlsResult::Kind::kMoved;
  return result;
}

TlsResult TlsSession::Read(char* bytes, std::size_t size) {
  if (!state_->is_open) return {};
  ERR_clear_error();
  std::size_t got = 0;
  const int result = SSL_read_ex(state_->ssl, bytes, size, &got);
  return state_->Judge(result, got);
}

TlsResult TlsSession::Write(const char* bytes, std::size_t size) {
  if (!state_->is_open) return {};
  ERR_clear_error();
  std::size_t sent = 0;
  const int result = SSL_write_ex(state_->ssl, bytes, size, &sent);
  return state_->Judge(result, sent);
}

void TlsSession::Close() noexcept {
  // Not after a fault: OpenSSL forbids it.
  if (!state_->is_open || state_->failed) return;
  ERR_clear_error();
  SSL_shutdown(state_->ssl);
}

struct TlsContext::State {
  SSL_CTX* context = nullptr;
  ~State() { SSL_CTX_free(context); }
};

TlsContext::TlsContext(const TlsOptions& options) : state_(std::make_unique<State>()) {
  state_->context = SSL_CTX_new(TLS_server_method());
  SSL_CTX* context = state_->context;
  if (context == nullptr) throw Error(Code::kInternal, "TLS cannot be set up: " + LastReason());
  SSL_CTX_set_min_proto_version(context, TLS1_2_VERSION);
  SSL_CTX_set_cipher_list(context, kCiphers);
  SSL_CTX_set_options(context, SSL_OP_NO_RENEGOTIATION | SSL_OP_NO_COMPRESSION |
                                   SSL_OP_CIPHER_SERVER_PREFERENCE | SSL_OP_IGNORE_UNEXPECTED_EOF);
  SSL_CTX_set_mode(context, SSL_MODE_ENABLE_PARTIAL_WRITE | SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER |
                                SSL_MODE_RELEASE_BUFFERS);
  static constexpr unsigned char kSessions[] = "lares";
  SSL_CTX_set_session_id_context(context, kSessions, sizeof kSessions - 1);
  SSL_CTX_set_default_passwd_cb(context, NoPassphrase);
  ERR_clear_error();
  if (SSL_CTX_use_certificate_chain_file(context, options.certificate.c_str()) != 1) {
    Refuse("the certificate", options.certificate);
  }
  if (SSL_CTX_use_PrivateKey_file(context, options.key.c_str(), SSL_FILETYPE_PEM) != 1 ||
      SSL_CTX_check_private_key(context) != 1) {
    Refuse("the key", options.key);
  }
}

TlsContext::~TlsContext() = default;

std::unique_ptr<TlsSession> TlsContext::Accept(int descriptor) const {
  auto state = std::make_unique<TlsSession::State>();
  state->ssl = SSL_new(state_->context);
  BIO* bio = BIO_new(SocketMethod());
  if (state->ssl == nullptr || bio == nullptr) {
    BIO_free(bio);
    throw Error(Code::kUnavailable, "there is no memory for another connection");
  }
  BIO_set_data(bio, reinterpret_cast<void*>(static_cast<std::intptr_t>(descriptor)));
  BIO_set_init(bio, 1);
  SSL_set_bio(state->ssl, bio, bio);
  return std::make_unique<TlsSession>(std::move(state));
}

}  // namespace lares::http
