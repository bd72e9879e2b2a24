#pragma once

#include <cstddef>
#include <filesystem>

#include "decode/file_tree.h"

namespace roomgen::assets {

using decode::extension_of;
using decode::file_name_of;
using decode::FileTree;
using decode::max_asset_bytes;

inline constexpr std::size_t max_tree_files = 200000;

/// A ZIP archive. Entries with unsafe names are left out, with a warning.
Result<FileTree> open_zip(const std::filesystem::path& path, const LogSink& log);
/// A folder and those below it. Links that lead outside are left out.
Result<FileTree> open_folder(const std::filesystem::path& path);
/// A .sh3f or .zip file, or a folder.
Result<FileTree> open_tree(const std::filesystem::path& path, const LogSink& log);

}  // namespace roomgen::assets
