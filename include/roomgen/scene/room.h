#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/polygon.h"
#include "roomgen/scene/object.h"

namespace roomgen {

inline constexpr double wall_thickness = 0.10;       ///< outward from the polygon
inline constexpr double default_room_height = 2.7;
/// Of a room that somebody asks for, metres.
inline constexpr double least_room_side = 0.5, greatest_room_side = 50.0;
inline constexpr double default_sill = 0.9;
inline constexpr double default_door_head = 2.05;
inline constexpr double default_window_head = 2.1;
/// Free floor that a door needs in front of it (ADA 2010, 404.2.4: approach; notes on ergonomics).
inline constexpr double door_approach = 0.9;
/// Depth of the strip before a window where nothing tall may stand.
inline constexpr double window_strip = 0.5;
/// How far above the sill furniture before a window may reach.
inline constexpr double window_overlap = 0.1;

enum class OpeningType { door, window, passage };
enum class DoorSwing { in, out, sliding };

/// The mesh of a door or window, from a library.
struct Joinery {
  AssetRef asset;  ///< empty: the room's own woodwork
  /// Of the mesh's depth, what is in the wall: metres behind its front. That part takes the wall's
  /// thickness; what stands out before and behind it keeps its measure.
  double wall_front = 0.0;
  double wall_back = wall_thickness;
  bool mirrored = false;  ///< left and right have changed places, so that a door hangs on its hinge
  int side_by_side = 1;   ///< so many of the mesh fill the width
};

/// A hole in wall `wall`, which runs from polygon[wall] to polygon[wall + 1]; `from` and `to` are
/// metres along it, `sill` and `head` metres above the floor.
struct Opening {
  std::string id;  ///< "door-0"
  OpeningType type = OpeningType::door;
  std::size_t wall = 0;
  double from = 0.0;
  double to = 0.0;
  double sill = 0.0;
  double head = default_door_head;
  bool hinge_at_from = true;
  DoorSwing swing = DoorSwing::in;
  std::string kind;     ///< "double door", "round window"; empty: as its type says
  int leaves = 1;       ///< of a door: 2 hang at both sides, or slide past each other
  bool glazed = false;  ///< a door with panes
  /// The outline of the hole, counter-clockwise, each coordinate a part of the rectangle: x from
  /// `from` to `to`, y from `sill` to `head`. Every upright line crosses it once. Empty: all of it.
  std::vector<Vec2> outline;
  Joinery joinery;
  std::string leads_to;  ///< of a door or passage in a dwelling: id of the next room; empty: outdoors
  std::string purpose;   ///< what it is for, in words: "to the garden"

  double width() const { return to - from; }
  bool is_entrance() const { return type != OpeningType::window; }
};

/// The lower part of a wall that is covered otherwise: panelling, tiles up to a height.
struct WallBand {
  std::string finish;   ///< words; empty: as the wall above it
  double height = 0.0;  ///< metres from the floor; 0: there is none

  bool operator==(const WallBand&) const = default;
};

/// How some walls are covered. What it leaves open is as with the others.
struct WallCover {
  /// "wall-2"; a side of the compass ("north": +Y) for all walls on it; "accent" for accent_wall();
  /// empty for the others.
  std::string wall;
  std::string finish;  ///< words
  std::optional<WallBand> lower;

  bool operator==(const WallCover&) const = default;
};

/// What the room is covered with, in words ("oak floor", "#8a9a5b"; docs/materials.md); may be
/// empty.
struct RoomMaterials {
  std::string floor, walls, ceiling;
  std::vector<WallCover> covers = {};  ///< the first that means a wall counts
};

/// The WallCover::wall of the one wall that shall differ, wherever it is.
inline constexpr std::string_view accent_name = "accent";
/// What is said of walls by this name, added where nothing is.
WallCover& cover_named(RoomMaterials& materials, std::string_view wall);
/// The finish that walls have by this name; empty if nothing is said.
std::string finish_named(const RoomMaterials& materials, std::string_view wall);

enum class Sky { clear, cloudy, overcast, night };

/// In what light a room shall be seen (docs/materials.md). What is left open is usual: day, a clear
/// sky, and all lamps burn.
struct Lighting {
  std::optional<double> hour;    ///< of the day, 0 to 24
  std::optional<Sky> sky;
  std::optional<double> lux;     ///< how bright it is where people are
  std::optional<double> kelvin;  ///< colour of the lamps
  std::optional<std::vector<std::string>> lamps;  ///< that burn: ids, kinds or "all"

  bool operator==(const Lighting&) const = default;
};

/// The parts that a palette gives a colour or stuff.
inline constexpr std::string_view palette_roles[] = {"main", "second", "accent", "wood", "metal"};

struct Room {
  std::string type;  ///< "bedroom"
  Polygon polygon;   ///< inner face of the walls
  double height = default_room_height;
  std::vector<Opening> openings;
  RoomMaterials materials;
  std::string id;  ///< "bedroom-0" in a dwelling, else empty
  Lighting light;
  std::vector<std::string> style;  ///< words: "mid-century", "cosy"
  std::map<std::string, std::string, std::less<>> palette;  ///< words or #rrggbb, by role
};

/// The outline of the hole in metres along the wall and over the floor, counter-clockwise.
std::vector<Vec2> outline(const Opening& opening);
/// Is every upright line's part inside the outline in one piece, and does it fill enough of its square
/// to be a hole? What an Opening's outline must be.
bool is_opening_outline(const std::vector<Vec2>& outline);
/// The opening on the floor, in the direction of its wall.
Segment segment(const Room& room, const Opening& opening);
/// Unit normal of the opening's wall, towards the inside.
Vec2 inward(const Room& room, const Opening& opening);
/// The rectangle before a door where people pass: as wide as the door and door_approach deep; 0.6 m deep
/// for a passage and for a door that does not swing in.
Footprint door_clearance(const Room& room, const Opening& door);
/// The strip before a window in which nothing may reach higher than sill + window_overlap.
Footprint window_clearance(const Room& room, const Opening& window);
/// All floor that an opening needs: the above, and for a door that swings in where its leaf sweeps
/// beyond the approach (a leaf wider than door_approach), for each of its leaves.
std::vector<Footprint> clearances(const Room& room, const Opening& opening);
/// The wall that is meant by "accent": the longest one without an opening, else the longest without
/// an entrance, else the longest.
std::size_t accent_wall(const Room& room);
/// What a wall has all in all, by its own covers and those of the others.
WallCover cover_of(const Room& room, std::size_t wall);
const Opening* find_opening(const Room& room, std::string_view id);

/// The largest floor, in square metres of the rectangle round it: what looks at every spot of a floor, as walking does,
/// takes time and memory with it.
inline constexpr double largest_floor = 40000.0;

/// Openings must lie on their wall, below the ceiling, and not overlap each other; the floor must not be larger than
/// the greatest.
Status check(const Room& room);

std::string_view name(OpeningType type);
std::string_view name(DoorSwing swing);
std::string_view name(Sky sky);

}  // namespace roomgen
