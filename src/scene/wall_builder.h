#pragma once

#include <array>
#include <span>
#include <vector>

#include "roomgen/geometry/model.h"
#include "roomgen/scene/room.h"

namespace roomgen::detail {

inline constexpr double least_length = 1e-6;  ///< metres: what is shorter is nothing

/// Coordinates of one wall: s metres along its inner edge, d metres outward, z up.
struct WallFrame {
  Vec2 origin, along, outward;
  double length = 0.0;
  double outer_from = 0.0, outer_to = 0.0;  ///< s of the ends of the outer face (mitred corners)

  Vec3 at(double s, double d, double z) const {
    const Vec2 p = origin + s * along + d * outward;
    return {p.x(), p.y(), z};
  }
  /// A corner of the solid: on the outer face the ends of the wall are at the mitre.
  Vec3 corner(double s, bool outer, double z) const;
};

WallFrame wall_frame(const Room& room, std::size_t wall);

/// Appends a flat quadrilateral, counter-clockwise from outside, with uv coordinates.
void add_quad(Mesh& mesh, const std::array<Vec3, 4>& points,
              const std::array<Eigen::Vector2f, 4>& uvs);
void add_quad(Mesh& mesh, const std::array<Vec3, 4>& points);
/// Appends a convex face with this normal, counter-clockwise from outside.
void add_face(Mesh& mesh, const std::vector<Vec3>& points, const std::vector<Eigen::Vector2f>& uvs,
              const Vec3& normal);
/// Appends the solid between depths d0 and d1 behind an outline in metres along the wall and height,
/// counter-clockwise; nothing if it is empty.
void add_prism(Mesh& mesh, const WallFrame& frame, const std::vector<Vec2>& outline, double d0,
               double d1);
/// Appends a box in wall coordinates; nothing if it is empty.
void add_box(Mesh& mesh, const WallFrame& frame, const Vec3& low, const Vec3& high);

/// Heights on one upright line.
struct Span {
  double low, high;
};
/// What the other rooms of a dwelling make of a wall; s along it. Nothing for a room alone.
struct WallNeighbours {
  struct Stretch {
    Span span;
    const Room* room = nullptr;
    std::size_t wall = 0;  ///< of that room
  };
  std::vector<Span> built;  ///< that an earlier room has built
  std::vector<Stretch> behind;  ///< where the outer face is the inner face of a later room
  bool built_before = false, built_behind = false;  ///< the post at its start, at its end

  bool is_built(double s) const;
  const Stretch* stretch_behind(double s) const;
};
WallNeighbours wall_neighbours(std::span<const Room> rooms, std::size_t index, std::size_t wall);

/// A solid part of a strip of wall, its edges straight from one side of the strip to the other.
struct WallPiece {
  Span from, to;
};
/// One vertical strip of a wall: where it is solid, bottom up.
struct WallColumn {
  double from, to;
  std::vector<WallPiece> solid;
  const WallNeighbours::Stretch* behind = nullptr;  ///< whose paint its outer face has
};
/// The wall up to `height`, cut into strips at the corners of its openings and at its neighbours,
/// who must outlive them.
std::vector<WallColumn> wall_columns(const Room& room, std::size_t wall, double height,
                                     const WallNeighbours& neighbours);

}  // namespace roomgen::detail
