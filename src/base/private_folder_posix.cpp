#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "private_folder.h"

namespace roomgen {

namespace fs = std::filesystem;

namespace {

constexpr ::mode_t mine_only = 0700;

// Ours, no link, and closed to others: a name in a folder that all may write can be taken by anybody.
bool is_private(const fs::path& folder) {
  struct ::stat status{};
  return ::lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
         status.st_uid == ::geteuid() && (status.st_mode & 077) == 0;
}

}  // namespace

bool may_write_below(const fs::path& folder) {
  std::error_code failed;
  fs::path nearest = folder;
  while (!fs::exists(nearest, failed) && nearest.has_relative_path()) nearest = nearest.parent_path();
  if (!fs::is_directory(nearest, failed) || ::access(nearest.c_str(), W_OK | X_OK) != 0) return false;
  if (nearest == folder) return true;
  // The system's own file systems (/proc) say yes to root and make nothing.
  std::string trial = (nearest / ".roomgen-XXXXXX").string();
  return ::mkdtemp(trial.data()) && ::rmdir(trial.c_str()) == 0;
}

Result<fs::path> private_folder(const std::string& name) {
  std::error_code failed;
  const fs::path temporary = fs::temp_directory_path(failed);
  if (failed) return Error{Error::Kind::io, "there is no folder for temporary files: " + failed.message()};
  const fs::path usual = temporary / (name + "-" + std::to_string(::geteuid()));
  ::mkdir(usual.c_str(), mine_only);
  if (is_private(usual)) return usual;
  std::string fresh = (temporary / (name + "-XXXXXX")).string();
  if (::mkdtemp(fresh.data())) return fs::path(fresh);
  return Error{Error::Kind::io, fresh + ": " + std::strerror(errno)};
}

}  // namespace roomgen
