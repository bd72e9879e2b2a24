#pragma once

#include <span>
#include <string>
#include <vector>

#include "roomgen/geometry/model.h"
#include "roomgen/scene/scene.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// A piece of the room itself: "floor", "wall-0", … one for each wall, "ceiling", then one of each
/// opening's id that has woodwork. The model is in room coordinates.
struct ShellPart {
  std::string name;
  Model model;
};

struct ShellOptions {
  /// Height of each wall, metres; walls beyond the end of the list reach the ceiling. Openings
  /// above it are cut with it.
  std::vector<double> wall_heights;
  bool skirting = true;
  bool window_frames = true;  ///< with a glass pane
  bool door_frames = true;
  bool door_leaves = true;  ///< closed
  bool inner_doors_open = false;  ///< doors between the rooms of a dwelling have no leaf: who walks there passes
  bool ceiling = true;
  /// Colour of the upper face of walls, sRGB 0 to 255; negative: as the wall.
  Eigen::Vector3f top_color{-1, -1, -1};
  /// Colour of the floor instead of its finish, sRGB 0 to 255; negative: its finish.
  Eigen::Vector3f floor_color{-1, -1, -1};
};

/// Whether the leaves of a door are there, shut.
inline bool has_leaves(const Opening& opening, const ShellOptions& options) {
  return options.door_leaves && !(options.inner_doors_open && !opening.leads_to.empty());
}

/// The room as solids: walls stand outside the polygon, wall_thickness deep, mitred at the corners,
/// each closed (its volume is its own) with the openings cut out; the floor is a slab under room
/// and walls, its upper face at z = 0, so that thresholds belong to it. Doors and windows are the meshes of
/// their assets where `models` has them, fitted to the hole and the wall, and the room's own woodwork
/// elsewhere: without a model, in walls that are cut, and for doors without leaves.
///
/// The ceiling is one sheet without thickness over room and walls at the room's height, and faces down
/// alone: whoever draws only the fronts of faces (the default of glTF) looks through it from above, and
/// still finds the room closed from inside.
std::vector<ShellPart> room_shell(const Room& room, const ShellOptions& options = {},
                                  const ModelTable& models = {});

/// The shell of one room of a dwelling (scene/dwelling.h), less what earlier rooms have built: a
/// wall between two rooms is one solid, that of the first of them, each side painted as its room
/// is; the other room keeps its skirting. A list of one room is that room alone.
std::vector<ShellPart> room_shell(std::span<const Room> rooms, std::size_t index,
                                  const ShellOptions& options = {}, const ModelTable& models = {});

/// Thickness of the floor slab, metres.
inline constexpr double floor_thickness = 0.10;

}  // namespace roomgen
