#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/scene/room.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// Reads the floor plan of one room: room.json (docs/room.schema.json, or the room of a scene or
/// plan), a simple SVG or an ASCII DXF (docs/floor-plans.md). What the file is, its beginning
/// tells. Fails with the line and the way out when the outline is open, crosses itself, has a
/// spike, no area or too many corners, or is no room by its size.
Result<Room> read_floor_plan(const std::filesystem::path& path);

/// `source` names the file in errors. The box of the outline begins at the origin.
Result<Room> room_from_svg(std::string_view text, const std::string& source);
Result<Room> room_from_dxf(std::string_view text, const std::string& source);

/// Bounds of a drawing; files beyond them are refused.
inline constexpr std::size_t max_drawing_bytes = 8u << 20;
inline constexpr double least_drawn_side = 0.5;      ///< metres, of the outline's box
inline constexpr double greatest_drawn_side = 100.0;

/// Makes a picture of the bytes of a PNG or JPEG file; the core links no image library.
using ImageDecoder = std::function<Result<Image>(std::string_view bytes)>;

/// The furniture in a scene.glb that roomgen wrote, as it was in its library, by asset_key(). Of glTF
/// it reads what the exporter writes (export/exporter.h): triangles with indices in the file's own binary
/// chunk, and the metallic-roughness surface. Without a decoder textures are left out.
Result<ModelTable> read_glb_models(const std::filesystem::path& path,
                                   const ImageDecoder& decode = {});

/// A node of a glTF file.
struct SceneNode {
  std::string name;
  std::string id;  ///< of a thing in scene.json, from the node's extras; empty if it tells none
  /// From the node's own coordinates to those of the room, both as we have them (Z up, metres).
  Eigen::Matrix4d to_room = Eigen::Matrix4d::Identity();
};

/// All nodes of a .glb file that have a name or tell an id, whoever wrote it, with the transforms of those
/// above them. Fails when the file is none, or its nodes go in a circle.
Result<std::vector<SceneNode>> read_glb_nodes(const std::filesystem::path& path);

/// Which nodes of a file are the things of a scene.
struct MatchedNodes {
  std::vector<const SceneNode*>
      nodes;  ///< for each object, in the scene's order; null: there is none
  struct Copy {
    std::string name, of;  ///< of a node, and the id of the thing that it is a copy of
  };
  std::vector<Copy> copies;
};

/// By the ids that nodes tell; else by their names, also as three.js changes them when it loads a file
/// (blanks become '_', "[].:/" go). Of several nodes with one id the one that is called so is the thing, the
/// others are its copies. Fails where that does not decide between two. The nodes must outlive what is returned.
Result<MatchedNodes> match_nodes(const Scene& scene, std::span<const SceneNode> nodes);

}  // namespace roomgen
