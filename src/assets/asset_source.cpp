#include "asset_source.h"

namespace roomgen::assets {

namespace fs = std::filesystem;

std::string library_name(const fs::path& path) {
  const fs::path plain = path.has_filename() ? path : path.parent_path();
  std::error_code code;
  return fs::is_directory(plain, code) ? plain.filename().string() : plain.stem().string();
}

Result<FileTree> open_tree(const fs::path& path, const LogSink& log) {
  std::error_code code;
  if (!fs::exists(path, code))
    return Error{Error::Kind::not_found, path.string() + ": no such library"};
  if (fs::is_directory(path, code)) return open_folder(path);
  const std::string extension = extension_of(path.filename().string());
  if (extension == "sh3f" || extension == "zip") return open_zip(path, log);
  return Error{Error::Kind::invalid_input,
               path.string() + ": no furniture library; give a .sh3f file or a folder of meshes"};
}

Result<AssetSource> open_source(const fs::path& path, const LogSink& log) {
  auto tree = open_tree(path, log);
  if (!tree) return tree.error();
  AssetSource source{library_name(path), *std::move(tree), {}};
  source.assets = source.tree.contains(sh3f_catalogue)
                      ? list_sh3f(source.tree, source.library, log)
                      : list_folder(source.tree, source.library, log);
  if (source.assets.empty())
    return Error{Error::Kind::invalid_input, path.string() + ": has no furniture in it"};
  return source;
}

}  // namespace roomgen::assets
