#include "server/store/blobs.h"

#include <fstream>
#include <optional>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"

namespace lares::store {
namespace {

namespace fs = std::filesystem;

Error NoBlob(const std::string& sha256) {
  return Error(Code::kNotFound, "there is no blob '" + sha256.substr(0, 80) + "'");
}

}  // namespace

fs::path BlobPlace(const fs::path& folder, const std::string& sha256) {
  return folder / "blobs" / sha256.substr(0, 2) / sha256.substr(2);
}

// Appended bytes go straight to the file. After a failed write the file is gone and the writer is
// spent.
class BlobFolder::Writer final : public BlobWriter {
 public:
  Writer(BlobFolder& folder, fs::path path)
      : folder_(folder), path_(std::move(path)), file_(folder.files_.Create(path_)) {}

  ~Writer() override {
    if (!committed_) Drop();
  }

  void Append(std::string_view bytes) override {
    CheckOpen();
    try {
      folder_.health_.Attempt([&] { file_->Append(bytes); });
    } catch (const Error&) {
      Drop();
      throw;
    }
    hash_.Update(bytes);
    size_ += bytes.size();
  }

  Blob Commit() override {
    CheckOpen();
    folder_.health_.Check();
    Blob blob{hash_.FinishHex(), size_};
    const auto file = std::move(file_);
    folder_.health_.Guard([&] { file->Sync(); });
    folder_.PrepareSubfolder(blob.sha256);
    folder_.health_.Guard([&] { Move(blob.sha256); });
    return blob;
  }

  fs::path path() const override { return path_; }
  void Flush() override { CheckOpen(); }

 private:
  void CheckOpen() const {
    if (!file_) throw Error(Code::kInternal, "a blob was used after its commit or a fault");
  }

  void Drop() {
    file_.reset();
    try {
      folder_.files_.Remove(path_);
    } catch (const std::system_error&) {
      // The next opening empties the folder.
    }
  }

  // A blob that is there already is replaced by these same bytes: that also mends a damaged one.
  void Move(const std::string& sha256) {
    const fs::path place = folder_.Place(sha256);
    folder_.files_.Rename(path_, place);
    committed_ = true;
    folder_.files_.SyncFolder(place.parent_path());
    folder_.files_.SyncFolder(path_.parent_path());
  }

  BlobFolder& folder_;
  fs::path path_;
  std::unique_ptr<OutputFile> file_;
  Sha256 hash_;
  std::uint64_t size_ = 0;
  bool committed_ = false;
};

BlobFolder::BlobFolder(const fs::path& folder, Files& files, Health& health, Use use)
    : folder_(folder),
      blobs_(folder / "blobs"),
      incoming_(folder / "incoming"),
      files_(files),
      health_(health) {
  files_.MakeFolder(blobs_);
  files_.MakeFolder(incoming_);
  if (use == Use::kShared) {
    TakePartOfIncoming();
  } else {
    for (const fs::directory_entry& left : fs::directory_iterator(incoming_)) {
      files_.Remove(left.path());
    }
  }
  files_.SyncFolder(folder);
}

// One process at a time looks for parts that nobody holds, and takes a new one.
void BlobFolder::TakePartOfIncoming() {
  const FolderLock turn(incoming_ / "turn", std::chrono::seconds(10));
  for (const fs::directory_entry& entry : fs::directory_iterator(incoming_)) {
    if (!entry.is_directory()) continue;
    try {
      const FolderLock nobody(entry.path() / "lock");
      fs::remove_all(entry.path());
    } catch (const Error& error) {
      if (error.code() != Code::kConflict) throw;
    }
  }
  for (int number = 1; !part_; ++number) {
    const fs::path part = incoming_ / std::to_string(number);
    if (fs::exists(part)) continue;
    files_.MakeFolder(part);
    part_ = std::make_unique<FolderLock>(part / "lock");
    incoming_ = part;
  }
}

std::unique_ptr<BlobWriter> BlobFolder::New() {
  fs::path path;
  {
    const std::lock_guard lock(mutex_);
    path = incoming_ / std::to_string(++next_name_);
  }
  return health_.Attempt([&] { return std::make_unique<Writer>(*this, path); });
}

Blob BlobFolder::Put(std::string_view bytes) {
  const std::unique_ptr<BlobWriter> writer = New();
  writer->Append(bytes);
  return writer->Commit();
}

void BlobFolder::Adopt(const fs::path& path, const Blob& blob) {
  health_.Check();
  PrepareSubfolder(blob.sha256);
  const bool renamed = health_.Guard([&] {
    const fs::path place = Place(blob.sha256);
    try {
      files_.Rename(path, place);
    } catch (const std::system_error& error) {
      if (error.code() != std::errc::cross_device_link) throw;
      return false;
    }
    files_.SyncFolder(place.parent_path());
    files_.SyncFolder(path.parent_path());
    return true;
  });
  if (!renamed) CopyIn(path, blob);
}

void BlobFolder::CopyIn(const fs::path& path, const Blob& blob) {
  const std::unique_ptr<BlobWriter> writer = New();
  std::ifstream file(path, std::ios::binary);
  std::string buffer(1 << 20, '\0');
  while (file) {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    writer->Append(std::string_view(buffer.data(), static_cast<std::size_t>(file.gcount())));
  }
  if (!file.eof() || writer->Commit().sha256 != blob.sha256) {
    throw Error(Code::kIo, "'" + path.string() + "' cannot be read as it was written");
  }
  health_.Attempt([&] { files_.Remove(path); });
}

fs::path BlobFolder::Place(const std::string& sha256) const { return BlobPlace(folder_, sha256); }

fs::path BlobFolder::PathOf(const std::string& sha256) const {
  if (!IsSha256Hex(sha256)) throw NoBlob(sha256);
  fs::path place = Place(sha256);
  std::error_code error;
  if (!fs::is_regular_file(place, error)) throw NoBlob(sha256);
  return place;
}

std::uint64_t BlobFolder::SizeOf(const std::string& sha256) const {
  std::error_code error;
  const std::uint64_t size = fs::file_size(PathOf(sha256), error);
  if (error) throw Error(Code::kIo, "cannot read blob '" + sha256 + "': " + error.message());
  return size;
}

std::string BlobFolder::Read(const std::string& sha256) const {
  std::string bytes = ReadFile(PathOf(sha256));
  if (Sha256Hex(bytes) != sha256) {
    throw Error(Code::kIo, "blob '" + sha256 + "' is damaged: its bytes have another hash")
        .WithHint("put the same file again; that replaces the damaged one");
  }
  return bytes;
}

void BlobFolder::PrepareSubfolder(const std::string& sha256) {
  const auto number = static_cast<std::size_t>(std::stoi(sha256.substr(0, 2), nullptr, 16));
  {
    const std::lock_guard lock(mutex_);
    if (prepared_[number]) return;
  }
  const fs::path subfolder = Place(sha256).parent_path();
  health_.Attempt([&] { files_.MakeFolder(subfolder); });
  health_.Guard([&] {
    files_.SyncFolder(subfolder);
    files_.SyncFolder(blobs_);
  });
  const std::lock_guard lock(mutex_);
  prepared_[number] = true;
}

void BlobFolder::MakeDurable(const std::string& sha256) { PrepareSubfolder(sha256); }

std::vector<std::string> BlobFolder::Verify() const {
  std::vector<std::string> problems;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(blobs_)) {
    if (entry.is_directory()) continue;
    const std::string name =
        entry.path().parent_path().filename().string() + entry.path().filename().string();
    if (!IsSha256Hex(name) || Place(name) != entry.path()) {
      problems.push_back("'" + entry.path().string() + "' is no blob");
      continue;
    }
    try {
      if (Sha256OfFile(entry.path()) == name) continue;
      problems.push_back("blob '" + name + "' is damaged: its bytes have another hash");
    } catch (const Error& error) {
      problems.push_back(error.what());
    }
  }
  return problems;
}

}  // namespace lares::store
