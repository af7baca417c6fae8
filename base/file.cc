#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#include "base/error.h"

namespace lares {
namespace {

[[noreturn]] void ThrowErrno(const std::string& what, const std::filesystem::path& path) {
  const int error = errno;
  const Code code = error == ENOENT   ? Code::kNotFound
                    : error == ENOSPC ? Code::kUnavailable
                                      : Code::kIo;
  throw Error(code, what + " '" + path.string() + "': " + std::strerror(error));
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

void WriteAll(int fd, std::string_view bytes, const std::filesystem::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      ThrowErrno("cannot write", path);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

std::string ReadFile(const std::filesystem::path& path, std::uintmax_t max_bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) ThrowErrno("cannot open", path);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) ThrowErrno("cannot read", path);
  if (S_ISDIR(status.st_mode)) {
    throw Error(Code::kInvalid, "'" + path.string() + "' is a folder, not a file");
  }
  std::string bytes;
  if (status.st_size > 0) bytes.reserve(static_cast<std::size_t>(status.st_size));
  char buffer[1 << 16];
  for (;;) {
    const ssize_t count = ::read(file.get(), buffer, sizeof buffer);
    if (count < 0) {
      if (errno == EINTR) continue;
      ThrowErrno("cannot read", path);
    }
    if (count == 0) return bytes;
    if (bytes.size() + static_cast<std::size_t>(count) > max_bytes) {
      throw Error(Code::kTooLarge,
                  "'" + path.string() + "' is larger than " + std::to_string(max_bytes) + " bytes");
    }
    bytes.append(buffer, static_cast<std::size_t>(count));
  }
}

void SyncFolder(const std::filesystem::path& folder) {
  const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.get() < 0) ThrowErrno("cannot open folder", folder);
  if (::fsync(directory.get()) != 0) ThrowErrno("cannot sync folder", folder);
}

void WriteFileAtomically(const std::filesystem::path& path, std::string_view bytes) {
  static std::atomic<unsigned> counter{0};
  std::filesystem::path temporary = path;
  temporary += ".tmp" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
  try {
    const Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
    if (file.get() < 0) ThrowErrno("cannot create", temporary);
    WriteAll(file.get(), bytes, temporary);
    if (::fsync(file.get()) != 0) ThrowErrno("cannot sync", temporary);
    if (::rename(temporary.c_str(), path.c_str()) != 0) ThrowErrno("cannot rename to", path);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  const std::filesystem::path folder = path.parent_path();
  SyncFolder(folder.empty() ? "." : folder);
}

}  // namespace lares
