#include "server/cli/download.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/text.h"
#include "server/api/layer_files.h"
#include "server/cli/grid_files.h"
#include "server/cli/patience.h"
#include "server/cli/print.h"
#include "server/cli/progress.h"

namespace lares::cli {

namespace fs = std::filesystem;

namespace {

volatile std::sig_atomic_t stop_asked = 0;

void AskToStop(int signal) {
  stop_asked = 1;
  std::signal(signal, SIG_DFL);
}

void ThrowIfAskedToStop() {
  if (stop_asked != 0) throw Error(Code::kIo, "interrupted: nothing was written");
}

bool SyncFile(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool synced = ::fsync(file) == 0;
  ::close(file);
  return synced;
}

std::uint64_t SizeOf(const fs::path& file) {
  std::error_code error;
  const std::uint64_t size = fs::file_size(file, error);
  return error ? 0 : size;
}

// Appends to `file` what it lacks.
void FetchRest(Remote& remote, const Wanted& wanted, const fs::path& file, ProgressBar& bar,
               Patience& patience) {
  std::uint64_t begun = SizeOf(file);
  http::ClientRequest request{"GET", wanted.path, wanted.query, {}, {}};
  if (begun > 0) request.headers.Set("Range", "bytes=" + std::to_string(begun) + "-");
  std::ofstream out(file, std::ios::binary | std::ios::app);
  http::Transfer transfer;
  const auto answered = [&](const http::ClientResponse& head) {
    if (head.status != 200 || begun == 0) return;
    out.close();  // the whole of it comes
    out.open(file, std::ios::binary | std::ios::trunc);
    begun = 0;
  };
  transfer.downloaded = [&](std::uint64_t done, std::uint64_t all) {
    bar.Show(begun + done, all == 0 ? 0 : begun + all);
  };
  transfer.sink = [&](std::string_view piece) {
    ThrowIfAskedToStop();
    patience.Progress();
    out.write(piece.data(), static_cast<std::streamsize>(piece.size()));
    if (!out) throw Error(Code::kIo, "cannot write '" + file.string() + "'");
  };
  try {
    remote.Send(request, transfer, answered);
  } catch (const RemoteError& error) {
    if (error.problem_code() != "range-not-satisfiable") throw;  // else it is all there
  }
  out.close();
  if (!out) throw Error(Code::kIo, "cannot write '" + file.string() + "'");
}

void Fetch(Remote& remote, const Wanted& wanted, const fs::path& file,
           std::chrono::seconds patience_time) {
  ProgressBar bar("receiving " + wanted.what);
  Patience patience(patience_time);
  while (true) {
    try {
      return FetchRest(remote, wanted, file, bar, patience);
    } catch (const Error& error) {
      if (!IsPassing(error) || !patience.Wait()) throw;
    }
  }
}

}  // namespace

StopOnSignal::StopOnSignal() {
  stop_asked = 0;
  std::signal(SIGINT, AskToStop);
  std::signal(SIGTERM, AskToStop);
}

StopOnSignal::~StopOnSignal() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool IsAskedToStop() { return stop_asked != 0; }

bool CopyChecked(const fs::path& from, const fs::path& to, const std::string& sha256) {
  std::ifstream in(from, std::ios::binary);
  std::ofstream out(to, std::ios::binary | std::ios::trunc);
  std::string buffer(1 << 20, '\0');
  Sha256 hash;
  while (in) {
    ThrowIfAskedToStop();
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const std::string_view piece(buffer.data(), static_cast<std::size_t>(in.gcount()));
    hash.Update(piece);
    out.write(piece.data(), static_cast<std::streamsize>(piece.size()));
  }
  if (!in.eof()) throw Error(Code::kIo, "cannot read '" + from.string() + "'");
  out.close();
  if (!out || !SyncFile(to)) throw Error(Code::kIo, "cannot write '" + to.string() + "'");
  return hash.FinishHex() == sha256;
}

void Download(Remote& remote, const Wanted& wanted, const fs::path& file, const Getting& getting) {
  if (!IsSha256Hex(wanted.sha256)) {
    throw Error(Code::kIo, "the server does not say which SHA-256 " + wanted.what + " has");
  }
  if (getting.cache) {
    const auto kept = getting.cache->Find(wanted.sha256);
    if (kept && CopyChecked(*kept, file, wanted.sha256)) return;
    if (kept) getting.cache->Drop(wanted.sha256);
  }
  const auto partial = getting.cache ? getting.cache->Begin(wanted.sha256) : std::nullopt;
  const fs::path arriving = partial ? partial->path() : fs::path(file.string() + ".part");
  // What an earlier call left may be damaged: then all of it is got anew, once.
  for (int attempt = 0; attempt < 2; ++attempt) {
    Fetch(remote, wanted, arriving, getting.patience);
    if (CopyChecked(arriving, file, wanted.sha256)) {
      if (partial) getting.cache->Keep(*partial, wanted.sha256);
      if (!partial) fs::remove(arriving);
      return;
    }
    fs::resize_file(arriving, 0);
  }
  throw Error(Code::kIo, wanted.what + " arrived damaged: its SHA-256 is not the announced one");
}

namespace {

std::string LayerName(const Json& layer) {
  const std::string name = TextOf(layer, "name");
  if (!IsIdentifier(name)) throw Error(Code::kIo, "the manifest names a layer '" + name + "'");
  return name;
}

std::string LayerFile(const Json& layer) {
  return api::LayerFileName(LayerName(layer), TextOf(layer, "file_name"),
                            TextOf(layer, "media_type"));
}

// A grid becomes the folder that map_server reads.
std::string Unpacked(const std::string& name, const std::string& file_name,
                     const fs::path& folder) {
  if (name != "grid") return file_name;
  UnpackGrid(folder / file_name, folder / "grid");
  fs::remove(folder / file_name);
  return "grid/";
}

}  // namespace

std::string SaveLayer(Remote& remote, const std::string& version_path, const Json& layer,
                      const fs::path& folder, const Getting& getting) {
  const std::string name = LayerName(layer);
  const std::string file_name = LayerFile(layer);
  Download(remote,
           {"layer " + name, PathOf(version_path + "/layers", {name}), {}, TextOf(layer, "sha256")},
           folder / file_name, getting);
  return Unpacked(name, file_name, folder);
}

std::string SaveCachedLayer(const Cache& cache, const Json& layer, const fs::path& folder) {
  const std::string name = LayerName(layer);
  const std::string file_name = LayerFile(layer);
  const std::string sha256 = TextOf(layer, "sha256");
  const auto kept = IsSha256Hex(sha256) ? cache.Find(sha256) : std::nullopt;
  if (!kept || !CopyChecked(*kept, folder / file_name, sha256)) {
    throw Error(Code::kNotFound,
                "layer " + name + " is not kept in '" + cache.folder().string() + "'");
  }
  return Unpacked(name, file_name, folder);
}

fs::path TargetFolder(const std::string& out) {
  const fs::path target = fs::absolute(out).lexically_normal();
  return target.has_filename() ? target : target.parent_path();
}

void PublishFolder(const fs::path& temporary, const fs::path& out) {
  ThrowIfAskedToStop();
  const fs::path ready = temporary / "content";
  fs::permissions(ready,
                  fs::perms::others_read | fs::perms::others_exec | fs::perms::group_read |
                      fs::perms::group_exec,
                  fs::perm_options::add);
  if (::renameat2(AT_FDCWD, ready.c_str(), AT_FDCWD, out.c_str(), RENAME_EXCHANGE) != 0) {
    if (fs::exists(out)) fs::rename(out, temporary / "before");  // where it cannot be exchanged
    fs::rename(ready, out);
  }
  SyncFolder(out);
  SyncFolder(temporary.parent_path());
}

}  // namespace lares::cli
