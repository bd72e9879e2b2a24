#include "scene_files.h"

#include <cerrno>
#include <cstring>
#include <memory>

#include "base/descriptor.h"
#include "base/exchange.h"
#include "roomgen/base/file.h"

namespace roomgen {

namespace fs = std::filesystem;

namespace {

Error journal_error(const fs::path& path, const std::string& what) {
  return {Error::Kind::io, path.string() + ": " + what};
}

Error system_error(const fs::path& path, const std::string& doing) {
  return journal_error(path, "cannot " + doing + ": " + std::strerror(errno));
}

/// An open journal that nobody else may edit.
class LockedJournal {
 public:
  static Result<std::shared_ptr<LockedJournal>> open(const fs::path& path) {
    std::error_code code;
    const bool is_new = !fs::exists(fs::symlink_status(path, code));
    detail::Descriptor file = detail::Descriptor::open_to_append(path);
    if (!file && errno == ELOOP)
      return journal_error(path, "is a link; name the scene beside the file that it leads to");
    if (!file) return system_error(path, "open");
    if (!file.is_file()) return journal_error(path, "is no regular file");
    if (!file.lock())
      return journal_error(path, "another program is editing this scene; try again when it is done");
    if (is_new) detail::keep_on_disk(path.parent_path().empty() ? fs::path(".") : path.parent_path());
    return std::make_shared<LockedJournal>(path, std::move(file));
  }

  LockedJournal(fs::path path, detail::Descriptor file) : path_(std::move(path)), file_(std::move(file)) {}

  Status append(std::string_view bytes) const {
    return file_.write(bytes) ? Status() : system_error(path_, "write");
  }
  Status sync() const {
    return file_.sync() ? Status() : system_error(path_, "keep on disk");
  }
  Status cut(std::size_t size) const {
    return file_.cut(size) ? Status() : system_error(path_, "cut");
  }

 private:
  fs::path path_;
  detail::Descriptor file_;
};

Result<std::string> read_journal_file(const fs::path& path) {
  auto bytes = read_file(path, max_journal_bytes);
  if (!bytes && bytes.error().kind == Error::Kind::not_found) return std::string();
  if (!bytes && bytes.error().kind == Error::Kind::limit)
    return Error{Error::Kind::limit, bytes.error().message + "; move it away, and its history begins anew"};
  return bytes;
}

}  // namespace

fs::path journal_of(const fs::path& scene_file) {
  fs::path path = scene_file;
  return path.replace_extension(".journal");
}

Result<SceneFiles> open_scene_files(const fs::path& scene_file, SceneAccess access) {
  const fs::path journal = journal_of(scene_file);
  SceneFiles files;
  files.scene_name = scene_file.string();
  files.journal_name = journal.string();
  files.read_scene = [scene_file] { return read_file(scene_file); };
  files.read_journal = [journal] { return read_journal_file(journal); };
  if (access == SceneAccess::look) {
    const auto refuse = [scene_file](auto&&...) -> Status {
      return journal_error(scene_file, "was opened for looking only");
    };
    files.write_scene = files.append = refuse;
    files.sync = refuse;
    files.cut = refuse;
    return files;
  }
  // A scene that is not there gets no journal.
  std::error_code code;
  if (!fs::exists(scene_file, code) && !fs::exists(journal, code))
    return Error{Error::Kind::not_found, scene_file.string() + ": no such file"};
  auto locked = LockedJournal::open(journal);
  if (!locked) return locked.error();
  files.write_scene = [scene_file](std::string_view bytes) { return write_file(scene_file, bytes); };
  files.append = [file = *locked](std::string_view bytes) { return file->append(bytes); };
  files.sync = [file = *locked] { return file->sync(); };
  files.cut = [file = *locked](std::size_t size) { return file->cut(size); };
  return files;
}

}  // namespace roomgen
