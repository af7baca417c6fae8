#include "server/store/health.h"

#include <cerrno>

namespace lares::store {
namespace {

Error Unavailable(const std::string& reason) {
  return Error(Code::kUnavailable, "the store accepts no writes: " + reason)
      .WithHint("mend the storage (space, disk, rights), then restart; reading goes on meanwhile");
}

}  // namespace

void Health::Check() const {
  const std::string why = reason();
  if (!why.empty()) throw Unavailable(why);
}

void Health::Fail(const std::string& reason) {
  const std::lock_guard lock(mutex_);
  if (reason_.empty()) reason_ = reason;
}

std::string Health::reason() const {
  const std::lock_guard lock(mutex_);
  if (!reason_.empty()) return reason_;
  if (!full_.empty() && (!has_room_ || has_room_())) full_.clear();
  return full_;
}

void Health::WatchRoom(std::function<bool()> has_room) {
  const std::lock_guard lock(mutex_);
  has_room_ = std::move(has_room);
}

Error Health::Refusal(const std::system_error& error) {
  const bool full = error.code() == std::errc::no_space_on_device ||
                    error.code() == std::errc::file_too_large || error.code().value() == EDQUOT;
  if (full) {
    const std::lock_guard lock(mutex_);
    full_ = error.what();
  }
  return Error(Code::kUnavailable,
               std::string(full ? "there is no room for these bytes: " : "cannot be stored: ") +
                   error.what())
      .WithHint(full ? "make room on the disk, then send it again; nothing of it was kept"
                     : "mend the storage, then send it again; nothing of it was kept");
}

Error Health::Judge(const std::system_error& error) {
  const bool passes = error.code() == std::errc::too_many_files_open ||
                      error.code() == std::errc::too_many_files_open_in_system;
  if (passes) return Error(Code::kUnavailable, error.what());
  Fail(error.what());
  return Unavailable(error.what());
}

Error Health::Judge(const Error& error) {
  if (error.code() != Code::kIo && error.code() != Code::kUnavailable) return error;
  Fail(error.what());
  return Unavailable(error.what());
}

}  // namespace lares::store
