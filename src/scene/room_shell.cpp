#include "room_shell.h"

#include <algorithm>
#include <utility>

#include "finish.h"
#include "geometry/outline.h"
#include "geometry/triangulate.h"
#include "joinery.h"
#include "wall_builder.h"
#include "woodwork.h"

namespace roomgen {

namespace {

constexpr double rail_height = 0.04, rail_depth = 0.015;  // metres

using detail::add_quad;
using detail::least_length;
using detail::Span;
using detail::WallColumn;
using detail::WallFrame;
using detail::WallNeighbours;
using detail::WallPiece;

double height_of(const Room& room, const ShellOptions& options, std::size_t wall) {
  return wall < options.wall_heights.size() ? std::min(options.wall_heights[wall], room.height)
                                            : room.height;
}

// The floor under a room and its walls, less those of earlier rooms.
std::vector<Loop> floor_outline(std::span<const Room> rooms, std::size_t index) {
  std::vector<Polygon> earlier;
  for (const auto& room : rooms.first(index))
    earlier.push_back({offset_outward(room.polygon, wall_thickness)});
  return difference({offset_outward(rooms[index].polygon, wall_thickness)}, earlier);
}

// The upright faces of a slab.
void add_rim(Mesh& mesh, const Loop& outline) {
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec2 &a = outline[k], &b = outline[(k + 1) % outline.size()];
    const auto at = [](const Vec2& p, double z) { return Vec3(p.x(), p.y(), z); };
    add_quad(mesh, {at(a, -floor_thickness), at(b, -floor_thickness), at(b, 0.0), at(a, 0.0)});
  }
}

Model floor_slab(const Room& room, const std::vector<Loop>& outline, const ShellOptions& options) {
  Finish finish = floor_finish(room);
  if (options.floor_color.x() >= 0) {
    finish.material = Material();
    finish.material.name = "floor";
    finish.material.base_color = material_color(options.floor_color);
  }
  Mesh upper, rest;
  for (const auto& loop : outline)
    for (const auto& p : loop) {
      upper.positions.push_back(Vec3(p.x(), p.y(), 0.0).cast<float>());
      upper.normals.push_back(Eigen::Vector3f::UnitZ());
      rest.positions.push_back(Vec3(p.x(), p.y(), -floor_thickness).cast<float>());
      rest.normals.push_back(-Eigen::Vector3f::UnitZ());
      for (Mesh* mesh : {&upper, &rest}) mesh->uvs.push_back((p / finish.extent).cast<float>());
    }
  for (const auto& t : triangulate(outline)) {
    upper.triangles.push_back(t);
    rest.triangles.push_back({t[0], t[2], t[1]});
  }
  for (const auto& loop : outline) add_rim(rest, loop);
  Material edge;
  edge.name = "slab";
  edge.base_color = material_color({150, 142, 132});
  return {{{std::move(upper), 0}, {std::move(rest), 1}}, {finish.material, edge}, {}};
}

Model ceiling_sheet(const Room& room) {
  const Finish finish = ceiling_finish(room);
  const Polygon outline{offset_outward(room.polygon, wall_thickness)};
  Mesh sheet;
  for (const auto& p : outline.points) {
    sheet.positions.push_back(Vec3(p.x(), p.y(), room.height).cast<float>());
    sheet.normals.push_back(-Eigen::Vector3f::UnitZ());
    sheet.uvs.push_back((p / finish.extent).cast<float>());
  }
  for (const auto& t : triangulate(outline)) sheet.triangles.push_back({t[0], t[2], t[1]});
  return {{{std::move(sheet), 0}}, {finish.material}, {}};
}

// The faces of a wall that are covered alike, above and below the height of the coat.
struct CoatedFaces {
  WallCoat coat;
  Mesh upper, lower;
};

// The faces of one wall, sorted by what they are made of.
struct WallMeshes {
  CoatedFaces own;
  Mesh reveals, top;
  std::vector<std::pair<const WallNeighbours::Stretch*, CoatedFaces>> of_others;

  CoatedFaces& outer(const WallNeighbours::Stretch* behind) {
    if (!behind) return own;
    for (auto& [stretch, faces] : of_others)
      if (stretch == behind) return faces;
    return of_others
        .emplace_back(behind, CoatedFaces{wall_coat(*behind->room, behind->wall), {}, {}})
        .second;
  }
};

class WallSolid {
 public:
  WallSolid(const WallFrame& frame, double height, WallCoat coat)
      : frame_(frame), height_(height), uv_scale_(1.0 / coat.upper.extent) {
    meshes_.own.coat = std::move(coat);
  }

  void add_column(const WallColumn& column) {
    for (const auto& piece : column.solid) {
      add_face(meshes_.own, column, piece, false);
      add_face(meshes_.outer(column.behind), column, piece, true);
      const bool at_top = std::min(piece.from.high, piece.to.high) > height_ - least_length;
      const bool at_floor = std::max(piece.from.low, piece.to.low) < least_length;
      add_edge(at_top ? meshes_.top : meshes_.reveals, column, piece.from.high, piece.to.high,
               true);
      add_edge(at_floor ? meshes_.own.upper : meshes_.reveals, column, piece.from.low, piece.to.low,
               false);
    }
  }

  /// Closes the sides at s where `left` is solid and `right` is not, or the other way round.
  void add_jambs(double s, const std::vector<WallPiece>& left,
                 const std::vector<WallPiece>& right) {
    const bool at_end = s < least_length || s > frame_.length - least_length;
    Mesh& mesh = at_end ? meshes_.own.upper : meshes_.reveals;
    std::vector<Span> before, after;
    for (const auto& piece : left) before.push_back(piece.to);
    for (const auto& piece : right) after.push_back(piece.from);
    for (const auto& span : difference(after, before)) add_jamb(mesh, s, span, false);
    for (const auto& span : difference(before, after)) add_jamb(mesh, s, span, true);
  }

  WallMeshes take() { return std::move(meshes_); }

 private:
  static std::vector<Span> difference(const std::vector<Span>& a, const std::vector<Span>& b) {
    std::vector<Span> rest;
    for (Span span : a) {
      for (const auto& hole : b) {
        if (hole.high <= span.low || hole.low >= span.high) continue;
        if (hole.low > span.low + least_length) rest.push_back({span.low, hole.low});
        span.low = std::min(hole.high, span.high);
      }
      if (span.high > span.low + least_length) rest.push_back(span);
    }
    return rest;
  }

  Eigen::Vector2f uv(double s, double z) const {
    return {static_cast<float>(s * uv_scale_), static_cast<float>(-z * uv_scale_)};
  }

  // An upper and a lower part where the coat changes; who is outdoors sees no panelling.
  void add_face(CoatedFaces& faces, const WallColumn& column, const WallPiece& z,
                bool outer) const {
    const double s0 = column.from, s1 = column.to;
    const std::vector<Vec2> outline = {
        {s0, z.from.low}, {s1, z.to.low}, {s1, z.to.high}, {s0, z.from.high}};
    if (!faces.coat.lower || (outer && !column.behind))
      return add_outline(faces.upper, outline, outer, faces.coat.upper.extent);
    const double height = faces.coat.height;
    add_outline(faces.lower, clipped(outline, {0, 1}, height), outer, faces.coat.lower->extent);
    add_outline(faces.upper, clipped(outline, {0, -1}, -height), outer, faces.coat.upper.extent);
  }

  void add_outline(Mesh& mesh, const std::vector<Vec2>& outline, bool outer, double extent) const {
    if (outline.size() < 3 || signed_area(outline) < least_length * least_length) return;
    std::vector<Vec3> points;
    std::vector<Eigen::Vector2f> uvs;
    for (const auto& p : outline) {
      points.push_back(frame_.corner(p.x(), outer, p.y()));
      uvs.push_back(Vec2(p.x() / extent, -p.y() / extent).cast<float>());
    }
    if (!outer) {
      std::reverse(points.begin(), points.end());
      std::reverse(uvs.begin(), uvs.end());
    }
    const double side = outer ? 1.0 : -1.0;
    detail::add_face(mesh, points, uvs,
                     Vec3(side * frame_.outward.x(), side * frame_.outward.y(), 0.0));
  }

  void add_edge(Mesh& mesh, const WallColumn& column, double z0, double z1, bool up) const {
    std::array<Vec3, 4> points = {
        frame_.corner(column.from, true, z0), frame_.corner(column.to, true, z1),
        frame_.corner(column.to, false, z1), frame_.corner(column.from, false, z0)};
    if (!up) std::swap(points[1], points[3]);
    add_quad(mesh, points);
  }

  void add_jamb(Mesh& mesh, double s, const Span& z, bool forward) const {
    std::array<Vec3, 4> points = {frame_.corner(s, false, z.low), frame_.corner(s, true, z.low),
                                  frame_.corner(s, true, z.high), frame_.corner(s, false, z.high)};
    std::array<Eigen::Vector2f, 4> uvs = {uv(s, z.low), uv(s + wall_thickness, z.low),
                                          uv(s + wall_thickness, z.high), uv(s, z.high)};
    if (forward) {
      std::swap(points[1], points[3]);
      std::swap(uvs[1], uvs[3]);
    }
    add_quad(mesh, points, uvs);
  }

  const WallFrame& frame_;
  double height_;
  double uv_scale_;
  WallMeshes meshes_;
};

WallMeshes wall_solid(const Room& room, std::size_t wall, double height,
                      const WallNeighbours& neighbours) {
  WallFrame frame = detail::wall_frame(room, wall);
  // Where the post at a corner is another room's, the wall ends square against it.
  if (neighbours.built_before) frame.outer_from = 0.0;
  if (neighbours.built_behind) frame.outer_to = frame.length;
  WallSolid solid(frame, height, wall_coat(room, wall));
  std::vector<WallPiece> before;
  for (const auto& column : detail::wall_columns(room, wall, height, neighbours)) {
    solid.add_column(column);
    solid.add_jambs(column.from, before, column.solid);
    before = column.solid;
  }
  solid.add_jambs(frame.length, before, {});
  return solid.take();
}

void add_part(Model& model, Mesh mesh, const Material& material) {
  if (mesh.triangles.empty()) return;
  model.parts.push_back({std::move(mesh), static_cast<int>(model.materials.size())});
  model.materials.push_back(material);
}

void add_faces(Model& model, CoatedFaces faces) {
  add_part(model, std::move(faces.upper), faces.coat.upper.material);
  if (faces.coat.lower) add_part(model, std::move(faces.lower), faces.coat.lower->material);
}

// On the upper edge of panelling or tiles.
void add_rail(Model& model, const Room& room, std::size_t wall, double height) {
  const WallCoat coat = wall_coat(room, wall);
  if (!coat.lower || coat.height > height) return;
  Material plain;
  plain.name = "rail";
  plain.base_color = coat.lower->plain;
  plain.roughness = coat.lower->material.roughness;
  const double low = std::max(0.0, coat.height - rail_height);
  add_part(model, detail::wall_board(room, wall, height, {low, coat.height, rail_depth}), plain);
}

Model wall_model(const Room& room, std::size_t wall, const ShellOptions& options,
                 const WallNeighbours& neighbours) {
  const double height = height_of(room, options, wall);
  WallMeshes meshes = wall_solid(room, wall, height, neighbours);
  Material top = meshes.own.coat.upper.material;
  if (options.top_color.x() >= 0) {
    top = Material{};
    top.name = "wall top";
    top.base_color = material_color(options.top_color);
  }
  Model model;
  add_faces(model, std::move(meshes.own));
  for (auto& [stretch, faces] : meshes.of_others) add_faces(model, std::move(faces));
  add_part(model, std::move(meshes.top), top);
  if (options.skirting) {
    append(meshes.reveals, detail::skirting_board(room, wall, height));
    add_rail(model, room, wall, height);
  }
  add_part(model, std::move(meshes.reveals), detail::woodwork_paint());
  return model;
}

// Does the post outside a corner belong to an earlier room?
bool is_corner_built(std::span<const Room> rooms, std::size_t index, std::size_t corner) {
  const Polygon& polygon = rooms[index].polygon;
  if (index == 0 || !polygon.is_convex_corner(corner)) return false;
  const Vec2 post =
      0.5 * (polygon.points[corner] + offset_outward(polygon, wall_thickness)[corner]);
  return std::any_of(rooms.begin(), rooms.begin() + static_cast<std::ptrdiff_t>(index),
                     [&](const Room& earlier) {
                       return contains(Polygon{offset_outward(earlier.polygon, wall_thickness)}, post);
                     });
}

// Of all walls of a room, with what is known of the corners between them.
std::vector<WallNeighbours> neighbours_of_walls(std::span<const Room> rooms, std::size_t index) {
  const Polygon& polygon = rooms[index].polygon;
  std::vector<WallNeighbours> walls;
  for (std::size_t wall = 0; wall < polygon.size(); ++wall)
    walls.push_back(detail::wall_neighbours(rooms, index, wall));
  const std::size_t n = walls.size();
  for (std::size_t corner = 0; corner < n; ++corner) {
    const bool built = is_corner_built(rooms, index, corner);
    walls[corner].built_before = built;
    walls[(corner + n - 1) % n].built_behind = built;
  }
  return walls;
}

}  // namespace

std::vector<ShellPart> room_shell(std::span<const Room> rooms, std::size_t index,
                                  const ShellOptions& options, const ModelTable& models) {
  const Room& room = rooms[index];
  std::vector<ShellPart> shell;
  shell.push_back({"floor", floor_slab(room, floor_outline(rooms, index), options)});
  const auto neighbours = neighbours_of_walls(rooms, index);
  for (std::size_t wall = 0; wall < room.polygon.size(); ++wall)
    shell.push_back(
        {"wall-" + std::to_string(wall), wall_model(room, wall, options, neighbours[wall])});
  if (options.ceiling) shell.push_back({"ceiling", ceiling_sheet(room)});
  for (const auto& opening : room.openings) {
    if (neighbours[opening.wall].is_built(0.5 * (opening.from + opening.to))) continue;
    const double height = height_of(room, options, opening.wall);
    const auto joinery = detail::joinery_to_show(opening, height, options, models);
    Model model = joinery ? detail::fitted_joinery(room, opening, *joinery)
                          : detail::opening_woodwork(room, opening, height, options);
    if (!model.parts.empty()) shell.push_back({opening.id, std::move(model)});
  }
  return shell;
}

std::vector<ShellPart> room_shell(const Room& room, const ShellOptions& options,
                                  const ModelTable& models) {
  return room_shell({&room, 1}, 0, options, models);
}

}  // namespace roomgen
