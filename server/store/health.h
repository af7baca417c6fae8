// Whether the store still accepts writes. After a failed sync, rename or write of the database
// nothing is known about what the disk holds of it, so the first such fault ends writing until the
// store is opened again. What fails before anything rests on it fails alone; a disk that is full
// then stops writing until there is room again.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <system_error>

#include "base/error.h"

namespace lares::store {

// All members are thread-safe.
class Health {
 public:
  // Throws kUnavailable with the reason when writing has ended.
  void Check() const;
  // The first reason stays.
  void Fail(const std::string& reason);
  std::string reason() const;  // empty while writes are accepted

  // How it is found out, once there was no room, that there is some again; without it nothing
  // stops.
  void WatchRoom(std::function<bool()> has_room);

  // Runs `write`. A fault of the storage in it ends writing and comes out as kUnavailable; refusals
  // (kInvalid, kPreconditionFailed, …) pass through.
  template <typename Write>
  auto Guard(Write write) {
    try {
      return write();
    } catch (const std::system_error& error) {
      throw Judge(error);
    } catch (const Error& error) {
      throw Judge(error);
    }
  }

  // Runs `write`, on which nothing rests yet: its fault comes out as kUnavailable and ends nothing.
  template <typename Write>
  auto Attempt(Write write) {
    Check();
    try {
      return write();
    } catch (const std::system_error& error) {
      throw Refusal(error);
    }
  }

 private:
  Error Refusal(const std::system_error& error);
  Error Judge(const std::system_error& error);
  Error Judge(const Error& error);

  mutable std::mutex mutex_;
  std::string reason_;
  mutable std::string full_;  // why there was no room; empty: there is
  std::function<bool()> has_room_;
};

}  // namespace lares::store
