#include "import_limits.h"

#include <assimp/scene.h>

#include <utility>
#include <vector>

namespace roomgen::decode {

namespace {

Error over(const std::string& what, std::size_t limit) {
  return {Error::Kind::limit, what + " over the limit of " + std::to_string(limit) + "; simplify the mesh"};
}

Status check_faces(const aiScene& scene) {
  for (unsigned i = 0; i < scene.mNumMeshes; ++i)
    for (unsigned f = 0; f < scene.mMeshes[i]->mNumFaces; ++f)
      if (scene.mMeshes[i]->mFaces[f].mNumIndices > most_corners)
        return over("a face of " + std::to_string(scene.mMeshes[i]->mFaces[f].mNumIndices) + " corners is",
                    most_corners);
  return {};
}

Status check_nodes(const aiScene& scene, std::size_t max_triangles) {
  std::vector<std::pair<const aiNode*, std::size_t>> open = {{scene.mRootNode, 1}};
  std::size_t nodes = 0, faces = 0;
  while (!open.empty()) {
    const auto [node, depth] = open.back();
    open.pop_back();
    if (++nodes > most_nodes) return over("the number of nodes is", most_nodes);
    if (depth > most_depth) return over("nodes in nodes are", most_depth);
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      if (node->mMeshes[i] >= scene.mNumMeshes)
        return Error{Error::Kind::invalid_input, "a node names a mesh that is not there"};
      faces += scene.mMeshes[node->mMeshes[i]]->mNumFaces;
    }
    if (faces > max_triangles) return too_many_faces(faces, max_triangles);
    for (unsigned i = 0; i < node->mNumChildren; ++i) open.emplace_back(node->mChildren[i], depth + 1);
  }
  return {};
}

}  // namespace

Status check_limits(const aiScene& scene, std::size_t max_triangles) {
  if (scene.mNumMaterials > most_materials) return over("the number of materials is", most_materials);
  if (auto status = check_nodes(scene, max_triangles); !status) return status;
  return check_faces(scene);
}

Error too_many_faces(std::size_t count, std::size_t limit) {
  return {Error::Kind::limit, std::to_string(count) + " faces or more are over the limit of " +
                                  std::to_string(limit) + " triangles; simplify the mesh"};
}

}  // namespace roomgen::decode
