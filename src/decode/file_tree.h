#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen::decode {

/// Largest file that is taken out of a library. The furniture packages stay below 9 MB.
inline constexpr std::size_t max_asset_bytes = 96u << 20;

/// The files of a library, be it an archive or a folder: all that its meshes can refer to. Nothing
/// outside can be named: paths are relative, with '/' between their parts and no "..".
struct FileTree {
  std::vector<std::string> names;  ///< sorted
  /// The bytes of one of `names`; callable from several threads.
  std::function<Result<std::string>(const std::string& name)> read;

  bool contains(std::string_view name) const;
  /// The file of a folder ("" is the root) whose name equals `file` but for case and surrounding
  /// white space; empty if there is none.
  std::string find_in_folder(std::string_view folder, std::string_view file) const;
  /// The file that a mesh in `folder` means by `reference`: that relative path below the folder,
  /// else the file of that name in the folder itself, since references are often absolute paths of
  /// the author's computer. Empty if there is none.
  std::string resolve(const std::string& folder, std::string_view reference) const;
  /// The files directly in a folder.
  std::vector<std::string> files_in(std::string_view folder) const;
};

std::string folder_of(std::string_view name);
/// The last part of a path of any system: "C:\\tex\\wood.jpg" gives wood.jpg.
std::string file_name_of(std::string_view path);
/// Lower case, without the dot: "jpg".
std::string extension_of(std::string_view name);

}  // namespace roomgen::decode
