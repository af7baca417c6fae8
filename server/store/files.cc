#include "server/store/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace lares::store {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void ThrowErrno(const char* what, const fs::path& path) {
  const int error = errno;
  throw std::system_error(error, std::generic_category(),
                          std::string(what) + " '" + path.string() + "'");
}

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

class RealOutputFile final : public OutputFile {
 public:
  explicit RealOutputFile(const fs::path& path)
      : path_(path), file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644)) {
    if (file_.get() < 0) ThrowErrno("cannot create", path_);
  }

  RealOutputFile(const fs::path& path, std::uint64_t size)
      : path_(path), file_(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)) {
    struct stat status {};
    if (file_.get() < 0 || ::fstat(file_.get(), &status) != 0) ThrowErrno("cannot open", path_);
    if (static_cast<std::uint64_t>(status.st_size) < size) {
      errno = EIO;
      ThrowErrno("is shorter than it was:", path_);
    }
    if (::ftruncate(file_.get(), static_cast<off_t>(size)) != 0) ThrowErrno("cannot cut", path_);
  }

  void Append(std::string_view bytes) override {
    while (!bytes.empty()) {
      const ssize_t written = ::write(file_.get(), bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) ThrowErrno("cannot write", path_);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void Sync() override {
    if (::fsync(file_.get()) != 0) ThrowErrno("cannot sync", path_);
  }

 private:
  fs::path path_;
  Descriptor file_;
};

class RealFilesImpl final : public Files {
 public:
  std::unique_ptr<OutputFile> Create(const fs::path& path) override {
    return std::make_unique<RealOutputFile>(path);
  }
  std::unique_ptr<OutputFile> Reopen(const fs::path& path, std::uint64_t size) override {
    return std::make_unique<RealOutputFile>(path, size);
  }
  void Rename(const fs::path& from, const fs::path& to) override {
    if (::rename(from.c_str(), to.c_str()) != 0) ThrowErrno("cannot rename to", to);
  }
  void Remove(const fs::path& path) override {
    if (::remove(path.c_str()) != 0 && errno != ENOENT) ThrowErrno("cannot remove", path);
  }
  void MakeFolder(const fs::path& path) override {
    if (::mkdir(path.c_str(), 0755) == 0) return;
    struct stat status {};
    if (errno == EEXIST && ::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) return;
    ThrowErrno("cannot make folder", path);
  }
  void SyncFolder(const fs::path& path) override {
    const Descriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.get() < 0) ThrowErrno("cannot open folder", path);
    if (::fsync(folder.get()) != 0) ThrowErrno("cannot sync folder", path);
  }
};

}  // namespace

Files& RealFiles() {
  static RealFilesImpl files;
  return files;
}

}  // namespace lares::store
