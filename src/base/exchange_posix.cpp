#include "exchange.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <system_error>

namespace roomgen::detail {

namespace fs = std::filesystem;

namespace {

bool is_same(const struct ::stat& a, const struct ::stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

// Is the working folder this one, or inside it?
bool holds_working_folder(const struct ::stat& folder) {
  std::error_code code;
  struct ::stat at{};
  for (fs::path path = fs::current_path(code); !code; path = path.parent_path()) {
    if (::stat(path.c_str(), &at) == 0 && is_same(at, folder)) return true;
    if (path == path.parent_path()) return false;
  }
  return false;
}

}  // namespace

bool exchange(const fs::path& a, const fs::path& b) {
#ifdef RENAME_EXCHANGE
  return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
  return false;
#endif
}

bool is_exchangeable(const fs::path& folder) {
  struct ::stat own{}, above{};
  if (::stat(folder.c_str(), &own) != 0 || ::stat((folder / "..").c_str(), &above) != 0) return false;
  return own.st_dev == above.st_dev && own.st_ino != above.st_ino && own.st_uid == ::geteuid() &&
         !holds_working_folder(own);
}

bool take_over_mode(const fs::path& folder, const fs::path& other) {
  struct ::stat own{}, wanted{};
  if (::stat(folder.c_str(), &own) != 0 || ::stat(other.c_str(), &wanted) != 0) return false;
  return own.st_gid == wanted.st_gid && ::chmod(folder.c_str(), wanted.st_mode & 07777) == 0;
}

bool link_file(const fs::path& file, const fs::path& name) {
  return ::linkat(AT_FDCWD, file.c_str(), AT_FDCWD, name.c_str(), 0) == 0;
}

Descriptor lock_folder(const fs::path& folder) {
  Descriptor descriptor(
      ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (descriptor && ::flock(descriptor.number(), LOCK_EX | LOCK_NB) != 0) return Descriptor();
  return descriptor;
}

void keep_on_disk(const fs::path& file_or_folder) {
  const fs::path& path = file_or_folder.empty() ? fs::path(".") : file_or_folder;
  const Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  if (descriptor) (void)::fsync(descriptor.number());
}

}  // namespace roomgen::detail
