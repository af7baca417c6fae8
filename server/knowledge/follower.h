// Follows what other servers of a shared store change.
#pragma once

#include <chrono>
#include <thread>

#include "server/knowledge/knowledge.h"

namespace lares::server {

// Looks for another revision of the store every `period`, and then takes over what changed of the
// catalogue and tells of it. Does nothing for a store that is this process's alone. While the store
// cannot be reached it goes on looking. `knowledge` must outlive it.
class Follower {
 public:
  explicit Follower(Knowledge& knowledge,
                    std::chrono::milliseconds period = std::chrono::milliseconds(250));

 private:
  std::jthread thread_;
};

}  // namespace lares::server
