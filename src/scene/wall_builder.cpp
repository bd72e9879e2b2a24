#include "wall_builder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/outline.h"
#include "geometry/triangulate.h"

namespace roomgen::detail {

namespace {

constexpr double least_area = 1e-8;  // square metres

// What the openings of a wall leave out, up to a height.
std::vector<std::vector<Vec2>> holes_in(const Room& room, std::size_t wall, double height) {
  std::vector<std::vector<Vec2>> holes;
  const double length = room.polygon.edge(wall).length();
  for (const auto& opening : room.openings) {
    if (opening.wall != wall) continue;
    auto hole = clipped(outline(opening), {0, 1}, height);
    for (auto& p : hole) p.x() = std::clamp(p.x(), 0.0, length);
    if (signed_area(hole) > least_area) holes.push_back(std::move(hole));
  }
  return holes;
}

std::vector<double> cut_positions(const std::vector<std::vector<Vec2>>& holes, double length,
                                  const WallNeighbours& neighbours) {
  std::vector<double> cuts = {0.0, length};
  const auto cut = [&](const Span& span) {
    cuts.push_back(std::clamp(span.low, 0.0, length));
    cuts.push_back(std::clamp(span.high, 0.0, length));
  };
  for (const auto& span : neighbours.built) cut(span);
  for (const auto& stretch : neighbours.behind) cut(stretch.span);
  for (const auto& hole : holes)
    for (const auto& p : hole) cuts.push_back(p.x());
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(
      std::unique(cuts.begin(), cuts.end(), [](double a, double b) { return b - a < least_length; }),
      cuts.end());
  cuts.back() = length;
  return cuts;
}

double height_at(const Vec2& a, const Vec2& b, double s) {
  return a.y() + (s - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
}

// The hole's part in a strip that has none of its corners inside; nothing if it lies elsewhere.
std::optional<WallPiece> part_in_strip(const std::vector<Vec2>& hole, double from, double to) {
  const double middle = 0.5 * (from + to);
  std::optional<Span> at_from, at_to;
  for (std::size_t i = 0; i < hole.size(); ++i) {
    const Vec2& a = hole[i];
    const Vec2& b = hole[(i + 1) % hole.size()];
    if (middle < std::min(a.x(), b.x()) || middle > std::max(a.x(), b.x())) continue;
    if (std::abs(b.x() - a.x()) < least_length) continue;
    const double z0 = height_at(a, b, from), z1 = height_at(a, b, to);
    if (!at_from) {
      at_from = Span{z0, z0};
      at_to = Span{z1, z1};
    } else {
      at_from = Span{std::min(at_from->low, z0), std::max(at_from->high, z0)};
      at_to = Span{std::min(at_to->low, z1), std::max(at_to->high, z1)};
    }
  }
  if (!at_from) return std::nullopt;
  return WallPiece{*at_from, *at_to};
}

bool is_empty(const WallPiece& piece) {
  return piece.from.high - piece.from.low < least_length && piece.to.high - piece.to.low < least_length;
}

// The strip without the holes, which do not overlap.
std::vector<WallPiece> between(std::vector<WallPiece> holes, double height) {
  std::sort(holes.begin(), holes.end(), [](const WallPiece& a, const WallPiece& b) {
    return a.from.low + a.to.low < b.from.low + b.to.low;
  });
  std::vector<WallPiece> solid;
  WallPiece rest{{0.0, height}, {0.0, height}};
  for (const auto& hole : holes) {
    const WallPiece below{{rest.from.low, hole.from.low}, {rest.to.low, hole.to.low}};
    if (!is_empty(below)) solid.push_back(below);
    rest.from.low = hole.from.high;
    rest.to.low = hole.to.high;
  }
  if (!is_empty(rest)) solid.push_back(rest);
  return solid;
}

// Where a line that runs the other way lies on this one; metres along this one, which it may
// overshoot.
std::optional<Span> facing_span(const Segment& wall, const Segment& other) {
  constexpr double apart = 1e-3;
  const Vec2 along = wall.direction();
  const auto off = [&](const Vec2& p) { return std::abs(cross(along, Vec2(p - wall.a))); };
  if (off(other.a) > apart || off(other.b) > apart || along.dot(other.direction()) > 0)
    return std::nullopt;
  const Span span{(other.b - wall.a).dot(along), (other.a - wall.a).dot(along)};
  if (span.high < apart || span.low > wall.length() - apart) return std::nullopt;
  return span;
}

}  // namespace

Vec3 WallFrame::corner(double s, bool outer, double z) const {
  if (!outer) return at(s, 0.0, z);
  if (s <= least_length) return at(outer_from, wall_thickness, z);
  if (s >= length - least_length) return at(outer_to, wall_thickness, z);
  // Beside an inner corner the outer face is shorter than the inner one.
  return at(std::clamp(s, outer_from, outer_to), wall_thickness, z);
}

WallFrame wall_frame(const Room& room, std::size_t wall) {
  const Segment edge = room.polygon.edge(wall);
  const auto outer = offset_outward(room.polygon, wall_thickness);
  WallFrame frame;
  frame.origin = edge.a;
  frame.along = edge.direction();
  frame.outward = -room.polygon.inward(wall);
  frame.length = edge.length();
  frame.outer_from = (outer[wall] - edge.a).dot(frame.along);
  frame.outer_to = (outer[(wall + 1) % outer.size()] - edge.a).dot(frame.along);
  return frame;
}

void add_quad(Mesh& mesh, const std::array<Vec3, 4>& points,
              const std::array<Eigen::Vector2f, 4>& uvs) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  // The diagonals give a normal even if one side has no length.
  const Vec3 normal = (points[2] - points[0]).cross(points[3] - points[1]).normalized();
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.positions.push_back(points[i].cast<float>());
    mesh.normals.push_back(normal.cast<float>());
    mesh.uvs.push_back(uvs[i]);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

void add_quad(Mesh& mesh, const std::array<Vec3, 4>& points) {
  add_quad(mesh, points, {Eigen::Vector2f(0, 0), {1, 0}, {1, 1}, {0, 1}});
}

void add_face(Mesh& mesh, const std::vector<Vec3>& points, const std::vector<Eigen::Vector2f>& uvs,
              const Vec3& normal) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    mesh.positions.push_back(points[i].cast<float>());
    mesh.normals.push_back(normal.cast<float>());
    mesh.uvs.push_back(uvs[i]);
  }
  for (std::uint32_t i = 2; i < points.size(); ++i)
    mesh.triangles.push_back({first, first + i - 1, first + i});
}

void add_box(Mesh& mesh, const WallFrame& frame, const Vec3& low, const Vec3& high) {
  if ((high - low).minCoeff() <= least_length) return;
  const auto p = [&](int s, int d, int z) {
    return frame.at(s ? high.x() : low.x(), d ? high.y() : low.y(), z ? high.z() : low.z());
  };
  // (along, outward, up) is left-handed: the inside of the room is to the left of `along`.
  add_quad(mesh, {p(1, 0, 0), p(0, 0, 0), p(0, 0, 1), p(1, 0, 1)});
  add_quad(mesh, {p(0, 1, 0), p(1, 1, 0), p(1, 1, 1), p(0, 1, 1)});
  add_quad(mesh, {p(0, 0, 0), p(0, 1, 0), p(0, 1, 1), p(0, 0, 1)});
  add_quad(mesh, {p(1, 1, 0), p(1, 0, 0), p(1, 0, 1), p(1, 1, 1)});
  add_quad(mesh, {p(0, 1, 1), p(1, 1, 1), p(1, 0, 1), p(0, 0, 1)});
  add_quad(mesh, {p(0, 0, 0), p(1, 0, 0), p(1, 1, 0), p(0, 1, 0)});
}

void add_prism(Mesh& mesh, const WallFrame& frame, const std::vector<Vec2>& outline, double d0,
               double d1) {
  if (outline.size() < 3 || signed_area(outline) <= least_area || d1 - d0 <= least_length) return;
  const auto at = [&](const Vec2& p, double d) { return frame.at(p.x(), d, p.y()); };
  // (along, outward, up) is left-handed: the outline runs clockwise for who stands in the room.
  for (const double d : {d0, d1}) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const double side = d == d0 ? -1.0 : 1.0;
    const Vec3 normal(side * frame.outward.x(), side * frame.outward.y(), 0.0);
    for (const auto& p : outline) {
      mesh.positions.push_back(at(p, d).cast<float>());
      mesh.normals.push_back(normal.cast<float>());
      mesh.uvs.push_back(p.cast<float>());
    }
    for (const auto& t : triangulate(Polygon{outline})) {
      if (d == d0)
        mesh.triangles.push_back({first + t[0], first + t[2], first + t[1]});
      else
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& a = outline[i];
    const Vec2& b = outline[(i + 1) % outline.size()];
    if ((b - a).norm() > least_length) add_quad(mesh, {at(a, d0), at(b, d0), at(b, d1), at(a, d1)});
  }
}

bool WallNeighbours::is_built(double s) const {
  return std::any_of(built.begin(), built.end(),
                     [&](const Span& span) { return span.low < s && s < span.high; });
}

const WallNeighbours::Stretch* WallNeighbours::stretch_behind(double s) const {
  for (const auto& stretch : behind)
    if (stretch.span.low < s && s < stretch.span.high) return &stretch;
  return nullptr;
}

WallNeighbours wall_neighbours(std::span<const Room> rooms, std::size_t index, std::size_t wall) {
  WallNeighbours neighbours;
  const Polygon& own = rooms[index].polygon;
  const Segment edge = own.edge(wall);
  const Segment outer{edge.a - wall_thickness * own.inward(wall),
                      edge.b - wall_thickness * own.inward(wall)};
  for (std::size_t other = 0; other < rooms.size(); ++other) {
    if (other == index) continue;
    const Polygon& inner = rooms[other].polygon;
    const Polygon shell{offset_outward(inner, wall_thickness)};
    for (std::size_t k = 0; k < inner.size(); ++k) {
      if (const auto span = facing_span(edge, shell.edge(k)); span && other < index)
        neighbours.built.push_back(*span);
      if (const auto span = facing_span(outer, inner.edge(k)); span && other > index)
        neighbours.behind.push_back({*span, &rooms[other], k});
    }
  }
  return neighbours;
}

std::vector<WallColumn> wall_columns(const Room& room, std::size_t wall, double height,
                                     const WallNeighbours& neighbours) {
  const auto holes = holes_in(room, wall, height);
  const auto cuts = cut_positions(holes, room.polygon.edge(wall).length(), neighbours);
  std::vector<WallColumn> columns;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    WallColumn column{cuts[i], cuts[i + 1], {}, nullptr};
    const double middle = 0.5 * (column.from + column.to);
    column.behind = neighbours.stretch_behind(middle);
    std::vector<WallPiece> parts;
    for (const auto& hole : holes)
      if (const auto part = part_in_strip(hole, column.from, column.to)) parts.push_back(*part);
    if (!neighbours.is_built(middle)) column.solid = between(std::move(parts), height);
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace roomgen::detail
