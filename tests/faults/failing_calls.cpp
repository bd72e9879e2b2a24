#include "failing_calls.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <new>

void (*when_a_call_fails)() = nullptr;

namespace {

struct Fault {
  std::atomic<int> call{-1};
  std::atomic<long long> calls_left{0};
  std::atomic<bool> lasting{false}, has_failed{false};
};
Fault fault;

// Is this the call that fails? errno says why it would in life.
bool fails(Call call, int reason) {
  if (fault.call != static_cast<int>(call)) return false;
  const long long left = fault.calls_left--;
  if (left > 0 || (left < 0 && !fault.lasting)) return false;
  fault.has_failed = true;
  if (when_a_call_fails) when_a_call_fails();
  errno = reason;
  return true;
}

// What a program says to a person or another program is not meant.
bool is_file(int descriptor) {
  struct ::stat status{};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

int open_file(const char* path, int flags, ::mode_t mode) {
  if ((flags & O_CREAT) != 0 && fails(Call::create, EMFILE)) return -1;
  return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

::mode_t mode_of(int flags, std::va_list rest) {
  return (flags & O_CREAT) != 0 ? static_cast<::mode_t>(va_arg(rest, int)) : 0;
}

}  // namespace

// Glibc's own names; what libraries of C++ call goes through them, too.
#define ROOMGEN_IN_PLACE extern "C" __attribute__((visibility("default")))

ROOMGEN_IN_PLACE ssize_t write(int descriptor, const void* bytes, std::size_t size) {
  if (is_file(descriptor) && fails(Call::write, ENOSPC)) return -1;
  return ::syscall(SYS_write, descriptor, bytes, size);
}

ROOMGEN_IN_PLACE ssize_t pwrite64(int descriptor, const void* bytes, std::size_t size, ::off64_t at) {
  if (fails(Call::write, ENOSPC)) return -1;
  return ::syscall(SYS_pwrite64, descriptor, bytes, size, at);
}

ROOMGEN_IN_PLACE ssize_t pwrite(int descriptor, const void* bytes, std::size_t size, ::off_t at) {
  return ::pwrite64(descriptor, bytes, size, at);
}

ROOMGEN_IN_PLACE int fsync(int descriptor) {
  return fails(Call::sync, EIO) ? -1 : static_cast<int>(::syscall(SYS_fsync, descriptor));
}

ROOMGEN_IN_PLACE int fdatasync(int descriptor) {
  return fails(Call::sync, EIO) ? -1 : static_cast<int>(::syscall(SYS_fdatasync, descriptor));
}

ROOMGEN_IN_PLACE int rename(const char* from, const char* to) noexcept {
  if (fails(Call::rename, EACCES)) return -1;
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

ROOMGEN_IN_PLACE int renameat2(int from_at, const char* from, int to_at, const char* to, unsigned flags) noexcept {
  if (fails(Call::exchange, EINVAL)) return -1;
  return static_cast<int>(::syscall(SYS_renameat2, from_at, from, to_at, to, flags));
}

ROOMGEN_IN_PLACE int linkat(int from_at, const char* from, int to_at, const char* to, int flags) noexcept {
  if (fails(Call::link, EMLINK)) return -1;
  return static_cast<int>(::syscall(SYS_linkat, from_at, from, to_at, to, flags));
}

ROOMGEN_IN_PLACE int mkdir(const char* path, ::mode_t mode) noexcept {
  if (fails(Call::make_folder, ENOSPC)) return -1;
  return static_cast<int>(::syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}

ROOMGEN_IN_PLACE int ftruncate(int descriptor, ::off_t size) noexcept {
  return fails(Call::cut, EIO) ? -1 : static_cast<int>(::syscall(SYS_ftruncate, descriptor, size));
}

ROOMGEN_IN_PLACE int open(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const auto mode = mode_of(flags, rest);
  va_end(rest);
  return open_file(path, flags, mode);
}

ROOMGEN_IN_PLACE int open64(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const auto mode = mode_of(flags, rest);
  va_end(rest);
  return open_file(path, flags, mode);
}

void* operator new(std::size_t size) {
  if (!fails(Call::allocate, ENOMEM))
    if (void* bytes = std::malloc(size > 0 ? size : 1)) return bytes;
  throw std::bad_alloc();
}

// All of a kind, or memory of the sanitizer's own operators would be freed by these.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return fails(Call::allocate, ENOMEM) ? nullptr : std::malloc(size > 0 ? size : 1);
}

void operator delete(void* bytes) noexcept { std::free(bytes); }
void operator delete(void* bytes, std::size_t) noexcept { std::free(bytes); }

const char* name(Call call) {
  constexpr const char* names[] = {"write", "sync", "rename", "exchange", "link", "make_folder", "create", "cut", "allocate"};
  return names[static_cast<int>(call)];
}

FailingCalls::FailingCalls(Call call, std::size_t n, bool lasting) {
  fault.lasting = lasting;
  fault.has_failed = false;
  fault.calls_left = static_cast<long long>(n);
  fault.call = static_cast<int>(call);
}

FailingCalls::~FailingCalls() { fault.call = -1; }

bool FailingCalls::has_failed() const { return fault.has_failed; }
