#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "frame.h"
#include "open_tree.h"
#include "roomgen/base/result.h"
#include "roomgen/library/library.h"

namespace roomgen::assets {

/// What a library itself says about one of its meshes; what it leaves out is worked out later
/// (classify.h) or measured when the mesh is read.
struct SourceAsset {
  AssetInfo info;    ///< ref, name, tags, group, elevation; size if `frame.size` is known
  std::string mesh;  ///< its file in the tree
  SourceFrame frame;
  std::optional<std::string> category;
  std::optional<Mount> mount;
  std::optional<bool> front;
  std::optional<bool> round;
  bool carries_nothing = false;  ///< nothing may be put on it
};

struct AssetSource {
  std::string library;  ///< the name that assets are known by: "Scopia"
  FileTree tree;
  std::vector<SourceAsset> assets;
};

/// "Scopia" for /some/where/Scopia.sh3f, the folder's name for a folder.
std::string library_name(const std::filesystem::path& path);

/// Lists the meshes of a library: by its PluginFurnitureCatalog.properties if it has one, else
/// every mesh file with the sidecar beside it. Entries that cannot be used are left out with a
/// warning.
Result<AssetSource> open_source(const std::filesystem::path& path, const LogSink& log);

std::vector<SourceAsset> list_sh3f(const FileTree& tree, const std::string& library,
                                   const LogSink& log);
std::vector<SourceAsset> list_folder(const FileTree& tree, const std::string& library,
                                     const LogSink& log);

/// The name of a Sweet Home 3D catalogue file, which tells the two apart.
inline constexpr std::string_view sh3f_catalogue = "PluginFurnitureCatalog.properties";

}  // namespace roomgen::assets
