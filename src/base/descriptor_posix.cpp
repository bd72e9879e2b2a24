#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "descriptor.h"

namespace roomgen::detail {

namespace {

constexpr ::mode_t usual_mode = 0666;  // less what the user's umask takes away

}  // namespace

Descriptor Descriptor::create(const std::filesystem::path& path) {
  return Descriptor(
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, usual_mode));
}

Descriptor Descriptor::open_to_append(const std::filesystem::path& path) {
  return Descriptor(::open(path.c_str(),
                           O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC,
                           usual_mode));
}

bool Descriptor::is_file() const {
  struct ::stat status{};
  return ::fstat(number_, &status) == 0 && S_ISREG(status.st_mode);
}

bool Descriptor::lock() const {
  return ::flock(number_, LOCK_EX | LOCK_NB) == 0;
}

bool Descriptor::cut(std::size_t size) const {
  return ::ftruncate(number_, static_cast<::off_t>(size)) == 0;
}

bool Descriptor::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    const auto count = ::write(number_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool Descriptor::sync() const {
  return ::fsync(number_) == 0 || errno == EINVAL || errno == EROFS;
}

bool Descriptor::close() {
  const int number = std::exchange(number_, -1);
  return number < 0 || ::close(number) == 0;
}

}  // namespace roomgen::detail
