#include <algorithm>

#include "base/relative_name.h"
#include "open_tree.h"
#include "roomgen/base/file.h"

namespace roomgen::assets {

namespace fs = std::filesystem;

Result<FileTree> open_folder(const fs::path& path) {
  std::error_code code;
  const fs::path root = fs::canonical(path, code);
  if (code || !fs::is_directory(root, code))
    return Error{Error::Kind::not_found, path.string() + ": no such folder"};
  FileTree tree;
  auto entry =
      fs::recursive_directory_iterator(root, fs::directory_options::skip_permission_denied, code);
  for (; !code && entry != fs::recursive_directory_iterator(); entry.increment(code)) {
    std::error_code ignored;
    if (!entry->is_regular_file(ignored)) continue;
    if (entry->is_symlink(ignored)) {
      const std::string target = fs::canonical(entry->path(), ignored).string();
      if (ignored || !target.starts_with(root.string() + "/")) continue;
    }
    std::string name = entry->path().lexically_relative(root).generic_string();
    if (stays_below(name)) tree.names.push_back(std::move(name));
    if (tree.names.size() > max_tree_files)
      return Error{Error::Kind::limit,
                   path.string() + ": more than " + std::to_string(max_tree_files) + " files"};
  }
  if (code) return Error{Error::Kind::io, path.string() + ": " + code.message()};
  std::sort(tree.names.begin(), tree.names.end());
  tree.read = [root](const std::string& name) -> Result<std::string> {
    if (!stays_below(name)) return Error{Error::Kind::invalid_input, name + ": leads outside"};
    return read_file(root / name, max_asset_bytes);
  };
  return tree;
}

}  // namespace roomgen::assets
