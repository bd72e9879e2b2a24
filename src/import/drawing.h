#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/scene/room.h"

namespace roomgen::detail {

/// Of the polygon that a drawn circle becomes.
inline constexpr int circle_corners = 24;

/// A corner of a drawn line and the line of the file that has it.
struct DrawnPoint {
  Vec2 point = Vec2::Zero();
  std::size_t line = 0;
};

/// What a line of a drawing stands for; its name decides.
enum class DrawnRole { outline, door, window, passage, other };

/// "Door 2", "WINDOWS", "passage", "walls": by how the name of a layer or element begins.
DrawnRole role_of(std::string_view name);

/// A line of a drawing, metres, y upwards.
struct DrawnLine {
  std::vector<DrawnPoint> points;
  bool closed = false;
  DrawnRole role = DrawnRole::other;
  std::string name;  ///< for errors
};

/// The room that lines draw: those that stand for the outline (if none does, those of no known
/// role) must make one closed line, end to end in any order; doors and windows must lie along a
/// wall. `units` is the way out when the size is absurd.
Result<Room> room_from_lines(std::vector<DrawnLine> lines, const std::string& source,
                             const std::string& units);

/// Appends points of a circular arc from the last point to `end`, which bulges to the right by
/// tan(angle / 4), as DXF has it; `line` is that of the file.
void append_arc(std::vector<DrawnPoint>& points, const Vec2& end, double bulge, std::size_t line);

/// An error at a line of the file.
Error located(const std::string& source, std::size_t line, const std::string& what);

inline constexpr std::size_t max_drawn_corners = 500;
inline constexpr std::size_t max_drawn_lines = 5000;
/// Steps in which curves become corners, radians.
inline constexpr double arc_step = pi / 12;

}  // namespace roomgen::detail
