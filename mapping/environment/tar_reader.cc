#include "mapping/environment/tar_reader.h"

#include <archive.h>
#include <archive_entry.h>

#include "base/error.h"
#include "base/text.h"
#include "mapping/environment/facts.h"

namespace lares::environment {
namespace {

constexpr int kMaxEntries = 64;
constexpr std::size_t kMaxPathBytes = 512;
constexpr std::size_t kBlockBytes = 10240;

}  // namespace

struct TarReader::State {
  explicit State(std::string file_name) : name(std::move(file_name)) {
    if (handle == nullptr) throw Error(Code::kInternal, "libarchive has no memory");
    archive_read_support_filter_none(handle);
    archive_read_support_format_tar(handle);
  }
  ~State() { archive_read_free(handle); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  [[noreturn]] void Fail(const std::string& message) const {
    throw Error(Code::kInvalid, message, Place{name});
  }
  void Check(la_ssize_t result) const {
    if (result >= ARCHIVE_WARN || result == ARCHIVE_EOF) return;
    const char* reason = archive_error_string(handle);
    Fail("byte " + std::to_string(archive_filter_bytes(handle, 0)) +
         ": not a whole tar archive: " + Excerpt(reason == nullptr ? "damaged" : reason));
  }

  std::string name;
  struct archive* handle = archive_read_new();
  int entries = 0;
};

namespace {

// "./a//b" as "a/b"; nothing for a path that leaves the archive.
std::optional<std::string> Normalise(std::string_view path) {
  if (path.empty() || path.size() > kMaxPathBytes || path[0] == '/') return std::nullopt;
  std::vector<std::string> parts;
  for (const std::string& part : Split(path, '/')) {
    if (part == ".." || part.find('\0') != std::string::npos) return std::nullopt;
    if (!part.empty() && part != ".") parts.push_back(part);
  }
  return Join(parts, "/");
}

}  // namespace

TarReader TarReader::OfFile(const std::filesystem::path& file, std::string name) {
  auto state = std::make_shared<State>(std::move(name));
  state->Check(archive_read_open_filename(state->handle, file.c_str(), kBlockBytes));
  return TarReader(state);
}

TarReader TarReader::OfBytes(std::string_view bytes, std::string name) {
  auto state = std::make_shared<State>(std::move(name));
  state->Check(archive_read_open_memory(state->handle, bytes.data(), bytes.size()));
  return TarReader(state);
}

std::optional<TarEntry> TarReader::Next() {
  for (;;) {
    struct archive_entry* entry = nullptr;
    const int result = archive_read_next_header(state_->handle, &entry);
    state_->Check(result);
    if (result == ARCHIVE_EOF) return std::nullopt;
    if (++state_->entries > kMaxEntries) state_->Fail("the archive has more than 64 entries");
    const char* raw = archive_entry_pathname(entry);
    const std::string written = raw == nullptr ? "" : raw;
    const std::optional<std::string> path = Normalise(written);
    if (!path) state_->Fail("the path '" + Excerpt(written) + "' leads out of the archive");
    if (archive_entry_filetype(entry) == AE_IFDIR) continue;
    const bool is_plain = archive_entry_filetype(entry) == AE_IFREG &&
                          archive_entry_hardlink(entry) == nullptr &&
                          archive_entry_sparse_count(entry) == 0 && archive_entry_size(entry) >= 0;
    if (!is_plain) state_->Fail("'" + Excerpt(written) + "' is a link, device or sparse file");
    const std::size_t slash = path->find_last_of('/');
    if (path->substr(slash == std::string::npos ? 0 : slash + 1).starts_with("._")) continue;
    return TarEntry{*path, static_cast<std::uint64_t>(archive_entry_size(entry))};
  }
}

std::size_t TarReader::Read(char* into, std::size_t capacity) {
  const la_ssize_t count = archive_read_data(state_->handle, into, capacity);
  state_->Check(count);
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

}  // namespace lares::environment
