// A program that this is loaded into before its libraries has a call that fails: LD_PRELOAD=…/libfailing_calls.so
// ROOMGEN_FAILS="write 3" (or "write 3 lasting").
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>

#include "failing_calls.h"

namespace {

std::optional<FailingCalls> failing;

__attribute__((constructor)) void begin() {
  const char* wanted = std::getenv("ROOMGEN_FAILS");
  std::istringstream words(wanted ? wanted : "");
  std::string what, how;
  std::size_t n = 0;
  if (!(words >> what >> n)) return;
  words >> how;
  ::unsetenv("ROOMGEN_FAILS");  // not of what the program starts
  ::unsetenv("LD_PRELOAD");
  for (int call = 0; call <= static_cast<int>(Call::allocate); ++call)
    if (what == name(static_cast<Call>(call))) failing.emplace(static_cast<Call>(call), n, how == "lasting");
}

}  // namespace
