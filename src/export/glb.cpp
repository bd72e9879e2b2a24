#include "roomgen/export/exporter.h"

#include <Eigen/Geometry>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "geometry/conventions.h"
#include "glb_buffer.h"
#include "glb_lights.h"
#include "glb_materials.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "scene/box_model.h"
#include "scene/plain_names.h"
#include "scene/room_shell.h"

namespace roomgen {

namespace {

using detail::GlbBuffer;
using detail::GlbMaterials;

// The name that the specification reserves for metadata of applications' own.
constexpr const char* extras = "extras";

Eigen::Matrix3d gltf_from_room() {
  return find_axis_convention("gltf")->theirs_from_ours;
}

Json to_json(const Vec3& v) {
  return {rounded(v.x(), 6), rounded(v.y(), 6), rounded(v.z(), 6)};
}

// What glTF demands of a mesh: triangles with an area, unit normals, finite uvs.
Mesh sound(const Mesh& mesh) {
  Mesh result = mesh;
  remove_degenerate(result);
  repair_normals(result);
  for (const auto& uv : result.uvs)
    if (!uv.allFinite()) {
      result.uvs.clear();
      break;
    }
  return result;
}

class GlbWriter {
 public:
  explicit GlbWriter(const ExportOptions& options)
      : options_(options), materials_(options_.encode_image, buffer_) {}

  Status add_scene(const Scene& scene, const ModelTable& models) {
    // Things have the first choice of names: theirs are what people and programs look for.
    const auto names = node_names(scene, node_names_);
    if (auto status = add_rooms(rooms_of(scene), models); !status) return status;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (auto status = add_object(scene.objects[i], names[i], models); !status) return status;
    if (options_.lights) add_lights(scene);
    return {};
  }

  Status add_rooms(std::span<const Room> rooms, const ModelTable& models) {
    for (std::size_t i = 0; i < rooms.size(); ++i)
      if (auto status = add_room(rooms, i, models); !status) return status;
    return {};
  }

  Status add_room(std::span<const Room> rooms, std::size_t index, const ModelTable& models) {
    const Room& shown = rooms[index];
    const std::string id = shown.id.empty() ? "room" : shown.id;
    Json children = Json::array();
    Json room = {{"name", node_names_.take(id, "room")}};
    const std::size_t room_node = nodes_.size();
    nodes_.push_back(nullptr);
    for (const auto& part : room_shell(rooms, index, {}, models)) {
      const auto mesh = add_mesh(name_in(shown, part), part.model);
      if (!mesh) return mesh.error();
      if (!*mesh) continue;
      children.push_back(nodes_.size());
      const std::string category = category_of(shown, part.name);
      Json node = {{"name", node_names_.take(name_in(shown, part), category)}, {"mesh", **mesh}};
      node[extras] = {{"category", category}, {"id", part.name}, {"shell", true}};
      if (!shown.id.empty()) node[extras]["room"] = shown.id;
      nodes_.push_back(std::move(node));
    }
    room["children"] = std::move(children);
    room[extras] = {{"category", "room"}, {"id", id}, {"shell", true}, {"type", shown.type}};
    nodes_[room_node] = std::move(room);
    roots_.push_back(room_node);
    return {};
  }

  Status add_object(const Object& object, const std::string& name, const ModelTable& models) {
    const std::string key = model_key(object, models);
    auto known = assets_.find(key);
    if (known == assets_.end()) {
      const auto model = model_or_box(object, models);
      const auto mesh = add_mesh(object.category, *model);
      if (!mesh) return with_context(mesh.error(), "object \"" + object.id + "\"");
      if (*mesh) meshes_[**mesh][extras] = {{"key", key}};
      known = assets_.emplace(key, Asset{*mesh, bounds(*model)}).first;
    }
    Json node = {{"name", name}};
    if (known->second.mesh) node["mesh"] = *known->second.mesh;
    place(node, model_placement(object, known->second.box));
    node[extras] = describe(object);
    roots_.push_back(nodes_.size());
    nodes_.push_back(std::move(node));
    return {};
  }

  void add_lights(const Scene& scene) {
    Json group = {{"name", node_names_.take("lights", "lights")}, {"children", Json::array()}};
    const auto add = [&](Json node) {
      node["name"] = node_names_.take(node["name"].get<std::string>(), "light");
      group["children"].push_back(nodes_.size());
      nodes_.push_back(std::move(node));
    };
    for (const auto& lamp : lamp_lights(scene)) add(lights_.lamp_node(lamp));
    // One sun for all: that of the first room with a window.
    for (const auto& room : rooms_of(scene))
      if (const auto sun = sunlight(room)) {
        add(lights_.sun_node(*sun));
        break;
      }
    if (group["children"].empty()) return;
    roots_.push_back(nodes_.size());
    nodes_.push_back(std::move(group));
  }

  Status add_model(const std::string& name, const Model& model) {
    const auto mesh = add_mesh(name, model);
    if (!mesh) return mesh.error();
    Json node = {{"name", node_names_.take(name, "model")}};
    if (*mesh) node["mesh"] = **mesh;
    node[extras] = {{"size", to_json(bounds(model).size())}};
    roots_.push_back(nodes_.size());
    nodes_.push_back(std::move(node));
    return {};
  }

  std::string finish(const std::string& name, const std::string& credits) {
    Json gltf;
    gltf["asset"] = {{"version", "2.0"}, {"generator", "roomgen"}};
    if (!credits.empty()) gltf["asset"]["copyright"] = credits;
    gltf["scene"] = 0;
    gltf["scenes"] = {{{"name", PlainNames().take(name, "scene")}, {"nodes", roots_}}};
    gltf["nodes"] = std::move(nodes_);
    gltf["meshes"] = std::move(meshes_);
    materials_.finish(gltf);
    lights_.finish(gltf);
    std::string binary = buffer_.finish(gltf);
    return detail::glb_file(gltf, std::move(binary));
  }

 private:
  struct Asset {
    std::optional<std::size_t> mesh;  ///< none if the model has no triangles
    Bounds3 box;
  };

  // Every room of a dwelling has a floor and a "wall-0".
  static std::string name_in(const Room& room, const ShellPart& part) {
    return room.id.empty() ? part.name : room.id + " " + part.name;
  }

  static std::string category_of(const Room& room, const std::string& part) {
    if (const auto* opening = find_opening(room, part)) return std::string(name(opening->type));
    return part == "floor" || part == "ceiling" ? part : "wall";
  }

  Result<std::optional<std::size_t>> add_mesh(const std::string& mesh_name, const Model& model) {
    Json primitives = Json::array();
    for (const auto& part : model.parts) {
      const Mesh mesh = sound(part.mesh);
      if (mesh.triangles.empty()) continue;
      const auto material = materials_.use(model.materials[static_cast<std::size_t>(part.material)],
                                           !mesh.uvs.empty());
      if (!material) return material.error();
      primitives.push_back(add_primitive(mesh, *material));
    }
    if (primitives.empty()) return std::optional<std::size_t>{};
    meshes_.push_back({{"name", mesh_names_.take(mesh_name, "model")},
                       {"primitives", std::move(primitives)}});
    return std::optional<std::size_t>(meshes_.size() - 1);
  }

  Json add_primitive(const Mesh& mesh, const GlbMaterials::Use& material) {
    const Eigen::Matrix3f turn = gltf_from_room().cast<float>();
    std::vector<Eigen::Vector3f> positions, normals;
    for (const auto& p : mesh.positions) positions.push_back(turn * p);
    for (const auto& n : mesh.normals) normals.push_back(turn * n);
    Json attributes = {{"POSITION", buffer_.add_positions(positions)},
                       {"NORMAL", buffer_.add_normals(normals)}};
    if (material.textured) attributes["TEXCOORD_0"] = buffer_.add_uvs(mesh.uvs);
    return {{"attributes", std::move(attributes)},
            {"indices", buffer_.add_indices(mesh.triangles, mesh.positions.size())},
            {"material", material.index}};
  }

  static void place(Json& node, const ModelPlacement& placement) {
    const Eigen::Matrix3d turn = gltf_from_room();
    node["translation"] = to_json(turn * placement.position);
    if (placement.yaw != 0.0) {
      const Eigen::Matrix3d rotation =
          turn * Eigen::AngleAxisd(placement.yaw, Vec3::UnitZ()).toRotationMatrix() *
          turn.transpose();
      const Eigen::Quaterniond q = Eigen::Quaterniond(rotation).normalized();
      node["rotation"] = {rounded(q.x(), 9), rounded(q.y(), 9), rounded(q.z(), 9),
                          rounded(q.w(), 9)};
    }
    // Axes swap places; their signs do not matter to a scale.
    const Vec3 scale = turn.cwiseAbs() * placement.scale;
    if ((scale - Vec3::Ones()).cwiseAbs().maxCoeff() > 1e-6) node["scale"] = to_json(scale);
  }

  static Json describe(const Object& object) {
    Json json = {
        {"category", object.category}, {"id", object.id}, {"size", to_json(object.size)}};
    if (!object.description.empty()) json["description"] = object.description;
    if (!object.room.empty()) json["room"] = object.room;
    if (!object.relations.empty()) {
      json["relations"] = Json::array();
      for (const auto& relation : object.relations) json["relations"].push_back(to_text(relation));
    }
    return json;
  }

  const ExportOptions& options_;
  GlbBuffer buffer_;
  GlbMaterials materials_;
  detail::GlbLights lights_;
  Json nodes_ = Json::array(), meshes_ = Json::array(), roots_ = Json::array();
  PlainNames node_names_, mesh_names_;
  std::map<std::string, Asset> assets_;
};

}  // namespace

Result<std::string> make_glb(const Scene& scene, const ModelTable& models,
                             const ExportOptions& options) {
  GlbWriter writer(options);
  if (auto status = writer.add_scene(scene, models); !status) return status.error();
  const std::string type = scene.rooms.empty() ? scene.room.type : "dwelling";
  return writer.finish(type.empty() ? "room" : type, attribution_line(scene));
}

Result<std::string> make_glb(const std::string& name, const Model& model,
                             const ExportOptions& options) {
  GlbWriter writer(options);
  if (auto status = writer.add_model(name, model); !status) return status.error();
  return writer.finish(name, "");
}

Status GlbExporter::write(const Scene& scene, const ModelTable& models,
                          const std::filesystem::path& path) const {
  const auto bytes = make_glb(scene, models, options_);
  if (!bytes) return bytes.error();
  return write_file(path, *bytes);
}

}  // namespace roomgen
