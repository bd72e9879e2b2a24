#include "woodwork.h"

#include <algorithm>

#include "roomgen/scene/finish.h"
#include "wall_builder.h"

namespace roomgen::detail {

namespace {

constexpr double skirting_height = 0.07, skirting_depth = 0.012;
constexpr double door_lining = 0.04, door_leaf = 0.04;
constexpr double sash = 0.055, sash_depth = 0.06;
constexpr double widest_pane = 1.1;

// Boxes in wall coordinates that end at the top of a cut wall.
class Joiner {
 public:
  Joiner(const WallFrame& frame, double height) : frame_(frame), height_(height) {}

  void add(Mesh& mesh, double s0, double s1, double d0, double d1, double z0, double z1) const {
    add_box(mesh, frame_, {s0, d0, z0}, {s1, d1, std::min(z1, height_)});
  }

 private:
  const WallFrame& frame_;
  double height_;
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

Model window(const Opening& o, const Joiner& joiner) {
  const double d0 = 0.5 * (wall_thickness - sash_depth), d1 = d0 + sash_depth;
  Mesh frame, pane;
  joiner.add(frame, o.from, o.to, d0, d1, o.sill, o.sill + sash);
  joiner.add(frame, o.from, o.to, d0, d1, o.head - sash, o.head);
  joiner.add(frame, o.from, o.from + sash, d0, d1, o.sill + sash, o.head - sash);
  joiner.add(frame, o.to - sash, o.to, d0, d1, o.sill + sash, o.head - sash);
  const int panes = std::max(1, static_cast<int>(std::ceil(o.width() / widest_pane)));
  for (int i = 1; i < panes; ++i) {
    const double s = o.from + o.width() * i / panes;
    joiner.add(frame, s - 0.5 * sash, s + 0.5 * sash, d0, d1, o.sill + sash, o.head - sash);
  }
  // The inner sill stands out a little.
  joiner.add(frame, o.from, o.to, -0.025, d0, o.sill, o.sill + 0.02);
  const double middle = 0.5 * wall_thickness;
  joiner.add(pane, o.from + sash, o.to - sash, middle - 0.004, middle + 0.004, o.sill + sash,
             o.head - sash);
  Model model;
  add_part(model, std::move(frame), woodwork_paint());
  add_part(model, std::move(pane), glass());
  return model;
}

Model door(const Opening& o, const Joiner& joiner, const ShellOptions& options) {
  Mesh frame, leaf, handle;
  // Proud of the wall by a few millimetres on both sides, so that no two faces share a plane.
  const double d0 = -0.006, d1 = wall_thickness + 0.006;
  if (options.door_frames) {
    joiner.add(frame, o.from, o.from + door_lining, d0, d1, o.sill, o.head);
    joiner.add(frame, o.to - door_lining, o.to, d0, d1, o.sill, o.head);
    joiner.add(frame, o.from + door_lining, o.to - door_lining, d0, d1, o.head - door_lining,
               o.head);
  }
  if (options.door_leaves && o.type == OpeningType::door) {
    const double gap = 0.004, s0 = o.from + door_lining + gap, s1 = o.to - door_lining - gap;
    const double z0 = o.sill + 0.008, z1 = o.head - door_lining - gap;
    joiner.add(leaf, s0, s1, 0.02, 0.02 + door_leaf, z0, z1);
    // Opposite the hinge, on both faces.
    const double h0 = o.hinge_at_from ? s1 - 0.17 : s0 + 0.05;
    joiner.add(handle, h0, h0 + 0.12, -0.03, 0.09, z0 + 1.0, z0 + 1.025);
  }
  Model model;
  add_part(model, std::move(frame), woodwork_paint());
  add_part(model, std::move(leaf), door_paint());
  add_part(model, std::move(handle), handle_metal());
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
  const Joiner joiner(frame, height);
  if (opening.type == OpeningType::window)
    return options.window_frames ? window(opening, joiner) : Model{};
  return door(opening, joiner, options);
}

Mesh skirting_board(const Room& room, std::size_t wall, double height) {
  Mesh mesh;
  const WallFrame frame = wall_frame(room, wall);
  const double top = std::min(skirting_height, height);
  for (const auto& column : wall_columns(room, wall, height)) {
    const bool stands_on_floor = !column.solid.empty() && column.solid.front().low <= 0.0 &&
                                 column.solid.front().high >= top;
    if (stands_on_floor)
      add_box(mesh, frame, {column.from, -skirting_depth, 0.0}, {column.to, 0.0, top});
  }
  return mesh;
}

}  // namespace roomgen::detail
