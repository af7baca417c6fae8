#include "server/cli/cache.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/file.h"

namespace lares::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMaxTextBytes = 64u << 20;

fs::path BlobPath(const fs::path& folder, const std::string& sha256) {
  return folder / "blobs" / sha256.substr(0, 2) / sha256;
}

bool MakeParent(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  return !error;
}

}  // namespace

std::optional<Cache> Cache::OfUser() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache == '/') {
    return Cache(fs::path(cache) / "lares");
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') {
    return Cache(fs::path(home) / ".cache" / "lares");
  }
  return std::nullopt;
}

std::optional<fs::path> Cache::Find(const std::string& sha256) const {
  const fs::path path = BlobPath(folder_, sha256);
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  fs::last_write_time(path, fs::file_time_type::clock::now(), error);
  return path;
}

void Cache::Drop(const std::string& sha256) const {
  std::error_code ignored;
  fs::remove(BlobPath(folder_, sha256), ignored);
}

Cache::Partial::~Partial() {
  if (lock_ >= 0) ::close(lock_);
}

Cache::Partial::Partial(Partial&& other) noexcept
    : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}

std::optional<Cache::Partial> Cache::Begin(const std::string& sha256) const {
  const fs::path path = folder_ / "partial" / sha256;
  if (!MakeParent(path)) return std::nullopt;
  const int lock = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock < 0) return std::nullopt;
  struct stat locked {};
  struct stat named {};
  // Another process may have kept the file, under its hash, since it was opened here.
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0 || ::fstat(lock, &locked) != 0 ||
      ::stat(path.c_str(), &named) != 0 || locked.st_ino != named.st_ino) {
    ::close(lock);
    return std::nullopt;
  }
  return Partial(path, lock);
}

void Cache::Keep(const Partial& partial, const std::string& sha256) const {
  const fs::path path = BlobPath(folder_, sha256);
  std::error_code ignored;
  if (MakeParent(path)) fs::rename(partial.path(), path, ignored);
}

std::optional<std::string> Cache::ReadText(const std::string& name) const {
  try {
    return ReadFile(folder_ / name, kMaxTextBytes);
  } catch (const Error&) {
    return std::nullopt;
  }
}

void Cache::KeepText(const std::string& name, const std::string& text) const {
  const fs::path path = folder_ / name;
  if (!MakeParent(path)) return;
  try {
    WriteFileAtomically(path, text);
  } catch (const Error&) {
    // Not kept, then.
  }
}

void Cache::DropText(const std::string& name) const {
  std::error_code ignored;
  fs::remove(folder_ / name, ignored);
}

void Cache::Trim(std::uint64_t max_bytes, const std::set<std::string>& in_use) const {
  struct Kept {
    fs::file_time_type used;
    std::uint64_t size = 0;
    fs::path path;
  };
  std::vector<Kept> all;
  std::uint64_t total = 0;
  std::error_code error;
  for (const char* part : {"blobs", "partial"}) {
    for (fs::recursive_directory_iterator at(folder_ / part, error), end; !error && at != end;
         at.increment(error)) {
      std::error_code gone;
      if (!at->is_regular_file(gone)) continue;
      all.push_back({at->last_write_time(gone), at->file_size(gone), at->path()});
      if (gone) {
        all.pop_back();
      } else {
        total += all.back().size;
      }
    }
    error.clear();
  }
  std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
  for (const Kept& kept : all) {
    if (total <= max_bytes) return;
    if (in_use.count(kept.path.filename().string()) != 0) continue;
    if (fs::remove(kept.path, error)) total -= kept.size;
  }
}

}  // namespace lares::cli
