#include "server/store/uploads.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include "base/file.h"

namespace lares::store {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxStateBytes = 64 * 1024;

Error NoUpload(const std::string& id) {
  return Error(Code::kNotFound, "there is no upload '" + id.substr(0, 80) + "'")
      .WithHint("it may have expired: begin a new one");
}

bool IsUploadId(const std::string& id) {
  return id.size() == 32 && id.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string NewUploadId() {
  std::random_device random;
  static constexpr char kHex[] = "0123456789abcdef";
  std::string id;
  while (id.size() < 32) {
    for (unsigned bits = random(), i = 0; i < 8; ++i, bits >>= 4) id += kHex[bits & 15];
  }
  return id;
}

std::string ToText(const UploadInfo& info) {
  return nlohmann::json{{"length", info.length},
                        {"offset", info.offset},
                        {"metadata", info.metadata},
                        {"expires", info.expires.time_since_epoch().count()},
                        {"sha256", info.sha256}}
      .dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

// Throws nlohmann's exceptions for what we did not write.
UploadInfo FromText(const std::string& id, const std::string& text) {
  const nlohmann::json state = nlohmann::json::parse(text);
  UploadInfo info;
  info.id = id;
  info.length = state.at("length");
  info.offset = state.at("offset");
  info.metadata = state.at("metadata");
  info.expires = Time(std::chrono::milliseconds(state.at("expires").get<std::int64_t>()));
  info.sha256 = state.at("sha256");
  return info;
}

}  // namespace

// Held by the one who changes an upload; let go by the process's end too.
class Uploads::Lock {
 public:
  // Throws kNotFound when there is no folder, UploadBusyError.
  Lock(const fs::path& folder, const std::string& id)
      : file_(::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (file_ < 0 && (errno == ENOENT || errno == ENOTDIR)) throw NoUpload(id);
    if (file_ < 0) {
      throw Error(Code::kUnavailable, "cannot lock upload '" + id + "': " + std::strerror(errno));
    }
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
      ::close(file_);
      throw UploadBusyError(id);
    }
  }
  ~Lock() { ::close(file_); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int file_;
};

class Uploads::Writer final : public UploadWriter {
 public:
  Writer(Uploads& uploads, std::unique_ptr<Lock> lock, UploadInfo info, Pieces pieces)
      : uploads_(uploads),
        lock_(std::move(lock)),
        info_(std::move(info)),
        pieces_(pieces),
        running_(uploads.TakeRunning(info_)),
        appended_(info_.offset) {
    const fs::path path = uploads_.DataOf(info_.id);
    file_ = uploads_.health_.Attempt([&] { return uploads_.files_.Reopen(path, info_.offset); });
  }

  ~Writer() override {
    file_.reset();
    if (saving_ || (appended_ == info_.offset && !failed_)) return;
    try {
      uploads_.files_.Reopen(uploads_.DataOf(info_.id), info_.offset);
    } catch (const std::system_error&) {
      // What is too much is cut off when the upload is continued.
    }
  }

  void Append(std::string_view bytes) override {
    if (bytes.size() > info_.length - appended_) {
      throw Error(Code::kTooLarge, "the upload was announced with " + std::to_string(info_.length) +
                                       " bytes; this is more");
    }
    failed_ = true;
    uploads_.health_.Attempt([&] { file_->Append(bytes); });
    failed_ = false;
    appended_ += bytes.size();
    running_.hash.Update(bytes);
    running_.size += bytes.size();
    const std::uint64_t at_stake = appended_ - info_.offset;
    if (pieces_ == Pieces::kAnyPart && at_stake >= uploads_.limits_.checkpoint_bytes) KeepPart();
  }

  UploadInfo Keep() override {
    KeepPart();
    if (info_.is_whole()) return info_;
    uploads_.KeepRunning(info_.id, std::move(running_));
    return info_;
  }

 private:
  void KeepPart() {
    if (failed_) throw Error(Code::kInternal, "an upload was used after a fault");
    if (info_.is_whole()) return;
    uploads_.health_.Guard([&] { file_->Sync(); });
    UploadInfo kept = info_;
    kept.offset = appended_;
    kept.expires = Now() + uploads_.limits_.lifetime;
    if (kept.offset == kept.length) kept.sha256 = Hash();
    saving_ = true;
    uploads_.Save(kept);
    saving_ = false;
    info_ = std::move(kept);
  }

  std::string Hash() {
    if (running_.size == info_.length) return running_.hash.FinishHex();
    return Sha256OfFile(uploads_.DataOf(info_.id));  // a part came before the last restart
  }

  Uploads& uploads_;
  std::unique_ptr<Lock> lock_;
  UploadInfo info_;  // as kept
  Pieces pieces_;
  Running running_;
  std::uint64_t appended_;
  bool failed_ = false;
  bool saving_ = false;  // a fault then leaves open which state stands
  std::unique_ptr<OutputFile> file_;
};

class Uploads::Claimed final : public UploadClaim {
 public:
  Claimed(Uploads& uploads, std::unique_ptr<Lock> lock, UploadInfo info)
      : uploads_(uploads), lock_(std::move(lock)), info_(std::move(info)) {}

  const UploadInfo& info() const override { return info_; }
  fs::path path() const override {
    return is_blob() ? uploads_.blobs_.PathOf(info_.sha256) : uploads_.DataOf(info_.id);
  }
  Blob Adopt() override {
    const Blob blob{info_.sha256, info_.length};
    if (!is_blob()) uploads_.blobs_.Adopt(uploads_.DataOf(info_.id), blob);
    return blob;
  }

 private:
  bool is_blob() const { return !fs::exists(uploads_.DataOf(info_.id)); }

  Uploads& uploads_;
  std::unique_ptr<Lock> lock_;
  UploadInfo info_;
};

Uploads::Uploads(const fs::path& folder, Files& files, Health& health, BlobFolder& blobs,
                 const UploadLimits& limits)
    : folder_(folder / "uploads"), files_(files), health_(health), blobs_(blobs), limits_(limits) {
  files_.MakeFolder(folder_);
  files_.SyncFolder(folder);
  Sweep();
}

fs::path Uploads::FolderOf(const std::string& id) const {
  if (!IsUploadId(id)) throw NoUpload(id);
  return folder_ / id;
}

UploadInfo Uploads::Read(const std::string& id) const {
  UploadInfo info;
  try {
    info = FromText(id, ReadFile(FolderOf(id) / "state.json", kMaxStateBytes));
  } catch (const Error& error) {
    if (error.code() != Code::kNotFound) throw;
    throw NoUpload(id);
  } catch (const nlohmann::json::exception&) {
    throw NoUpload(id);
  }
  if (info.expires < Now()) throw NoUpload(id);
  std::error_code error;
  const std::uint64_t size = fs::file_size(DataOf(id), error);
  if (info.is_whole() && error) {
    blobs_.PathOf(info.sha256);  // it has become that blob
    return info;
  }
  info.offset = error ? 0 : std::min(info.offset, size);
  if (info.offset < info.length) info.sha256.clear();
  return info;
}

void Uploads::Save(const UploadInfo& info) {
  const fs::path folder = FolderOf(info.id);
  const fs::path fresh = folder / "state.new";
  const auto file = health_.Attempt([&] {
    files_.Remove(fresh);
    auto created = files_.Create(fresh);
    created->Append(ToText(info));
    return created;
  });
  health_.Guard([&] {
    file->Sync();
    files_.Rename(fresh, folder / "state.json");
    files_.SyncFolder(folder);
  });
}

UploadInfo Uploads::Create(std::uint64_t length, const std::string& metadata) {
  if (length > limits_.max_bytes) {
    throw Error(Code::kTooLarge, "an upload may have " + std::to_string(limits_.max_bytes) +
                                     " bytes, not " + std::to_string(length));
  }
  health_.Check();
  const std::lock_guard guard(create_mutex_);
  Sweep();
  CheckRoom(length);
  UploadInfo info;
  info.id = NewUploadId();
  info.length = length;
  info.metadata = metadata;
  info.expires = Now() + limits_.lifetime;
  if (length == 0) info.sha256 = Sha256Hex("");
  health_.Attempt([&] { files_.MakeFolder(FolderOf(info.id)); });
  const Lock lock(FolderOf(info.id), info.id);
  try {
    health_.Attempt([&] { files_.Create(DataOf(info.id)); });
    Save(info);
    health_.Guard([&] { files_.SyncFolder(folder_); });
  } catch (const Error&) {
    try {
      RemoveFolder(info.id);
    } catch (const std::system_error&) {
      // The next sweep, then.
    }
    throw;
  }
  return info;
}

void Uploads::CheckRoom(std::uint64_t length) const {
  std::size_t count = 1;
  std::uint64_t total = length;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    try {
      const UploadInfo other = Read(entry.path().filename().string());
      ++count;
      if (fs::exists(DataOf(other.id))) total += other.length;
    } catch (const Error&) {
      continue;  // going, or gone
    }
  }
  if (count <= limits_.max_count && total <= limits_.max_total_bytes) return;
  throw Error(Code::kUnavailable, count > limits_.max_count
                                      ? "there are " + std::to_string(limits_.max_count) +
                                            " uploads under way, as many as there may be"
                                      : "the uploads under way have no room for " +
                                            std::to_string(length) + " bytes more")
      .WithHint("finish or remove one (DELETE), or wait until one expires");
}

UploadInfo Uploads::Find(const std::string& id) const { return Read(id); }

std::unique_ptr<UploadWriter> Uploads::Continue(const std::string& id, std::uint64_t offset,
                                                Pieces pieces) {
  health_.Check();
  auto lock = std::make_unique<Lock>(FolderOf(id), id);
  UploadInfo info = Read(id);
  if (offset != info.offset) {
    throw Error(Code::kConflict, "the upload has " + std::to_string(info.offset) +
                                     " bytes; it cannot be continued at " + std::to_string(offset))
        .WithHint("ask for its offset (HEAD) and continue there");
  }
  if (info.is_whole()) throw Error(Code::kConflict, "the upload is whole already");
  return std::make_unique<Writer>(*this, std::move(lock), std::move(info), pieces);
}

std::unique_ptr<UploadClaim> Uploads::Claim(const std::string& id) {
  auto lock = std::make_unique<Lock>(FolderOf(id), id);
  UploadInfo info = Read(id);
  if (!info.is_whole()) {
    throw Error(Code::kConflict, "the upload is not whole: it has " + std::to_string(info.offset) +
                                     " of " + std::to_string(info.length) + " bytes");
  }
  return std::make_unique<Claimed>(*this, std::move(lock), std::move(info));
}

void Uploads::Remove(const std::string& id) {
  const Lock lock(FolderOf(id), id);
  Read(id);
  health_.Attempt([&] { RemoveFolder(id); });
}

// The state first: without it there is no upload, whatever else is left.
void Uploads::RemoveFolder(const std::string& id) {
  {
    const std::lock_guard guard(running_mutex_);
    running_.erase(id);
  }
  const fs::path folder = FolderOf(id);
  for (const char* name : {"state.json", "state.new", "data", "lock"}) files_.Remove(folder / name);
  try {
    files_.Remove(folder);
  } catch (const std::system_error&) {
    // Somebody has just tried to lock it: what is left is removed the next time.
  }
}

void Uploads::Sweep() {
  std::vector<std::string> ids;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    ids.push_back(entry.path().filename().string());
  }
  for (const std::string& id : ids) {
    try {
      const Lock lock(FolderOf(id), id);
      try {
        Read(id);
      } catch (const Error& error) {
        if (error.code() == Code::kNotFound) RemoveFolder(id);
      }
    } catch (const Error&) {              // in use, or nothing of ours
    } catch (const std::system_error&) {  // the next time, then
    }
  }
}

Uploads::Running Uploads::TakeRunning(const UploadInfo& info) {
  const std::lock_guard guard(running_mutex_);
  const auto found = running_.find(info.id);
  if (found == running_.end()) return {};
  Running running = std::move(found->second);
  running_.erase(found);
  return running.size == info.offset ? std::move(running) : Running{};
}

void Uploads::KeepRunning(const std::string& id, Running running) {
  const std::lock_guard guard(running_mutex_);
  if (running_.size() < limits_.max_count) running_.insert_or_assign(id, std::move(running));
}

}  // namespace lares::store
