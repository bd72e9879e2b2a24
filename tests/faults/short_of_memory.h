#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <new>

#include "failing_calls.h"

/// Does the work in a process of its own whose n-th allocation fails: libraries below ours (of JSON, of folders) end a
/// process that is out of memory. Did an allocation fail?
template <typename Work>
bool run_short_of_memory(std::size_t n, Work work) {
  const ::pid_t child = ::fork();
  if (child == 0) {
    for (const int signal : {SIGSEGV, SIGABRT}) std::signal(signal, SIG_DFL);
    // Closed, it would be the first file that is opened, and what a dying process says would go into that.
    if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
    bool has_failed = true;
    try {
      const FailingCalls failing(Call::allocate, n);
      work();
      has_failed = failing.has_failed();
    } catch (const std::bad_alloc&) {
    }
    ::_exit(has_failed ? 1 : 0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return !WIFEXITED(status) || WEXITSTATUS(status) != 0;
}
