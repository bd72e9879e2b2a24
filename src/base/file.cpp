#include "roomgen/base/file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <mutex>
#include <set>
#include <utility>

#include "beside.h"
#include "descriptor.h"
#include "exchange.h"

namespace roomgen {

namespace fs = std::filesystem;

namespace {

using detail::Descriptor;

Error io_error(const fs::path& path, const std::string& what) {
  return {Error::Kind::io, path.string() + ": " + what};
}

Error write_error(const fs::path& path) {
  return io_error(path, std::string("cannot write: ") + std::strerror(errno));
}

// What a file may take the place of: nothing, or another file.
Status may_be_replaced(const fs::path& path) {
  std::error_code code;
  const auto status = fs::symlink_status(path, code);
  if (!fs::exists(status) || fs::is_regular_file(status)) return {};
  if (fs::is_symlink(status))
    return io_error(path, "cannot write: it is a link; name the file that it leads to");
  return io_error(path, fs::is_directory(status) ? "cannot write: it is a folder"
                                                 : "cannot write: it is no regular file");
}

// What killed runs left in a folder; what runs at work hold is locked. Once for each folder, since there may be thousands of files.
void remove_left_overs(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> done;
  const std::lock_guard lock(mutex);
  if (!done.insert(folder).second) return;
  std::error_code code;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, code), end; !code && at != end; at.increment(code)) {
    const fs::path path = at->path();
    if (!detail::is_beside_something(path) || !fs::is_regular_file(fs::symlink_status(path, code))) continue;
    const Descriptor held = Descriptor::open_to_append(path);
    if (held && held.lock()) fs::remove(path, code);
  }
}

// Removes the file unless it was kept: an aborted write leaves nothing behind.
class FileAside {
 public:
  explicit FileAside(const fs::path& target)
      : target_(target) {
    remove_left_overs(target.parent_path());
    // Between its making and the lock somebody may take it for a left-over.
    for (int attempt = 0; attempt < 3 && !is_there_; ++attempt) {
      path_ = detail::name_beside(target);
      descriptor_ = Descriptor::create(path_);
      std::error_code code;
      is_there_ = descriptor_ && (!descriptor_.lock() || fs::exists(path_, code));
      if (!descriptor_) return;
    }
  }
  FileAside(const FileAside&) = delete;
  FileAside& operator=(const FileAside&) = delete;
  ~FileAside() {
    std::error_code code;
    if (!is_there_) return;
    (void)descriptor_.close();  // Windows keeps what is open
    fs::remove(path_, code);
  }

  bool is_there() const { return is_there_; }
  const fs::path& path() const { return path_; }
  bool write(std::string_view bytes) const { return descriptor_.write(bytes); }

  bool take_its_place() {
    if (!descriptor_.sync() || !descriptor_.close()) return false;
    std::error_code code;
    fs::rename(path_, target_, code);
    if (code) {
      errno = code.default_error_condition().value();
      return false;
    }
    is_there_ = false;
    detail::keep_on_disk(target_.parent_path());
    return true;
  }

 private:
  const fs::path& target_;
  fs::path path_;
  Descriptor descriptor_;
  bool is_there_ = false;
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

Status make_folder(const fs::path& path) {
  std::error_code code;
  fs::create_directories(path, code);
  if (!code) return {};
  return io_error(path, "cannot make the folder: " + code.message());
}

Status write_file(const fs::path& path, std::string_view bytes) {
  if (auto status = may_be_replaced(path); !status) return status;
  FileAside aside(path);
  if (!aside.is_there() || !aside.write(bytes) || !aside.take_its_place()) return write_error(path);
  return {};
}

Status replace_file(const fs::path& path,
                    const std::function<Status(const fs::path& aside)>& write) {
  if (auto status = may_be_replaced(path); !status) return status;
  FileAside aside(path);
  if (!aside.is_there()) return write_error(path);
  if (auto status = write(aside.path()); !status) return status;
  return aside.take_its_place() ? Status() : write_error(path);
}

struct AppendedFile::Impl {
  fs::path path;
  Descriptor descriptor;
};

AppendedFile::AppendedFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
AppendedFile::AppendedFile(AppendedFile&&) noexcept = default;
AppendedFile& AppendedFile::operator=(AppendedFile&&) noexcept = default;
AppendedFile::~AppendedFile() = default;

Result<AppendedFile> AppendedFile::open(const fs::path& path) {
  if (auto status = may_be_replaced(path); !status) return status.error();
  Descriptor descriptor = Descriptor::open_to_append(path);
  if (!descriptor) return write_error(path);
  return AppendedFile(std::make_unique<Impl>(Impl{path, std::move(descriptor)}));
}

Status AppendedFile::append(std::string_view line) const {
  return impl_->descriptor.write(line) ? Status() : write_error(impl_->path);
}

}  // namespace roomgen
