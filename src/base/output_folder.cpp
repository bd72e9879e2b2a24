#include "roomgen/base/file.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "beside.h"
#include "exchange.h"

namespace roomgen {

namespace fs = std::filesystem;

namespace {

Error folder_error(const fs::path& folder, const std::string& what) {
  return {Error::Kind::io, folder.string() + ": " + what};
}

bool is_there(const fs::path& path) {
  std::error_code code;
  return fs::exists(fs::symlink_status(path, code));
}

// A folder and no link to one.
bool is_folder(const fs::path& path) {
  std::error_code code;
  return fs::is_directory(fs::symlink_status(path, code));
}

// The names in a folder; none if it cannot be read.
std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> names;
  std::error_code code;
  for (fs::directory_iterator at(folder, code), end; !code && at != end; at.increment(code))
    names.push_back(at->path().filename());
  return names;
}

// What killed runs left; what runs at work hold is locked.
void remove_left_overs(const fs::path& folder, const fs::path& where) {
  for (const auto& name : entries(where)) {
    const fs::path path = where / name;
    if (!detail::is_beside(folder, name) || !is_folder(path)) continue;
    const auto lock = detail::lock_folder(path);
    std::error_code code;
    if (lock) fs::remove_all(path, code);
  }
}

// The folder that is meant, by its own name.
Result<fs::path> without_links(const fs::path& folder) {
  std::error_code code;
  if (!is_there(folder)) {
    const fs::path named = fs::absolute(folder, code);  // fails where the working folder is gone
    const fs::path whole = code ? fs::path() : fs::weakly_canonical(named, code);
    if (code) return folder_error(folder, code.message());
    return whole.has_filename() ? whole : whole.parent_path();
  }
  const fs::path whole = fs::canonical(folder, code);
  if (code) return folder_error(folder, "leads nowhere: " + code.message());
  if (!fs::is_directory(whole, code)) return folder_error(folder, "exists and is not a folder");
  return whole;
}

}  // namespace

struct OutputFolder::Impl {
  fs::path shown;   // as the caller names it
  fs::path folder;  // without links
  fs::path stage;   // where everything is written; empty when all is done
  detail::Descriptor lock;
  Ours ours;
  bool is_new = false;
  bool is_exchanged = false;  // the new folder as a whole takes the place of the old one

  ~Impl() {
    std::error_code code;
    if (!stage.empty()) fs::remove_all(stage, code);
  }

  Status make_stage_in(const fs::path& where) {
    remove_left_overs(folder, where);
    const fs::path path = detail::name_beside(where / folder.filename());
    std::error_code code;
    if (!fs::create_directory(path, code) || code)
      return folder_error(shown, "cannot write: " + code.message());
    stage = path;
    lock = detail::lock_folder(stage);
    return {};
  }

  Status make_stage() {
    is_new = !is_there(folder);
    if (is_new) {
      if (auto status = make_folder(folder.parent_path()); !status) return status;
      return make_stage_in(folder.parent_path());
    }
    is_exchanged = detail::is_exchangeable(folder) && make_stage_in(folder.parent_path()) &&
                   detail::take_over_mode(stage, folder);
    if (is_exchanged) return {};
    std::error_code code;
    if (!stage.empty()) fs::remove_all(stage, code);
    return make_stage_in(folder);
  }

  bool is_ours(const fs::path& relative) const { return ours && ours(relative); }

  // Whether nothing but files, and true folders above them, stands where a result shall stand.
  Status check_name(const fs::path& relative) const {
    fs::path above;
    for (const auto& part : relative.parent_path())
      if (above /= part; is_there(folder / above) && !is_folder(folder / above))
        return folder_error(shown / above, "is no folder, or a link to one; remove it first");
    std::error_code code;
    const auto status = fs::symlink_status(folder / relative, code);
    if (fs::exists(status) && !fs::is_regular_file(status))
      return folder_error(shown / relative, "is no file, or a link to one; remove it first");
    return {};
  }

  // Gives all in the old folder that is not ours a place in the new one. False if something cannot have one.
  bool adopt(const fs::path& from, const fs::path& to, const fs::path& relative) const {
    for (const auto& name : entries(from / relative)) {
      const fs::path inside = relative / name;
      if (is_folder(from / inside)) {
        if (!adopt_folder(from, to, inside)) return false;
      } else if (!is_ours(inside) && !is_there(to / inside) &&
                 !detail::link_file(from / inside, to / inside)) {
        return false;
      }
    }
    return true;
  }

  bool adopt_folder(const fs::path& from, const fs::path& to, const fs::path& inside) const {
    if (detail::is_beside(folder, inside)) return true;
    std::error_code code;
    const bool is_made = fs::create_directory(to / inside, from / inside, code);
    if (code || !adopt(from, to, inside)) return false;
    if (is_made && is_ours(inside)) fs::remove(to / inside, code);  // if it is empty
    return true;
  }

  // Moves what was written over the old files.
  Status move(const fs::path& relative) const {
    std::error_code code;
    for (const auto& name : entries(stage / relative)) {
      const fs::path inside = relative / name;
      if (is_folder(stage / inside)) {
        fs::create_directory(folder / inside, code);
        if (auto status = move(inside); !status) return status;
        continue;
      }
      fs::rename(stage / inside, folder / inside, code);
      if (code) return folder_error(shown / inside, "cannot write: " + code.message());
    }
    detail::keep_on_disk(folder / relative);
    return {};
  }

  // Removes what is ours and was not written anew.
  void drop_old(const std::vector<fs::path>& written, const fs::path& relative) const {
    std::error_code code;
    for (const auto& name : entries(folder / relative)) {
      const fs::path inside = relative / name;
      if (!is_ours(inside)) continue;
      if (is_folder(folder / inside)) drop_old(written, inside);
      if (std::find(written.begin(), written.end(), inside) == written.end())
        fs::remove(folder / inside, code);  // folders if they are empty
    }
  }

  std::vector<fs::path> written() const {
    std::vector<fs::path> files;
    std::error_code code;
    for (fs::recursive_directory_iterator at(stage, code), end; !code && at != end; at.increment(code))
      files.push_back(at->path().lexically_relative(stage));
    return files;
  }

  // People do not know where it is written for now.
  Error by_final_name(Error error) const {
    const std::string now = stage.string();
    if (const auto at = error.message.find(now); at != std::string::npos) error.message.replace(at, now.size(), shown.string());
    return error;
  }

  Status put_in_place() {
    std::error_code code;
    fs::rename(stage, folder, code);
    if (code == std::errc::directory_not_empty || code == std::errc::file_exists)
      return folder_error(shown, "cannot write: somebody else has written it meanwhile; that is left as it is");
    if (code) return folder_error(shown, "cannot write: " + code.message());
    stage.clear();
    detail::keep_on_disk(folder.parent_path());
    return {};
  }

  bool exchange_whole() {
    if (!adopt(folder, stage, {})) return false;
    detail::keep_on_disk(stage);
    if (!detail::exchange(stage, folder)) return false;
    detail::keep_on_disk(folder.parent_path());
    (void)adopt(stage, folder, {});  // what came to the old one meanwhile
    return true;
  }

  Status commit() {
    if (is_new) return put_in_place();
    const auto files = written();
    if (is_exchanged && exchange_whole()) return {};
    std::error_code code;
    for (const auto& file : files)
      if (auto status = is_folder(stage / file) ? Status() : check_name(file); !status) return status;
    if (auto status = move({}); !status) return status;
    drop_old(files, {});
    return {};
  }
};

OutputFolder::OutputFolder(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
OutputFolder::OutputFolder(OutputFolder&&) noexcept = default;
OutputFolder& OutputFolder::operator=(OutputFolder&&) noexcept = default;
OutputFolder::~OutputFolder() = default;

Result<OutputFolder> OutputFolder::open(const fs::path& folder, Ours ours) {
  auto whole = without_links(folder);
  if (!whole) return whole.error();
  auto impl = std::make_unique<Impl>();
  impl->shown = folder;
  impl->folder = *std::move(whole);
  impl->ours = std::move(ours);
  if (auto status = impl->make_stage(); !status) return status.error();
  return OutputFolder(std::move(impl));
}

Status OutputFolder::write_with(const fs::path& relative, const Writer& writer) const {
  if (auto status = impl_->check_name(relative); !status) return status;
  const fs::path path = impl_->stage / relative;
  auto status = make_folder(path.parent_path());
  if (status) status = writer(path);
  return status ? status : Status(impl_->by_final_name(status.error()));
}

Status OutputFolder::write(const fs::path& relative, std::string_view bytes) const {
  return write_with(relative, [&](const fs::path& now) { return write_file(now, bytes); });
}

Status OutputFolder::commit() {
  return impl_->commit();
}

}  // namespace roomgen
