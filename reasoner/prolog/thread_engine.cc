#include "reasoner/prolog/thread_engine.h"

#include <SWI-Prolog.h>

#include <atomic>

#include "base/error.h"

namespace lares::prolog {
namespace {

std::atomic<int> live_engines{0};

class ThreadEngine {
 public:
  ThreadEngine() = default;
  ~ThreadEngine() { Drop(); }
  ThreadEngine(const ThreadEngine&) = delete;
  ThreadEngine& operator=(const ThreadEngine&) = delete;

  void Attach(std::size_t stack_limit) {
    if (is_attached_ && stack_limit == stack_limit_) return;
    Drop();
    PL_thread_attr_t attributes{};
    attributes.stack_limit = stack_limit;
    attributes.flags = PL_THREAD_NO_DEBUG;
    if (PL_thread_attach_engine(&attributes) < 0) {
      throw Error(Code::kUnavailable, "Prolog gives no further engine");
    }
    is_attached_ = true;
    stack_limit_ = stack_limit;
    ++live_engines;
  }

  void Drop() {
    if (!is_attached_) return;
    PL_thread_destroy_engine();
    is_attached_ = false;
    --live_engines;
  }

 private:
  bool is_attached_ = false;
  std::size_t stack_limit_ = 0;
};

thread_local ThreadEngine thread_engine;

}  // namespace

void AttachThreadEngine(std::size_t stack_limit_bytes) { thread_engine.Attach(stack_limit_bytes); }

void DropThreadEngine() { thread_engine.Drop(); }

int LiveThreadEngines() { return live_engines; }

}  // namespace lares::prolog
