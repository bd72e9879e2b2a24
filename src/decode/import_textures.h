#pragma once

#include <assimp/scene.h>

#include <map>
#include <memory>
#include <string>

#include "file_tree.h"
#include "import_mesh.h"
#include "roomgen/geometry/model.h"

namespace roomgen::decode {

/// Turns assimp's materials into ours, decoding each picture once.
class MaterialReader {
 public:
  MaterialReader(const FileTree& tree, const std::string& mesh, const aiScene& scene,
                 const ImportOptions& options);

  Material read(const aiMaterial& source);

 private:
  std::shared_ptr<const Image> texture(const aiMaterial& source);
  std::shared_ptr<const Image> embedded(const aiTexture& source) const;
  std::string file_for(const std::string& reference) const;
  std::string lone_picture() const;
  void warn(const std::string& what) const;

  const FileTree& tree_;
  std::string mesh_;
  std::string folder_;
  const aiScene& scene_;
  const ImportOptions& options_;
  bool is_gltf_;
  std::map<std::string, std::shared_ptr<const Image>> decoded_;
};

}  // namespace roomgen::decode
