// TLS on accepted sockets, without any OpenSSL header in sight.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

namespace lares::http {

struct TlsOptions {
  std::filesystem::path
      certificate;            // PEM: the server's own first, then those that lead to the root
  std::filesystem::path key;  // PEM, without a passphrase
};

// What came of a try to move bytes: how many, the end, or what to wait for. Never waits itself.
struct TlsResult {
  enum class Kind { kMoved, kEnd, kWantsRead, kWantsWrite, kFailed };
  Kind kind = Kind::kFailed;
  std::size_t bytes = 0;
};

// One connection's session. Used by one thread at a time.
class TlsSession {
 public:
  struct State;
  explicit TlsSession(std::unique_ptr<State> state);
  ~TlsSession();

  // Goes on with the handshake: kMoved once it is done.
  TlsResult Handshake();
  bool is_open() const;  // the handshake is done
  TlsResult Read(char* bytes, std::size_t size);
  // What is tried again after kWantsWrite or kWantsRead begins with the same bytes.
  TlsResult Write(const char* bytes, std::size_t size);
  // Tells the peer that nothing more comes, if it takes that at once.
  void Close() noexcept;

 private:
  std::unique_ptr<State> state_;
};

// The certificate and its key, read once. TLS 1.2 and 1.3 only, forward secrecy only, no
// renegotiation, no compression. Thread-safe.
class TlsContext {
 public:
  // Throws kInvalid, naming the file, for what is no certificate or key or does not belong
  // together.
  explicit TlsContext(const TlsOptions& options);
  ~TlsContext();

  // `descriptor` stays the caller's and must outlive the session.
  std::unique_ptr<TlsSession> Accept(int descriptor) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lares::http
