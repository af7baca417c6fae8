// One process at a time in one folder.
#pragma once

#include <filesystem>

namespace lares::store {

// Held from construction to destruction; the system lets go of it when the process dies, however
// it dies. The file stays and carries the holder's process id.
class FolderLock {
 public:
  // Throws kConflict, with a hint naming the process, when it is held; kIo when it cannot be made.
  explicit FolderLock(const std::filesystem::path& file);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int fd_;
};

}  // namespace lares::store
