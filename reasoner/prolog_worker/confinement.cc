#include "reasoner/prolog_worker/confinement.h"

#include <fcntl.h>
#include <grp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <string>

#include "base/error.h"

namespace lares::prolog {
namespace {

constexpr int kNiceness = 10;
constexpr unsigned kNobody = 65534;

void WriteToProc(const char* path, std::string_view text) {
  const int fd = ::open(path, O_WRONLY | O_CLOEXEC);
  if (fd < 0) return;
  [[maybe_unused]] const ssize_t written = ::write(fd, text.data(), text.size());
  ::close(fd);
}

// Others first, in whatever is scarce.
void StepBack() {
  [[maybe_unused]] const int niceness = ::nice(kNiceness);
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_BATCH, &none);
  WriteToProc("/proc/self/oom_score_adj", "1000");
}

void GiveUpRights() {
  ::unshare(CLONE_NEWNET);  // needs a right that not everybody has
  if (::geteuid() != 0) return;
  if (::setgroups(0, nullptr) != 0 || ::setresgid(kNobody, kNobody, kNobody) != 0 ||
      ::setresuid(kNobody, kNobody, kNobody) != 0) {
    throw Error(Code::kUnavailable, "a process for a goal cannot give up its rights");
  }
}

// Changing user ids undoes it, so it comes after that.
void DieWithParent() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::prctl(PR_SET_DUMPABLE, 0);
}

std::size_t MappedBytes() {
  std::FILE* file = std::fopen("/proc/self/statm", "re");
  if (file == nullptr) return 0;
  unsigned long pages = 0;
  const bool read = std::fscanf(file, "%lu", &pages) == 1;
  std::fclose(file);
  return read ? pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

void Limit(int resource, rlim_t value) {
  const rlimit limit{value, value};
  if (::setrlimit(static_cast<__rlimit_resource_t>(resource), &limit) != 0) {
    throw Error(Code::kUnavailable, "a process for a goal cannot be limited");
  }
}

void LimitAll(const Confinement& confinement) {
  const std::size_t mapped = MappedBytes();
  if (mapped == 0) throw Error(Code::kUnavailable, "a process for a goal cannot be measured");
  Limit(RLIMIT_CPU, static_cast<rlim_t>(confinement.cpu_s));
  Limit(RLIMIT_CORE, 0);
  Limit(RLIMIT_FSIZE, 0);
  Limit(RLIMIT_NOFILE, 0);
  Limit(RLIMIT_NPROC, 0);
  Limit(RLIMIT_MEMLOCK, 0);
#ifndef __SANITIZE_ADDRESS__  // which maps terabytes
  Limit(RLIMIT_AS, mapped + confinement.memory_bytes);
#endif
}

}  // namespace

void Confine(const Confinement& confinement) {
  StepBack();
  GiveUpRights();
  DieWithParent();
  LimitAll(confinement);
  FilterSystemCalls();
}

}  // namespace lares::prolog
