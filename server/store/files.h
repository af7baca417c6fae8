// The operations of the store that change files, as one small interface: the seam at which tests
// let a disk fail. (SQLite's own files have their seam in SQLite: a VFS, see sqlite_store.h.)
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

namespace lares::store {

// A file that is written to its end; closed by the destructor.
class OutputFile {
 public:
  virtual ~OutputFile() = default;
  virtual void Append(std::string_view bytes) = 0;
  virtual void Sync() = 0;
};

// All members may be called from any thread and throw std::system_error naming the path.
class Files {
 public:
  virtual ~Files() = default;
  virtual std::unique_ptr<OutputFile> Create(const std::filesystem::path& path) = 0;  // absent yet
  // One that is there, cut to `size` bytes; a shorter one is a fault.
  virtual std::unique_ptr<OutputFile> Reopen(const std::filesystem::path& path,
                                             std::uint64_t size) = 0;
  virtual void Rename(const std::filesystem::path& from, const std::filesystem::path& to) = 0;
  virtual void Remove(const std::filesystem::path& path) = 0;      // absence is no fault
  virtual void MakeFolder(const std::filesystem::path& path) = 0;  // existence is no fault
  // Makes the names in a folder durable.
  virtual void SyncFolder(const std::filesystem::path& path) = 0;
};

// The machine's own file system.
Files& RealFiles();

}  // namespace lares::store
