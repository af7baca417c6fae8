#include "base/aside.h"

#include <sys/resource.h>

#include <exception>
#include <thread>

namespace lares {
namespace {

constexpr int kNiceness = 15;

}  // namespace

void GiveWay() { ::setpriority(PRIO_PROCESS, 0, kNiceness); }  // 0: this thread

void RunAside(const std::function<void()>& work) {
  std::exception_ptr fault;
  std::thread thread([&] {
    GiveWay();
    try {
      work();
    } catch (...) {
      fault = std::current_exception();
    }
  });
  thread.join();
  if (fault) std::rethrow_exception(fault);
}

}  // namespace lares
