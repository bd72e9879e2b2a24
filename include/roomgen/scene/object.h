#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/geometry/polygon.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/relation.h"

namespace roomgen {

/// A mesh built by a recipe instead of taken from a library.
struct ProceduralSource {
  std::string recipe;  ///< "mirror"
  std::string params;  ///< what the recipe reads, as compact JSON; empty if nothing
  std::uint64_t seed = 0;

  bool operator==(const ProceduralSource&) const = default;
};

/// Where the mesh of an object, a door or a window comes from. Empty ids mean a plain box, or the
/// room's own woodwork.
struct AssetRef {
  std::string library;
  std::string id;
  std::string sha256;  ///< of the source file
  std::string license;
  std::string creator;
  std::optional<ProceduralSource> procedural;
  /// Looks that the mesh does not have by itself: words ("navy velvet", "black and white striped") by the
  /// stuff of the parts that are painted so ("upholstery"; docs/finishes.md).
  std::map<std::string, std::string> finish = {};
  /// How the mesh leans, radians: about its X (above 0: forward), then about its Y. The box of what leans is
  /// that of the leaning mesh.
  Vec2 tilt = Vec2::Zero();
  /// Of what hangs by thin wires: their share of the height of its box, [0, 1); 0: it has none.
  double wires = 0.0;

  bool is_box() const { return id.empty() && !procedural; }
  bool operator==(const AssetRef&) const = default;
};

/// A text among the parameters; empty if there is none of this name.
std::string text_parameter(const ProceduralSource& source, std::string_view name);

/// One string that identifies the mesh and its looks: the key of a ModelTable. Empty for a plain box.
std::string asset_key(const AssetRef& asset);
/// Of the asset_key() of what is built, without looks; nothing for other keys.
std::optional<ProceduralSource> source_of_key(std::string_view key);

/// The "asset" of scene.json (docs/scene.schema.json).
Json to_json(const AssetRef& asset);

/// A thing in the room.
struct Object {
  std::string id;  ///< "bed-0": lower case, category and a number
  std::string category;
  std::string description;
  AssetRef asset;
  Traits traits;
  Vec3 size = Vec3::Ones();       ///< width, depth, height of its box, metres
  Vec3 position = Vec3::Zero();   ///< bottom centre of the placed box
  double yaw = 0.0;               ///< radians, counter-clockwise; at 0 the front looks to -Y
  Mount mount = Mount::floor;
  std::string on;                 ///< id of the object under it, for Mount::surface
  std::vector<Relation> relations;
  bool locked = false;            ///< neither repair nor improvement may move it
  bool stand_in = false;          ///< a plain shape in place of what nobody has a model of
  std::string room;               ///< id of its room in a dwelling, else empty
  std::string group;              ///< things of one group stand together (docs/groups.md); else empty
};

inline Footprint footprint(const Object& object) {
  return Footprint(object.position.head<2>(), object.size.head<2>(), object.yaw,
                   object.traits.round);
}
inline double bottom(const Object& object) { return object.position.z(); }
inline double top(const Object& object) { return object.position.z() + object.size.z(); }

/// The pose as a file holds it: coordinates to 0.1 mm, yaw to 0.001 degrees in (-180, 180]. What is
/// checked should be what is written.
Object with_rounded_pose(Object object);

/// Does the object stand on the thing of that id, or does a relation of it name it?
bool depends_on(const Object& object, std::string_view id);

}  // namespace roomgen
