#include "outline.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace roomgen {

namespace {

constexpr int cells = 48;
constexpr double filled = 0.9;
constexpr double bare = 0.12;
constexpr double equal_sides = 7.0 / 6.0;
constexpr double thin = 1.0 / 3.0;

// The cells that the mesh covers; coordinates in [0, 1] across its box.
class Shadow {
 public:
  Shadow(const Mesh& mesh, int axis) {
    const Bounds3 box = bounds(mesh);
    const int across = axis == 0 ? 1 : 0, up = axis == 2 ? 1 : 2;
    const auto flat = [&](std::uint32_t i) {
      const Vec3 p = mesh.positions[i].cast<double>() - box.low;
      return Vec2(p[across] / std::max(1e-9, box.size()[across]), p[up] / std::max(1e-9, box.size()[up]));
    };
    for (const auto& t : mesh.triangles) draw(flat(t[0]), flat(t[1]), flat(t[2]));
  }

  /// The covered share of the cells for whose middle, from -1 to 1 on both axes, `chosen` holds.
  template <typename Chosen>
  double covered(Chosen chosen) const {
    int of = 0, on = 0;
    for (int row = 0; row < cells; ++row)
      for (int column = 0; column < cells; ++column)
        if (chosen(Vec2(middle(column), middle(row)))) ++of, on += at(column, row);
    return of == 0 ? 0.0 : static_cast<double>(on) / of;
  }

 private:
  static double middle(int i) { return (2.0 * i + 1.0) / cells - 1.0; }
  static int cell(double t) { return std::clamp(static_cast<int>(t * cells), 0, cells - 1); }
  bool at(int column, int row) const { return mask_[static_cast<std::size_t>(row * cells + column)]; }

  void draw(const Vec2& a, const Vec2& b, const Vec2& c) {
    for (const auto& p : {a, b, c}) set(cell(p.x()), cell(p.y()));
    const double area = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
    if (std::abs(area) < 1e-12) return;
    const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (int row = cell(low.y()); row <= cell(high.y()); ++row)
      for (int column = cell(low.x()); column <= cell(high.x()); ++column) {
        const Vec2 p((column + 0.5) / cells, (row + 0.5) / cells);
        const auto side = [&](const Vec2& from, const Vec2& to) {
          return ((to - from).x() * (p - from).y() - (to - from).y() * (p - from).x()) * area;
        };
        if (side(a, b) >= 0.0 && side(b, c) >= 0.0 && side(c, a) >= 0.0) set(column, row);
      }
  }
  void set(int column, int row) { mask_[static_cast<std::size_t>(row * cells + column)] = 1; }

  std::array<char, cells * cells> mask_{};
};

// One corner of the box and what is around it.
bool is_l_shaped(const Shadow& shadow) {
  int empty = 0, full = 0;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const double share = shadow.covered([&](const Vec2& p) { return p.x() * x > 0.4 && p.y() * y > 0.4; });
      empty += share < bare;
      full += share > 0.6;
    }
  return empty == 1 && full == 3;
}

}  // namespace

std::string_view name(Outline outline) {
  switch (outline) {
    case Outline::round: return "round";
    case Outline::oval: return "oval";
    case Outline::square: return "square";
    case Outline::rectangular: return "rectangular";
    case Outline::l_shaped: return "l-shaped";
    case Outline::other: break;
  }
  return "other";
}

Outline outline_along(const Mesh& mesh, int axis) {
  if (mesh.triangles.empty()) return Outline::other;
  const Vec3 size = bounds(mesh).size();
  const double width = size[axis == 0 ? 1 : 0], height = size[axis == 2 ? 1 : 2];
  const bool equal = std::max(width, height) <= equal_sides * std::min(width, height);
  const Shadow shadow(mesh, axis);
  const double whole = shadow.covered([](const Vec2&) { return true; });
  const double corners = shadow.covered([](const Vec2& p) { return p.norm() > 1.12; });
  if (shadow.covered([](const Vec2& p) { return p.norm() < 0.95; }) >= filled && corners <= bare)
    return equal ? Outline::round : Outline::oval;
  if (whole >= filled && corners > 0.5) return equal ? Outline::square : Outline::rectangular;
  return is_l_shaped(shadow) ? Outline::l_shaped : Outline::other;
}

Outline outline_of(const Mesh& mesh) {
  if (mesh.triangles.empty()) return Outline::other;
  const Vec3 size = bounds(mesh).size();
  int thinnest = 2;
  for (int axis = 0; axis < 2; ++axis) {
    const double others = std::min(size[axis == 0 ? 1 : 0], size.z());
    if (size[axis] < thin * others && size[axis] < size[thinnest]) thinnest = axis;
  }
  return outline_along(mesh, thinnest);
}

}  // namespace roomgen
