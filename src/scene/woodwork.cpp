#include "woodwork.h"

#include <algorithm>

#include "finish.h"
#include "geometry/outline.h"
#include "wall_builder.h"

namespace roomgen::detail {

namespace {

constexpr double skirting_height = 0.07, skirting_depth = 0.012;
constexpr double door_lining = 0.04, leaf_depth = 0.04, leaf_gap = 0.004;
constexpr double over_floor = 0.008;  // a door's leaf
constexpr double stile = 0.09;        // of a leaf with panes
constexpr double sash = 0.055, sash_depth = 0.06;
constexpr double pane_depth = 0.008;
constexpr double widest_pane = 1.1;
constexpr double slide_overlap = 0.05;    // of leaves that slide past each other
constexpr double least_board_sill = 0.3;  // a window nearer to the floor has no board
constexpr double handle_height = 1.0;

using Outline = std::vector<Vec2>;

// The outline with all edges moved inward; nothing if nothing is left.
Outline inset(const Outline& outline, double distance) {
  Outline inner = offset_outward(Polygon{outline}, -distance);
  const bool turned = signed_area(inner) <= 0.0 || signed_area(inner) >= signed_area(outline);
  return turned ? Outline{} : inner;
}

Outline between_uprights(const Outline& outline, double s0, double s1) {
  return clipped(clipped(outline, {-1, 0}, -s0), {1, 0}, s1);
}

// A door has no lining at the floor: with its sill sunk by the lining's width, the lining's foot
// ends at the floor.
Outline sunk(const Opening& door, double depth) {
  Outline points = outline(door);
  for (auto& p : points)
    if (p.y() < door.sill + 1e-6) p.y() -= depth;
  return points;
}

// Solids in wall coordinates that end at the sill of the opening and at the top of a cut wall.
class Joiner {
 public:
  Joiner(const WallFrame& frame, double sill, double height)
      : frame_(frame), sill_(sill), height_(height) {}

  void add(Mesh& mesh, double s0, double s1, double d0, double d1, double z0, double z1) const {
    add_box(mesh, frame_, {s0, d0, z0}, {s1, d1, std::min(z1, height_)});
  }

  void add(Mesh& mesh, const Outline& outline, double d0, double d1) const {
    add_prism(mesh, frame_, clipped(clipped(outline, {0, -1}, -sill_), {0, 1}, height_), d0, d1);
  }

  // The band of this width along the inside of an outline.
  void add_frame(Mesh& mesh, const Outline& outline, double width, double d0, double d1) const {
    const Outline inner = inset(outline, width);
    for (std::size_t i = 0; i < inner.size(); ++i) {
      const std::size_t next = (i + 1) % inner.size();
      add(mesh, {outline[i], outline[next], inner[next], inner[i]}, d0, d1);
    }
  }

 private:
  const WallFrame& frame_;
  double sill_, height_;
};

Material glass() {
  Material material;
  material.name = "glass";
  material.base_color = material_color({205, 228, 236}, 0.28f);
  material.roughness = 0.1f;
  material.double_sided = true;
  return material;
}

Material door_paint() {
  Material material;
  material.name = "door";
  material.base_color = material_color({216, 196, 168});
  material.roughness = 0.6f;
  return material;
}

Material handle_metal() {
  Material material;
  material.name = "handle";
  material.base_color = material_color({150, 150, 152});
  material.roughness = 0.35f;
  material.metallic = 0.8f;
  return material;
}

void add_part(Model& model, Mesh mesh, Material material) {
  if (mesh.triangles.empty()) return;
  model.parts.push_back({std::move(mesh), static_cast<int>(model.materials.size())});
  model.materials.push_back(std::move(material));
}

// The board inside stands out a little.
void add_board(Mesh& mesh, const Opening& o, const Joiner& joiner, double d1) {
  if (o.outline.empty() && o.sill >= least_board_sill)
    joiner.add(mesh, o.from, o.to, -0.025, d1, o.sill, o.sill + 0.02);
}

Model window(const Opening& o, const Joiner& joiner) {
  const double d0 = 0.5 * (wall_thickness - sash_depth), d1 = d0 + sash_depth;
  const double middle = 0.5 * wall_thickness;
  Mesh frame, pane;
  const Outline whole = outline(o), light = inset(whole, sash);
  joiner.add_frame(frame, whole, sash, d0, d1);
  const int panes = std::max(1, static_cast<int>(std::ceil(o.width() / widest_pane)));
  for (int i = 1; i < panes; ++i) {
    const double s = o.from + o.width() * i / panes;
    joiner.add(frame, between_uprights(light, s - 0.5 * sash, s + 0.5 * sash), d0, d1);
  }
  add_board(frame, o, joiner, d0);
  joiner.add(pane, light, middle - 0.5 * pane_depth, middle + 0.5 * pane_depth);
  Model model;
  add_part(model, std::move(frame), woodwork_paint());
  add_part(model, std::move(pane), glass());
  return model;
}

struct DoorMeshes {
  Mesh frame, leaf, pane, handle;
};

// One leaf, and its handle at `handle_at` metres along the wall, on both faces.
void add_leaf(DoorMeshes& meshes, const Opening& o, const Joiner& joiner, const Outline& leaf,
              double d0, double handle_at) {
  const double d1 = d0 + leaf_depth, middle = 0.5 * (d0 + d1);
  const Outline light = inset(leaf, stile);
  if (o.glazed && !light.empty()) {
    joiner.add_frame(meshes.leaf, leaf, stile, d0, d1);
    joiner.add(meshes.pane, light, middle - 0.5 * pane_depth, middle + 0.5 * pane_depth);
  } else {
    joiner.add(meshes.leaf, leaf, d0, d1);
  }
  const double z = o.sill + over_floor + handle_height;
  if (o.swing == DoorSwing::sliding)
    joiner.add(meshes.handle, handle_at - 0.012, handle_at + 0.012, d0 - 0.012, d1 + 0.012,
               z - 0.12, z + 0.12);
  else
    joiner.add(meshes.handle, handle_at - 0.06, handle_at + 0.06, d0 - 0.05, d1 + 0.03, z,
               z + 0.025);
}

// Leaves fill the lining: one hung at its hinge, two that meet, or two that slide past each other.
void add_leaves(DoorMeshes& meshes, const Opening& o, const Joiner& joiner) {
  Outline inside = inset(sunk(o, door_lining + leaf_gap), door_lining + leaf_gap);
  inside = clipped(inside, {0, -1}, -(o.sill + over_floor));
  const bool slides = o.swing == DoorSwing::sliding;
  const double from_handle = slides ? 0.05 : 0.11;
  const double s0 = o.from + door_lining + leaf_gap, s1 = o.to - door_lining - leaf_gap;
  const double middle = 0.5 * (s0 + s1), d = 0.02;
  if (o.leaves == 1) {
    add_leaf(meshes, o, joiner, inside, d, o.hinge_at_from ? s1 - from_handle : s0 + from_handle);
    return;
  }
  const double overlap = slides ? slide_overlap : -0.5 * leaf_gap;
  add_leaf(meshes, o, joiner, between_uprights(inside, s0, middle + overlap), d,
           slides ? s0 + from_handle : middle - from_handle);
  add_leaf(meshes, o, joiner, between_uprights(inside, middle - overlap, s1),
           slides ? d + leaf_depth + leaf_gap : d,
           slides ? s1 - from_handle : middle + from_handle);
}

Model door(const Opening& o, const Joiner& joiner, const ShellOptions& options) {
  DoorMeshes meshes;
  // Proud of the wall by a few millimetres on both sides, so that no two faces share a plane.
  if (options.door_frames)
    joiner.add_frame(meshes.frame, sunk(o, door_lining), door_lining, -0.006,
                     wall_thickness + 0.006);
  if (has_leaves(o, options) && o.type == OpeningType::door) add_leaves(meshes, o, joiner);
  Model model;
  add_part(model, std::move(meshes.frame), woodwork_paint());
  add_part(model, std::move(meshes.leaf), o.glazed ? woodwork_paint() : door_paint());
  add_part(model, std::move(meshes.pane), glass());
  add_part(model, std::move(meshes.handle), handle_metal());
  return model;
}

}  // namespace

Material woodwork_paint() {
  Material material;
  material.name = "woodwork";
  material.base_color = material_color({240, 238, 233});
  material.roughness = 0.6f;
  return material;
}

Model opening_woodwork(const Room& room, const Opening& opening, double height,
                       const ShellOptions& options) {
  if (height <= opening.sill) return {};
  const WallFrame frame = wall_frame(room, opening.wall);
  const Joiner joiner(frame, opening.sill, height);
  if (opening.type == OpeningType::window)
    return options.window_frames ? window(opening, joiner) : Model{};
  return door(opening, joiner, options);
}

Mesh wall_board(const Room& room, std::size_t wall, double height, const Board& board) {
  Mesh mesh;
  const WallFrame frame = wall_frame(room, wall);
  const WallNeighbours alone;
  for (const auto& column : wall_columns(room, wall, height, alone)) {
    const auto spans = [&](const Span& z) { return z.low <= board.low && z.high >= board.high; };
    if (std::any_of(column.solid.begin(), column.solid.end(),
                    [&](const WallPiece& piece) { return spans(piece.from) && spans(piece.to); }))
      add_box(mesh, frame, {column.from, -board.depth, board.low}, {column.to, 0.0, board.high});
  }
  return mesh;
}

Mesh skirting_board(const Room& room, std::size_t wall, double height) {
  return wall_board(room, wall, height, {0.0, std::min(skirting_height, height), skirting_depth});
}

}  // namespace roomgen::detail
