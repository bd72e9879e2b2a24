#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

#ifdef ROOMGEN_HAS_SECCOMP
#include <seccomp.h>
#endif

#include "confinement.h"

namespace roomgen::decode {

namespace {

constexpr ::rlim_t most_memory = ::rlim_t{1536} << 20;
constexpr ::rlim_t most_stack = ::rlim_t{16} << 20;
// Of the process, which reads many meshes: who asks looks after the time of each (decoder.h). This ends one
// that nobody looks after any more.
constexpr ::rlim_t most_seconds = 3600;

bool limit(int resource, ::rlim_t most) {
  const ::rlimit bound{most, most};
  return ::setrlimit(static_cast<::__rlimit_resource>(resource), &bound) == 0;
}

// Sanitizers want terabytes of addresses.
bool limit_memory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return false;
#else
  return limit(RLIMIT_AS, most_memory);
#endif
}

bool set_limits() {
  bool all = limit_memory();
  all &= limit(RLIMIT_STACK, most_stack);
  all &= limit(RLIMIT_CPU, most_seconds);
  all &= limit(RLIMIT_FSIZE, 0);
  all &= limit(RLIMIT_CORE, 0);
  return all;
}

// A ruleset that handles all that can be done with files and allows nothing (Linux 5.13).
bool close_files() {
  ::landlock_ruleset_attr rules{};
  rules.handled_access_fs = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
  const auto ruleset =
      static_cast<int>(::syscall(SYS_landlock_create_ruleset, &rules, sizeof rules.handled_access_fs, 0));
  if (ruleset < 0) return false;
  const bool held = ::syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
  ::close(ruleset);
  return held;
}

#ifdef ROOMGEN_HAS_SECCOMP
// All others fail with EPERM, so that a library that looks for a file goes on without it.
bool filter_calls() {
  ::scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_ERRNO(EPERM));
  if (!filter) return false;
  bool good = true;
  for (const int call :
       {SCMP_SYS(read), SCMP_SYS(write), SCMP_SYS(readv), SCMP_SYS(writev), SCMP_SYS(close), SCMP_SYS(lseek),
        SCMP_SYS(brk), SCMP_SYS(mmap), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(mprotect),
        SCMP_SYS(madvise), SCMP_SYS(futex), SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask),
        SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack), SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday),
        SCMP_SYS(getrandom), SCMP_SYS(getpid), SCMP_SYS(gettid), SCMP_SYS(tgkill), SCMP_SYS(sched_yield),
        SCMP_SYS(fstat), SCMP_SYS(exit), SCMP_SYS(exit_group)})
    good &= ::seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0) == 0;
  good = good && ::seccomp_load(filter) == 0;
  ::seccomp_release(filter);
  return good;
}
#else
bool filter_calls() { return false; }
#endif

}  // namespace

std::string confine() {
  std::string held;
  ::close_range(STDERR_FILENO + 1, ~0u, 0);
  const bool alone = ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
  if (set_limits()) held += "limits ";
  if (alone && close_files()) held += "files ";
  if (alone && filter_calls()) held += "calls ";
  return held;
}

}  // namespace roomgen::decode
