// Whether the store still accepts writes. After a failed write or sync nothing is known about what
// the disk holds of it, so the first such fault ends writing until the store is opened again.
#pragma once

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

 private:
  Error Judge(const std::system_error& error);
  Error Judge(const Error& error);

  mutable std::mutex mutex_;
  std::string reason_;
};

}  // namespace lares::store
