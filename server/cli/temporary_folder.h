// A folder of one's own that goes away again.
#pragma once

#include <filesystem>
#include <string>

namespace lares::cli {

class TemporaryFolder {
 public:
  // Below `parent`, readable by this user only. Throws kIo.
  TemporaryFolder(const std::filesystem::path& parent, const std::string& prefix);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace lares::cli
