#include "file_tree.h"

#include <algorithm>

#include "base/relative_name.h"
#include "roomgen/base/text.h"

namespace roomgen::decode {

bool FileTree::contains(std::string_view name) const {
  return std::binary_search(names.begin(), names.end(), name);
}

std::vector<std::string> FileTree::files_in(std::string_view folder) const {
  const std::string prefix = folder.empty() ? std::string() : std::string(folder) + "/";
  std::vector<std::string> result;
  for (auto it = std::lower_bound(names.begin(), names.end(), prefix);
       it != names.end() && it->starts_with(prefix); ++it)
    if (it->find('/', prefix.size()) == std::string::npos) result.push_back(*it);
  return result;
}

std::string FileTree::find_in_folder(std::string_view folder, std::string_view file) const {
  const std::string wanted = lower(trim(file));
  for (const auto& name : files_in(folder))
    if (lower(file_name_of(name)) == wanted) return name;
  return {};
}

std::string FileTree::resolve(const std::string& folder, std::string_view reference) const {
  std::string path(trim(reference));
  std::replace(path.begin(), path.end(), '\\', '/');
  while (path.starts_with("./")) path.erase(0, 2);
  if (stays_below(path)) {
    const std::string below = folder_of(path);
    const std::string whole =
        folder.empty() || below.empty() ? folder + below : folder + "/" + below;
    if (auto found = find_in_folder(whole, file_name_of(path)); !found.empty()) return found;
  }
  return find_in_folder(folder, file_name_of(path));
}

std::string folder_of(std::string_view name) {
  const auto slash = name.rfind('/');
  return slash == std::string_view::npos ? std::string() : std::string(name.substr(0, slash));
}

std::string file_name_of(std::string_view path) {
  const auto slash = path.find_last_of("/\\");
  return std::string(slash == std::string_view::npos ? path : path.substr(slash + 1));
}

std::string extension_of(std::string_view name) {
  const std::string file = file_name_of(name);
  const auto dot = file.rfind('.');
  return dot == std::string::npos ? std::string() : lower(std::string_view(file).substr(dot + 1));
}

}  // namespace roomgen::decode
