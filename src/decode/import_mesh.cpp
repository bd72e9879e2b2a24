#include "import_mesh.h"

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

#include "import_limits.h"
#include "import_textures.h"
#include "memory_io.h"

namespace roomgen::decode {

namespace {

bool same_surface(const Material& a, const Material& b) {
  return a.base_color == b.base_color && a.texture == b.texture && a.roughness == b.roughness &&
         a.metallic == b.metallic && a.double_sided == b.double_sided;
}

// Scene nodes to parts, one for each distinct material.
class Flattener {
 public:
  Flattener(const aiScene& scene, MaterialReader& materials) : scene_(scene) {
    for (unsigned i = 0; i < scene.mNumMaterials; ++i)
      add_material(materials.read(*scene.mMaterials[i]));
    model_.parts.resize(model_.materials.size());
    for (std::size_t i = 0; i < model_.parts.size(); ++i)
      model_.parts[i].material = static_cast<int>(i);
  }

  void add_node(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 transform = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      add_mesh(*scene_.mMeshes[node.mMeshes[i]], transform);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(*node.mChildren[i], transform);
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

  void add_mesh(const aiMesh& source, const aiMatrix4x4& transform);
  void add_vertices(Mesh& mesh, const aiMesh& source, const aiMatrix4x4& transform) const;

  const aiScene& scene_;
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

void Flattener::add_mesh(const aiMesh& source, const aiMatrix4x4& transform) {
  if (source.mMaterialIndex >= part_of_material_.size()) return;
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
}

// Each face line of a Wavefront file is a face: counting them is much faster than parsing.
bool has_too_many_faces(std::string_view obj, std::size_t limit) {
  std::size_t count = 0;
  for (auto at = obj.find("\nf "); at != std::string_view::npos; at = obj.find("\nf ", at + 3))
    if (++count > limit) return true;
  return false;
}

// The formats that a folder of furniture may hold, and assimp's reader of each; its others stay off.
struct Format {
  std::string_view extension, reader;
};
constexpr std::array<Format, 9> formats = {{{"glb", "glTF2 Importer"},
                                            {"gltf", "glTF2 Importer"},
                                            {"obj", "Wavefront Object Importer"},
                                            {"fbx", "Autodesk FBX Importer"},
                                            {"dae", "Collada Importer"},
                                            {"stl", "Stereolithography (STL) Importer"},
                                            {"ply", "Stanford Polygon Library (PLY) Importer"},
                                            {"3ds", "Discreet 3DS Importer"},
                                            {"off", "OFF Importer"}}};

std::string_view reader_for(const std::string& mesh) {
  const std::string extension = extension_of(mesh);
  const auto format = std::find_if(formats.begin(), formats.end(),
                                   [&](const Format& f) { return f.extension == extension; });
  return format == formats.end() ? std::string_view() : format->reader;
}

// Else assimp asks every reader it has whether the bytes look like theirs.
void keep_only(Assimp::Importer& importer, std::string_view reader) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;)
    if (importer.GetImporterInfo(i)->mName != reader) {
      Assimp::BaseImporter* other = importer.GetImporter(i);
      importer.UnregisterLoader(other);
      delete other;
    }
}

// Of some steps assimp keeps the words of an exception, but not the exception.
void throw_if_memory_lacked(const Assimp::Importer& importer) {
  if (std::string_view(importer.GetErrorString()).find(std::bad_alloc().what()) !=
      std::string_view::npos)
    throw std::bad_alloc();
}

Result<Model> import_checked(const FileTree& tree, const std::string& mesh,
                             const ImportOptions& options) {
  const auto bytes = tree.read(mesh);
  if (!bytes) return bytes.error();
  if (extension_of(mesh) == "obj" && has_too_many_faces(*bytes, options.max_triangles))
    return too_many_faces(options.max_triangles, options.max_triangles);

  Assimp::Importer importer;
  keep_only(importer, reader_for(mesh));
  importer.SetIOHandler(new MemoryIo(tree, folder_of(mesh)));  // the importer deletes it
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = importer.ReadFile(mesh, 0);
  if (importer.GetException()) std::rethrow_exception(importer.GetException());
  throw_if_memory_lacked(importer);
  if (!scene || !scene->mRootNode)
    return Error{Error::Kind::invalid_input, importer.GetErrorString()};
  if (auto status = check_limits(*scene, options.max_triangles); !status) return status.error();
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_SortByPType |
                                       aiProcess_JoinIdenticalVertices);
  throw_if_memory_lacked(importer);
  if (!scene) return Error{Error::Kind::invalid_input, "has no triangles"};

  MaterialReader materials(tree, mesh, *scene, options);
  Flattener flattener(*scene, materials);
  flattener.add_node(*scene->mRootNode, aiMatrix4x4());
  Model model = flattener.take();
  if (model.parts.empty()) return Error{Error::Kind::invalid_input, "has no triangles"};
  if (const auto count = triangle_count(model); count > options.max_triangles)
    return too_many_faces(count, options.max_triangles);
  return model;
}

}  // namespace

bool is_mesh_file(const std::string& name) { return !reader_for(name).empty(); }

Result<Model> import_mesh(const FileTree& tree, const std::string& mesh,
                          const ImportOptions& options) {
  try {
    auto model = import_checked(tree, mesh, options);
    if (!model) return with_context(model.error(), mesh);
    return model;
  } catch (const std::bad_alloc&) {
    return Error{Error::Kind::limit, mesh + ": " + std::string(too_much_memory)};
  } catch (const std::logic_error&) {  // of the containers: its text says where in a program, not what in a file
    return Error{Error::Kind::invalid_input, mesh + ": is damaged: a number in it is out of its range"};
  } catch (const std::exception& error) {  // assimp's
    return Error{Error::Kind::invalid_input, mesh + ": " + error.what()};
  }
}

}  // namespace roomgen::decode
