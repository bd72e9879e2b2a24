#pragma once

#include <cstddef>
#include <string>

#include "file_tree.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"

namespace roomgen::decode {

struct ImportOptions {
  int max_texture_side = 1024;         ///< larger pictures are shrunk
  std::size_t max_triangles = 500000;  ///< more are refused: nothing in a room needs them
  LogSink log{};
};

/// Reads a mesh file of the tree with assimp, its scene flattened: positions in the file's own axes
/// and units, one part per distinct material, uvs from the top left. Missing textures are dropped
/// with a warning. Fails when nothing with triangles is in it or when there are too many.
Result<Model> import_mesh(const FileTree& tree, const std::string& mesh,
                          const ImportOptions& options);

/// True for file names that import_mesh() is worth trying on.
bool is_mesh_file(const std::string& name);

}  // namespace roomgen::decode
