// The folder of blobs: blobs/ab/cdef… named by SHA-256, written in incoming/ first.
#pragma once

#include <bitset>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "server/store/files.h"
#include "server/store/folder_lock.h"
#include "server/store/health.h"
#include "server/store/store.h"

namespace lares::store {

// Where a blob lies, or would lie, below the store's folder. `sha256`: IsSha256Hex.
std::filesystem::path BlobPlace(const std::filesystem::path& folder, const std::string& sha256);

// All members are thread-safe. A blob is never changed and never removed.
class BlobFolder {
 public:
  // kShared: other processes write to the same folder, each in a part of incoming/ of its own.
  enum class Use { kAlone, kShared };
  // Creates blobs/ and incoming/ in `folder` and removes from incoming/ what nobody writes any
  // more.
  BlobFolder(const std::filesystem::path& folder, Files& files, Health& health,
             Use use = Use::kAlone);

  const std::filesystem::path& folder() const { return folder_; }
  std::unique_ptr<BlobWriter> New();
  Blob Put(std::string_view bytes);
  // The file at `path`, whole and synced, becomes the blob that its hash (which the caller vouches
  // for) names, and is no longer where it was: renamed where it can be, else copied in pieces.
  void Adopt(const std::filesystem::path& path, const Blob& blob);

  std::filesystem::path PathOf(const std::string& sha256) const;  // kNotFound
  std::uint64_t SizeOf(const std::string& sha256) const;          // kNotFound
  std::string Read(const std::string& sha256) const;

  // Makes sure that a blob found here is also there after a power cut: one that was renamed just
  // before a crash may be visible without being durable.
  void MakeDurable(const std::string& sha256);

  // One sentence for each file that is not what its name says.
  std::vector<std::string> Verify() const;

 private:
  class Writer;
  std::filesystem::path Place(const std::string& sha256) const;
  void TakePartOfIncoming();
  void CopyIn(const std::filesystem::path& path, const Blob& blob);
  // The blob's sub-folder, itself durable.
  void PrepareSubfolder(const std::string& sha256);

  std::filesystem::path folder_;
  std::filesystem::path blobs_;
  std::filesystem::path incoming_;
  std::unique_ptr<FolderLock> part_;  // held while this process writes to its part of incoming/
  Files& files_;
  Health& health_;
  std::mutex mutex_;
  std::bitset<256> prepared_;  // sub-folders synced by this process
  std::uint64_t next_name_ = 0;
};

}  // namespace lares::store
