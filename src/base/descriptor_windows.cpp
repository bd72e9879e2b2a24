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
