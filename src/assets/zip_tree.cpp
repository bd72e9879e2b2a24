#include <zip.h>

#include <algorithm>
#include <memory>
#include <mutex>

#include "base/relative_name.h"
#include "open_tree.h"

namespace roomgen::assets {

namespace {

struct CloseZip {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

// An open archive. libzip is not thread-safe, so that reads take turns.
class Zip {
 public:
  Zip(std::string path, zip_t* archive) : path_(std::move(path)), archive_(archive) {}

  Result<FileTree> list(const LogSink& sink) const;
  Result<std::string> read(const std::string& name) const;

 private:
  Error error(const std::string& name, const std::string& what) const {
    return {Error::Kind::invalid_input, path_ + ": " + name + ": " + what};
  }

  std::string path_;
  std::unique_ptr<zip_t, CloseZip> archive_;
  mutable std::mutex mutex_;
};

Result<FileTree> Zip::list(const LogSink& sink) const {
  const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
  if (count < 0 || static_cast<std::size_t>(count) > max_tree_files)
    return Error{Error::Kind::limit,
                 path_ + ": more than " + std::to_string(max_tree_files) + " entries"};
  FileTree tree;
  for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
    const char* raw = zip_get_name(archive_.get(), i, ZIP_FL_ENC_GUESS);
    const std::string name = raw ? raw : "";
    if (name.ends_with('/')) continue;
    if (stays_below(name))
      tree.names.push_back(name);
    else
      log(sink, LogLevel::warning, path_ + ": entry \"" + name + "\" leads outside; left out");
  }
  std::sort(tree.names.begin(), tree.names.end());
  tree.names.erase(std::unique(tree.names.begin(), tree.names.end()), tree.names.end());
  return tree;
}

Result<std::string> Zip::read(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_stat(archive_.get(), name.c_str(), 0, &stat) != 0)
    return Error{Error::Kind::not_found, path_ + ": has no entry " + name};
  // The declared size bounds the memory; an entry that holds more than it declares is broken.
  if (!(stat.valid & ZIP_STAT_SIZE) || stat.size > max_asset_bytes)
    return Error{Error::Kind::limit, path_ + ": " + name + ": larger than " +
                                         std::to_string(max_asset_bytes >> 20) + " MB"};
  const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen(archive_.get(), name.c_str(), 0));
  if (!file) return error(name, zip_strerror(archive_.get()));
  std::string bytes(stat.size, '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const zip_int64_t got = zip_fread(file.get(), bytes.data() + done, bytes.size() - done);
    if (got <= 0) return error(name, "broken or shorter than the archive says");
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

}  // namespace

Result<FileTree> open_zip(const std::filesystem::path& path, const LogSink& log) {
  int code = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_RDONLY, &code);
  if (!archive) {
    zip_error_t reason;
    zip_error_init_with_code(&reason, code);
    const std::string text = zip_error_strerror(&reason);
    zip_error_fini(&reason);
    return Error{code == ZIP_ER_NOENT ? Error::Kind::not_found : Error::Kind::invalid_input,
                 path.string() + ": not a readable archive (" + text + ")"};
  }
  const auto zip = std::make_shared<const Zip>(path.string(), archive);
  auto tree = zip->list(log);
  if (tree) tree->read = [zip](const std::string& name) { return zip->read(name); };
  return tree;
}

}  // namespace roomgen::assets
