#include "server/cli/resumable.h"

#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "base/hash.h"
#include "server/cli/download.h"
#include "server/cli/patience.h"
#include "server/cli/progress.h"
#include "server/http/client.h"

namespace lares::cli {
namespace {

namespace fs = std::filesystem;

// So much goes in one request.
constexpr std::uint64_t kPieceBytes = std::uint64_t{64} << 20;

// Where it is noted which upload a file's bytes go to.
std::string NoteName(const Remote& remote, const std::string& sha256) {
  return "uploads/" + Sha256Hex(remote.url() + "\n" + sha256).substr(0, 32);
}

struct State {
  std::uint64_t offset = 0;
  std::string sha256;  // the server's, once it has the whole
};

class Sender {
 public:
  Sender(Remote& remote, const std::string& what, const fs::path& file)
      : remote_(remote), file_(file), length_(fs::file_size(file)), bar_("sending " + what) {}

  std::string Create() {
    http::ClientRequest request = Request("POST", "/v1/uploads");
    request.headers.Set("Upload-Length", std::to_string(length_));
    const std::string path(remote_.Send(request).headers.Get("Location"));
    if (!path.starts_with("/v1/uploads/")) {
      throw Error(Code::kIo, "what answers at " + remote_.url() + " takes no uploads");
    }
    return path;
  }

  State Ask(const std::string& path) { return ReadState(remote_.Send(Request("HEAD", path))); }

  // Refused when a piece would be.
  State SendNothing(const std::string& path, std::uint64_t offset) {
    http::ClientRequest request = Request("PATCH", path);
    request.headers.Set("Upload-Offset", std::to_string(offset));
    return ReadState(remote_.Send(request));
  }

  // One piece more.
  State Send(const std::string& path, std::uint64_t offset, Patience& patience) {
    http::ClientRequest request = Request("PATCH", path);
    request.headers.Set("Upload-Offset", std::to_string(offset));
    http::EncodedForm piece;
    piece.content_type = "application/offset+octet-stream";
    piece.length = std::min(kPieceBytes, length_ - offset);
    piece.pieces = {{"", file_, piece.length, offset}};
    request.body = std::move(piece);
    http::Transfer transfer;
    transfer.uploaded = [&](std::uint64_t done, std::uint64_t) {
      if (IsAskedToStop()) throw Error(Code::kIo, "interrupted");
      patience.Progress();
      bar_.Show(offset + done, length_);
    };
    return ReadState(remote_.Send(request, transfer));
  }

  std::uint64_t length() const { return length_; }

 private:
  static http::ClientRequest Request(const char* method, const std::string& path) {
    http::ClientRequest request{method, path, {}, {}, {}};
    request.headers.Set("Tus-Resumable", "1.0.0");
    return request;
  }

  State ReadState(const http::ClientResponse& response) const {
    const std::string_view text = response.headers.Get("Upload-Offset");
    State state;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), state.offset);
    if (text.empty() || error != std::errc() || end != text.data() + text.size() ||
        state.offset > length_) {
      throw Error(Code::kIo, "what answers at " + remote_.url() + " does not say how far it is");
    }
    state.sha256 = response.headers.Get("Upload-Sha256");
    return state;
  }

  Remote& remote_;
  const fs::path file_;
  const std::uint64_t length_;
  ProgressBar bar_;
};

// From wherever the server is to the end. After a break (`again`) the server may still be at what
// came over the connection before: that is found out before many bytes are sent in vain.
State SendRest(Sender& sender, const std::string& path, Patience& patience, bool again) {
  State state = sender.Ask(path);
  if (again && state.offset < sender.length()) state = sender.SendNothing(path, state.offset);
  while (state.offset < sender.length()) state = sender.Send(path, state.offset, patience);
  return state;
}

bool IsCode(const Error& error, std::string_view problem_code) {
  const auto* remote = dynamic_cast<const RemoteError*>(&error);
  return remote != nullptr && remote->problem_code() == problem_code;
}

// An upload that was begun by an earlier process, if the server still has it.
std::optional<std::string> BegunBefore(Sender& sender, const ResumableOptions& options,
                                       const std::string& note) {
  const auto path = options.cache && options.resume ? options.cache->ReadText(note)
                                                    : std::optional<std::string>();
  if (!path) return std::nullopt;
  try {
    sender.Ask(*path);
    return path;
  } catch (const RemoteError&) {
    return std::nullopt;  // it has expired
  }
}

std::string BeginUpload(Sender& sender, const ResumableOptions& options, const std::string& note) {
  const std::optional<std::string> before = BegunBefore(sender, options, note);
  const std::string path = before ? *before : sender.Create();
  if (options.cache) options.cache->KeepText(note, path);
  return path;
}

}  // namespace

FinishedUpload UploadFile(Remote& remote, const std::string& what, const fs::path& file,
                          const ResumableOptions& options) {
  const std::string sha256 = Sha256OfFile(file);
  Sender sender(remote, what, file);
  const std::string note = NoteName(remote, sha256);
  std::optional<std::string> path;
  Patience patience(options.patience);
  for (bool again = false;; again = true) {
    try {
      if (!path) path = BeginUpload(sender, options, note);
      const State state = SendRest(sender, *path, patience, again);
      if (state.sha256 == sha256) return {*path, sha256};
      ForgetUpload(remote, {*path, sha256}, options);
      throw Error(Code::kIo, what + " arrived damaged, or changed while it was sent");
    } catch (Error& error) {
      // A conflict is one about the offset: it is asked for again.
      const bool was_never_there = !path && dynamic_cast<const http::NoServerError*>(&error);
      const bool passing = !was_never_there && (IsPassing(error) || IsCode(error, "conflict"));
      if (passing && patience.Wait()) continue;
      if (passing) error.WithHint("the same command with --resume goes on where it stopped");
      throw;
    }
  }
}

void ForgetUpload(Remote& remote, const FinishedUpload& upload, const ResumableOptions& options) {
  if (options.cache) options.cache->DropText(NoteName(remote, upload.sha256));
  try {
    http::ClientRequest request{"DELETE", upload.path, {}, {}, {}};
    request.headers.Set("Tus-Resumable", "1.0.0");
    remote.Send(request);
  } catch (const Error&) {
    // It expires by itself.
  }
}

}  // namespace lares::cli
