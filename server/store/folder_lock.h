// One process at a time in one folder.
#pragma once

#include <chrono>
#include <filesystem>

namespace lares::store {

// Held from construction to destruction; the system lets go of it when the process dies, however
// it dies. The file stays and carries the holder's process id.
class FolderLock {
 public:
  // Throws kConflict, with a hint naming the process, when it is held and stays so for `patience`;
  // kIo when it cannot be made.
  explicit FolderLock(const std::filesystem::path& file, std::chrono::milliseconds patience = {});
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int fd_;
};

}  // namespace lares::store
