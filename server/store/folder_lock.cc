#include "server/store/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <thread>

#include "base/error.h"
#include "base/text.h"

namespace lares::store {
namespace {

constexpr std::size_t kIdWidth = 20;

std::string HolderOf(int fd) {
  char text[32] = {};
  const ssize_t count = ::pread(fd, text, sizeof text - 1, 0);
  return count > 0 ? std::string(Trim(text)) : "";
}

Error Held(const std::filesystem::path& file, const std::string& holder) {
  const std::string folder = file.parent_path().string();
  return Error(Code::kConflict, "the store in '" + folder + "' is open in another process")
      .WithHint("stop process " + (holder.empty() ? "(unknown)" : holder) +
                ", or use another folder");
}

// errno says why not.
bool TryLock(int fd, std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds kStep{20};
  while (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK || patience <= std::chrono::milliseconds::zero()) return false;
    std::this_thread::sleep_for(kStep);
    patience -= kStep;
    errno = EWOULDBLOCK;
  }
  return true;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& file, std::chrono::milliseconds patience)
    : fd_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (fd_ < 0) {
    throw Error(Code::kIo, "cannot open '" + file.string() + "': " + std::strerror(errno));
  }
  if (!TryLock(fd_, patience)) {
    const int error = errno;
    const std::string holder = HolderOf(fd_);
    ::close(fd_);
    if (error == EWOULDBLOCK) throw Held(file, holder);
    throw Error(Code::kIo, "cannot lock '" + file.string() + "': " + std::strerror(error));
  }
  // The id only serves the hint of others: a full disk does not prevent opening for reading.
  std::string id = std::to_string(::getpid());
  id.resize(kIdWidth, ' ');  // over a longer one
  id += '\n';
  if (::pwrite(fd_, id.data(), id.size(), 0) < 0) errno = 0;
}

FolderLock::~FolderLock() { ::close(fd_); }

}  // namespace lares::store
