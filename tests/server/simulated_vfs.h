// A SQLite VFS whose changing operations are somebody else's to allow; all else is SQLite's own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace lares::store::testing {

// Members that fail throw std::system_error.
class SqliteFile {
 public:
  virtual ~SqliteFile() = default;
  virtual std::size_t Write(std::uint64_t offset, std::string_view bytes) = 0;  // how many
  virtual void Truncate(std::uint64_t size) = 0;
  virtual void Sync() = 0;
};

class SqliteFiles {
 public:
  virtual ~SqliteFiles() = default;
  virtual std::unique_ptr<SqliteFile> Open(const std::filesystem::path& path) = 0;
  virtual void SyncFolder(const std::filesystem::path& path) = 0;
  virtual void Remove(const std::filesystem::path& path) = 0;
  virtual int error() const = 0;  // the errno of a write that was cut short
};

// The name of a VFS that asks `files`, which must outlive it.
std::string Register(SqliteFiles& files);
void Unregister(const std::string& name);

}  // namespace lares::store::testing
