// A program that this is loaded into before its libraries has a call that fails: LD_PRELOAD=…/libfailing_calls.so
// ROOMGEN_FAILS="write 3" (or "write 3 lasting"). Whether it came to that is told by the file ROOMGEN_FAILED.
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>

#include "failing_calls.h"

namespace {

std::optional<FailingCalls> failing;
std::string mark;

// By the kernel's own call, since those of the C library may be the ones that fail.
void leave_mark() {
  if (mark.empty()) return;
  const long file = ::syscall(SYS_openat, AT_FDCWD, mark.c_str(), O_WRONLY | O_CREAT, 0600);
  if (file >= 0) ::syscall(SYS_close, file);
}

void begin() {
  const char* wanted = std::getenv("ROOMGEN_FAILS");
  std::istringstream words(wanted ? wanted : "");
  std::string what, how;
  std::size_t n = 0;
  if (!(words >> what >> n)) return;
  words >> how;
  when_a_call_fails = leave_mark;
  if (const char* named = std::getenv("ROOMGEN_FAILED")) mark = named;
  ::unsetenv("ROOMGEN_FAILS");  // not of what the program starts
  ::unsetenv("LD_PRELOAD");
  for (int call = 0; call <= static_cast<int>(Call::allocate); ++call)
    if (what == name(static_cast<Call>(call))) failing.emplace(static_cast<Call>(call), n, how == "lasting");
}

// As soon as it is loaded, after what stands above.
struct AtLoad {
  AtLoad() { begin(); }
};
const AtLoad at_load;

}  // namespace
