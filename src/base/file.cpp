#include "roomgen/base/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <utility>

namespace roomgen {

namespace fs = std::filesystem;

namespace {

Error io_error(const fs::path& path, const std::string& what) {
  return {Error::Kind::io, path.string() + ": " + what};
}

// Closes, and removes the file unless it was kept: an aborted write leaves nothing behind.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path)
      : path_(std::move(path)),
        descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) {
      ::close(descriptor_);
      ::unlink(path_.c_str());
    }
  }

  bool opened() const { return descriptor_ >= 0; }

  bool write(std::string_view bytes) {
    while (!bytes.empty()) {
      const auto count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }

  bool rename_to(const fs::path& target) {
    const int descriptor = std::exchange(descriptor_, -1);
    if (::close(descriptor) == 0 && std::rename(path_.c_str(), target.c_str()) == 0) return true;
    const int reason = errno;
    ::unlink(path_.c_str());
    errno = reason;
    return false;
  }

 private:
  fs::path path_;
  int descriptor_;
};

}  // namespace

Result<std::string> read_file(const fs::path& path, std::size_t max_bytes) {
  std::error_code code;
  if (!fs::exists(path, code))
    return Error{Error::Kind::not_found, path.string() + ": no such file"};
  if (!fs::is_regular_file(path, code)) return io_error(path, "not a regular file");
  const auto size = fs::file_size(path, code);
  if (code) return io_error(path, code.message());
  if (size > max_bytes)
    return Error{Error::Kind::limit, path.string() + ": " + std::to_string(size) +
                                         " bytes are more than the limit of " +
                                         std::to_string(max_bytes)};
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(size, '\0');
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    return io_error(path, std::string("cannot read: ") + std::strerror(errno));
  return bytes;
}

Status make_folder(const std::filesystem::path& path) {
  std::error_code code;
  std::filesystem::create_directories(path, code);
  if (!code) return {};
  return Error{Error::Kind::io, path.string() + ": cannot make the folder: " + code.message()};
}

Status write_file(const fs::path& path, std::string_view bytes) {
  fs::path aside = path;
  aside += ".part";
  TemporaryFile file(aside);
  if (!file.opened() || !file.write(bytes) || !file.rename_to(path))
    return io_error(path, std::string("cannot write: ") + std::strerror(errno));
  return {};
}

}  // namespace roomgen
