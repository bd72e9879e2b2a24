#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>

#include <algorithm>

#include "descriptor.h"

namespace roomgen::detail {

namespace {

constexpr int usual_mode = _S_IREAD | _S_IWRITE;
constexpr int writing = _O_WRONLY | _O_CREAT | _O_BINARY | _O_NOINHERIT;
constexpr std::size_t most_at_once = std::size_t{1} << 30;  // bytes; _write counts with an int

}  // namespace

Descriptor Descriptor::create(const std::filesystem::path& path) {
  return Descriptor(::_wopen(path.c_str(), writing | _O_EXCL, usual_mode));
}

Descriptor Descriptor::open_to_append(const std::filesystem::path& path) {
  return Descriptor(::_wopen(path.c_str(), writing | _O_APPEND, usual_mode));
}

bool Descriptor::is_file() const {
  return ::GetFileType(reinterpret_cast<HANDLE>(::_get_osfhandle(number_))) == FILE_TYPE_DISK;
}

// A byte far behind the end: Windows lets nobody read what is locked, not even the holder's other handles.
bool Descriptor::lock() const {
  OVERLAPPED place{};
  place.OffsetHigh = 0x40000000;
  return ::LockFileEx(reinterpret_cast<HANDLE>(::_get_osfhandle(number_)),
                      LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &place) != 0;
}

bool Descriptor::cut(std::size_t size) const {
  return ::_chsize_s(number_, static_cast<long long>(size)) == 0;
}

bool Descriptor::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    const auto part = static_cast<unsigned>(std::min(bytes.size(), most_at_once));
    const int count = ::_write(number_, bytes.data(), part);
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool Descriptor::sync() const {
  return ::_commit(number_) == 0;
}

bool Descriptor::close() {
  const int number = std::exchange(number_, -1);
  return number < 0 || ::_close(number) == 0;
}

}  // namespace roomgen::detail
