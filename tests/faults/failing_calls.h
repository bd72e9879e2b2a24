#pragma once

#include <cstddef>

/// Calls of the operating system that fail when a test tells them to. failing_calls.cpp takes the place of the C library's
/// in a program that it is linked to, and in one that it is loaded into before (LD_PRELOAD).
enum class Call { write, sync, rename, exchange, link, make_folder, create, cut, allocate };

inline constexpr Call all_file_calls[] = {Call::write, Call::sync,        Call::rename, Call::exchange,
                                          Call::link,  Call::make_folder, Call::create, Call::cut};

const char* name(Call call);

/// Called whenever a call fails; may be null.
extern void (*when_a_call_fails)();

/// While it is there, the n-th such call of any thread fails, from 0 on; with `lasting` all later ones, too.
class FailingCalls {
 public:
  FailingCalls(Call call, std::size_t n, bool lasting = false);
  FailingCalls(const FailingCalls&) = delete;
  FailingCalls& operator=(const FailingCalls&) = delete;
  ~FailingCalls();

  /// Were there so many calls that one failed?
  bool has_failed() const;
};
