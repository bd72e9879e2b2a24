#include "import_mesh.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <string_view>

#include "import_textures.h"
#include "memory_io.h"

namespace roomgen::assets {

namespace {

constexpr int max_depth = 64;

std::size_t face_count(const aiScene& scene) {
  std::size_t count = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) count += scene.mMeshes[i]->mNumFaces;
  return count;
}

bool same_surface(const Material& a, const Material& b) {
  return a.base_color == b.base_color && a.texture == b.texture && a.roughness == b.roughness &&
         a.metallic == b.metallic && a.double_sided == b.double_sided;
}

// Scene nodes to parts, one for each distinct material.
class Flattener {
 public:
  Flattener(const aiScene& scene, MaterialReader& materials, std::size_t max_triangles)
      : scene_(scene), max_triangles_(max_triangles) {
    for (unsigned i = 0; i < scene.mNumMaterials; ++i)
      add_material(materials.read(*scene.mMaterials[i]));
    model_.parts.resize(model_.materials.size());
    for (std::size_t i = 0; i < model_.parts.size(); ++i)
      model_.parts[i].material = static_cast<int>(i);
  }

  bool add_node(const aiNode& node, const aiMatrix4x4& parent, int depth = 0) {
    const aiMatrix4x4 transform = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      if (!add_mesh(*scene_.mMeshes[node.mMeshes[i]], transform)) return false;
    for (unsigned i = 0; i < node.mNumChildren && depth < max_depth; ++i)
      if (!add_node(*node.mChildren[i], transform, depth + 1)) return false;
    return true;
  }

  // The parts that have triangles, with their materials.
  Model take() {
    Model used;
    for (auto& part : model_.parts) {
      if (part.mesh.triangles.empty()) continue;
      used.materials.push_back(
          std::move(model_.materials[static_cast<std::size_t>(part.material)]));
      used.parts.push_back({std::move(part.mesh), static_cast<int>(used.materials.size()) - 1});
    }
    return used;
  }

 private:
  void add_material(Material material) {
    for (std::size_t i = 0; i < model_.materials.size(); ++i)
      if (same_surface(model_.materials[i], material)) return part_of_material_.push_back(i);
    part_of_material_.push_back(model_.materials.size());
    model_.materials.push_back(std::move(material));
  }

  bool add_mesh(const aiMesh& source, const aiMatrix4x4& transform);
  void add_vertices(Mesh& mesh, const aiMesh& source, const aiMatrix4x4& transform) const;

  const aiScene& scene_;
  std::size_t max_triangles_;
  std::size_t triangles_ = 0;
  std::vector<std::size_t> part_of_material_;
  Model model_;
};

// Parts mix meshes with and without normals or uvs: what is missing becomes zero, and zero normals
// are filled in later (repair_normals).
void Flattener::add_vertices(Mesh& mesh, const aiMesh& source, const aiMatrix4x4& transform) const {
  aiMatrix3x3 of_normals(transform);
  of_normals.Inverse().Transpose();
  for (unsigned i = 0; i < source.mNumVertices; ++i) {
    const aiVector3D p = transform * source.mVertices[i];
    mesh.positions.emplace_back(p.x, p.y, p.z);
    const aiVector3D n = source.mNormals ? of_normals * source.mNormals[i] : aiVector3D();
    mesh.normals.emplace_back(n.x, n.y, n.z);
    const aiVector3D uv = source.mTextureCoords[0] ? source.mTextureCoords[0][i] : aiVector3D();
    const bool finite = std::isfinite(uv.x) && std::isfinite(uv.y);
    // assimp counts v from the bottom.
    mesh.uvs.emplace_back(finite ? uv.x : 0.0f, finite ? 1.0f - uv.y : 0.0f);
  }
}

bool Flattener::add_mesh(const aiMesh& source, const aiMatrix4x4& transform) {
  triangles_ += source.mNumFaces;
  if (triangles_ > max_triangles_) return false;
  if (source.mMaterialIndex >= part_of_material_.size()) return true;
  Mesh& mesh = model_.parts[part_of_material_[source.mMaterialIndex]].mesh;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  add_vertices(mesh, source, transform);
  const bool mirrored = transform.Determinant() < 0.0f;
  for (unsigned i = 0; i < source.mNumFaces; ++i) {
    const aiFace& face = source.mFaces[i];
    if (face.mNumIndices != 3) continue;
    Triangle t{first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]};
    if (mirrored) std::swap(t[1], t[2]);
    mesh.triangles.push_back(t);
  }
  return true;
}

Error too_many(const std::string& mesh, std::size_t count, std::size_t limit) {
  return {Error::Kind::limit, mesh + ": " + std::to_string(count) +
                                  " faces or more are over the limit of " + std::to_string(limit) +
                                  " triangles; simplify the mesh"};
}

// Each face line of a Wavefront file is a face: counting them is much faster than parsing.
bool has_too_many_faces(std::string_view obj, std::size_t limit) {
  std::size_t count = 0;
  for (auto at = obj.find("\nf "); at != std::string_view::npos; at = obj.find("\nf ", at + 3))
    if (++count > limit) return true;
  return false;
}

Result<Model> import_checked(const FileTree& tree, const std::string& mesh,
                             const ImportOptions& options) {
  const auto bytes = tree.read(mesh);
  if (!bytes) return bytes.error();
  if (extension_of(mesh) == "obj" && has_too_many_faces(*bytes, options.max_triangles))
    return too_many(mesh, options.max_triangles, options.max_triangles);

  Assimp::Importer importer;
  importer.SetIOHandler(new MemoryIo(tree, folder_of(mesh)));  // the importer deletes it
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = importer.ReadFile(mesh, 0);
  if (!scene || !scene->mRootNode)
    return Error{Error::Kind::invalid_input, mesh + ": " + importer.GetErrorString()};
  // Counted before the costly steps.
  if (const auto faces = face_count(*scene); faces > options.max_triangles)
    return too_many(mesh, faces, options.max_triangles);
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_SortByPType |
                                       aiProcess_JoinIdenticalVertices);
  if (!scene) return Error{Error::Kind::invalid_input, mesh + ": has no triangles"};

  MaterialReader materials(tree, mesh, *scene, options);
  Flattener flattener(*scene, materials, options.max_triangles);
  if (!flattener.add_node(*scene->mRootNode, aiMatrix4x4()))
    return too_many(mesh, options.max_triangles, options.max_triangles);
  Model model = flattener.take();
  if (model.parts.empty()) return Error{Error::Kind::invalid_input, mesh + ": has no triangles"};
  return model;
}

}  // namespace

bool is_mesh_file(const std::string& name) {
  static constexpr std::array<std::string_view, 10> known = {"glb", "gltf", "obj", "fbx", "dae",
                                                             "stl", "ply",  "3ds", "off", "x3d"};
  const std::string extension = extension_of(name);
  return std::find(known.begin(), known.end(), extension) != known.end();
}

Result<Model> import_mesh(const FileTree& tree, const std::string& mesh,
                          const ImportOptions& options) {
  try {
    return import_checked(tree, mesh, options);
  } catch (const std::exception& error) {  // assimp, and memory
    return Error{Error::Kind::invalid_input, mesh + ": " + error.what()};
  }
}

}  // namespace roomgen::assets
