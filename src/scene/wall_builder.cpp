#include "wall_builder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace roomgen::detail {

namespace {

constexpr double tolerance = 1e-6;

std::vector<double> cut_positions(const std::vector<const Opening*>& openings, double length,
                                  const WallNeighbours& neighbours) {
  std::vector<double> cuts = {0.0, length};
  const auto cut = [&](const Span& span) {
    cuts.push_back(std::clamp(span.low, 0.0, length));
    cuts.push_back(std::clamp(span.high, 0.0, length));
  };
  for (const auto& span : neighbours.built) cut(span);
  for (const auto& stretch : neighbours.behind) cut(stretch.span);
  for (const auto* opening : openings) {
    cuts.push_back(std::clamp(opening->from, 0.0, length));
    cuts.push_back(std::clamp(opening->to, 0.0, length));
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(
      std::unique(cuts.begin(), cuts.end(), [](double a, double b) { return b - a < tolerance; }),
      cuts.end());
  cuts.back() = length;
  return cuts;
}

void subtract(std::vector<Span>& spans, const Span& hole) {
  std::vector<Span> rest;
  for (const auto& span : spans) {
    if (hole.low > span.low + tolerance) rest.push_back({span.low, std::min(span.high, hole.low)});
    if (hole.high < span.high - tolerance)
      rest.push_back({std::max(span.low, hole.high), span.high});
  }
  spans = std::move(rest);
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
  if (s <= tolerance) return at(outer_from, wall_thickness, z);
  if (s >= length - tolerance) return at(outer_to, wall_thickness, z);
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

void add_box(Mesh& mesh, const WallFrame& frame, const Vec3& low, const Vec3& high) {
  if ((high - low).minCoeff() <= tolerance) return;
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

bool WallNeighbours::is_built(double s) const {
  return std::any_of(built.begin(), built.end(),
                     [&](const Span& span) { return span.low < s && s < span.high; });
}

const Room* WallNeighbours::room_behind(double s) const {
  for (const auto& stretch : behind)
    if (stretch.span.low < s && s < stretch.span.high) return stretch.room;
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
        neighbours.behind.push_back({*span, &rooms[other]});
    }
  }
  return neighbours;
}

std::vector<WallColumn> wall_columns(const Room& room, std::size_t wall, double height,
                                     const WallNeighbours& neighbours) {
  std::vector<const Opening*> openings;
  for (const auto& opening : room.openings)
    if (opening.wall == wall) openings.push_back(&opening);

  const auto cuts = cut_positions(openings, room.polygon.edge(wall).length(), neighbours);
  std::vector<WallColumn> columns;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    WallColumn column{cuts[i], cuts[i + 1], {{0.0, height}}};
    const double middle = 0.5 * (column.from + column.to);
    column.behind = neighbours.room_behind(middle);
    if (neighbours.is_built(middle)) column.solid.clear();
    for (const auto* opening : openings)
      if (opening->from < middle && middle < opening->to)
        subtract(column.solid, {opening->sill, opening->head});
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace roomgen::detail
