#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/error.h"
#include "reasoner/prolog_worker/confinement.h"

namespace lares::prolog {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
#error "the numbers of this machine's system calls are not known here"
#endif

// Memory, clocks, and what is open already.
constexpr int kAllowed[] = {
    __NR_read,           __NR_write,         __NR_readv,        __NR_writev,
    __NR_lseek,          __NR_fstat,         __NR_close,        __NR_brk,
    __NR_munmap,         __NR_mremap,        __NR_madvise,      __NR_futex,
    __NR_sched_yield,    __NR_clock_gettime, __NR_clock_getres, __NR_clock_nanosleep,
    __NR_nanosleep,      __NR_gettimeofday,  __NR_getrusage,    __NR_times,
    __NR_getrandom,      __NR_getpid,        __NR_gettid,       __NR_rt_sigreturn,
    __NR_rt_sigprocmask, __NR_rt_sigaction,  __NR_sigaltstack,  __NR_restart_syscall,
    __NR_exit,           __NR_exit_group,
#ifdef __NR_time
    __NR_time,
#endif
};

// Nobody calls these by mistake.
constexpr int kDeadly[] = {
    __NR_execve,
    __NR_execveat,
    __NR_ptrace,
    __NR_process_vm_readv,
    __NR_process_vm_writev,
    __NR_bpf,
    __NR_kexec_load,
    __NR_init_module,
    __NR_finit_module,
    __NR_mount,
    __NR_reboot,
    __NR_userfaultfd,
    __NR_io_uring_setup,
};

using Program = std::vector<sock_filter>;

void Load(Program& program, std::size_t offset) {
  program.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)));
}

void Return(Program& program, std::uint32_t action) {
  program.push_back(BPF_STMT(BPF_RET | BPF_K, action));
}

// Returns `action` when the loaded word is `value`.
void ReturnIf(Program& program, std::uint32_t value, std::uint32_t action) {
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1));
  Return(program, action);
}

// For a call whose third argument is a protection: no memory that can be executed.
void AllowUnlessExecutable(Program& program, int call) {
  constexpr std::size_t kProtection = offsetof(seccomp_data, args) + 2 * sizeof(std::uint64_t);
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 4));
  Load(program, kProtection);  // the low word: both machines are little-endian
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, PROT_EXEC, 0, 1));
  Return(program, SECCOMP_RET_ERRNO | EPERM);
  Return(program, SECCOMP_RET_ALLOW);
}

Program MakeProgram() {
  Program program;
  Load(program, offsetof(seccomp_data, arch));
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 1, 0));
  Return(program, SECCOMP_RET_KILL_PROCESS);
  Load(program, offsetof(seccomp_data, nr));
  for (const int call : kAllowed) {
    ReturnIf(program, static_cast<std::uint32_t>(call), SECCOMP_RET_ALLOW);
  }
  for (const int call : kDeadly) {
    ReturnIf(program, static_cast<std::uint32_t>(call), SECCOMP_RET_KILL_PROCESS);
  }
  // The library falls back to clone(), which is then refused.
  ReturnIf(program, __NR_clone3, SECCOMP_RET_ERRNO | ENOSYS);
  AllowUnlessExecutable(program, __NR_mmap);
  AllowUnlessExecutable(program, __NR_mprotect);
  Return(program, SECCOMP_RET_ERRNO | EPERM);
  return program;
}

}  // namespace

void FilterSystemCalls() {
  Program program = MakeProgram();
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
      ::syscall(__NR_seccomp, SECCOMP_SET_MODE_FILTER, 0, &filter) != 0) {
    throw Error(Code::kUnavailable, "this system cannot confine a process to what it has open");
  }
}

}  // namespace lares::prolog
