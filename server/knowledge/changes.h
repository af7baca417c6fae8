// Tells whoever wants to know that what is known has changed.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>

namespace lares::server {

// All members are thread-safe.
class Changes {
 public:
  // After a commit, or what follows from it in an overlay, has become visible: counts it and calls
  // the listeners, on the calling thread.
  void Notify();
  // How often that was; grows only.
  std::uint64_t generation() const { return generation_; }

  // `listener` must be quick and throw nothing. It is called until the token is dropped, which
  // waits for a call that is under way; the token may outlive this object.
  std::shared_ptr<void> Listen(std::function<void()> listener);

 private:
  struct Listeners {
    std::mutex mutex;
    std::map<std::uint64_t, std::function<void()>> by_number;
    std::uint64_t next = 0;
  };

  std::atomic<std::uint64_t> generation_{0};
  std::shared_ptr<Listeners> listeners_ = std::make_shared<Listeners>();
};

}  // namespace lares::server
