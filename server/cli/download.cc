#include "server/cli/download.h"

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/text.h"
#include "server/api/layer_files.h"
#include "server/cli/grid_files.h"
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

void Download(Remote& remote, const Wanted& wanted, const fs::path& file) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  Sha256 hash;
  ProgressBar bar("receiving " + wanted.what);
  http::Transfer transfer;
  transfer.downloaded = [&bar](std::uint64_t done, std::uint64_t all) { bar.Show(done, all); };
  transfer.sink = [&](std::string_view piece) {
    ThrowIfAskedToStop();
    hash.Update(piece);
    out.write(piece.data(), static_cast<std::streamsize>(piece.size()));
    if (!out) throw Error(Code::kIo, "cannot write '" + file.string() + "'");
  };
  remote.Send({"GET", wanted.path, wanted.query, {}, {}}, transfer);
  out.close();
  if (!out) throw Error(Code::kIo, "cannot write '" + file.string() + "'");
  if (hash.FinishHex() != wanted.sha256) {
    throw Error(Code::kIo, wanted.what + " arrived damaged: its SHA-256 is not the announced one");
  }
}

std::string SaveLayer(Remote& remote, const std::string& version_path, const Json& layer,
                      const fs::path& folder) {
  const std::string name = TextOf(layer, "name");
  if (!IsIdentifier(name)) throw Error(Code::kIo, "the manifest names a layer '" + name + "'");
  const std::string file_name =
      api::LayerFileName(name, TextOf(layer, "file_name"), TextOf(layer, "media_type"));
  Download(remote,
           {"layer " + name, PathOf(version_path + "/layers", {name}), {}, TextOf(layer, "sha256")},
           folder / file_name);
  if (name != "grid") return file_name;
  UnpackGrid(folder / file_name, folder / "grid");
  fs::remove(folder / file_name);
  return "grid/";
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
  if (fs::exists(out)) fs::rename(out, temporary / "before");
  fs::rename(ready, out);
  SyncFolder(out);
  SyncFolder(temporary.parent_path());
}

}  // namespace lares::cli
