#include <algorithm>
#include <cmath>

#include "checks.h"
#include "roomgen/shape/primitives.h"
#include "rounds.h"
#include "surface.h"

namespace roomgen::shape {

namespace {

// The middle vein as an arc that leaves the origin along +X and turns up.
struct Vein {
  Vec3 point, normal;
};
Vein vein(const Leaf& leaf, double part) {
  const double angle = leaf.bend * part;
  const Vec3 normal(-std::sin(angle), 0.0, std::cos(angle));
  if (std::abs(leaf.bend) < 1e-6) return {{leaf.length * part, 0.0, 0.0}, normal};
  const double radius = leaf.length / leaf.bend;
  return {{radius * std::sin(angle), 0.0, radius * (1.0 - std::cos(angle))}, normal};
}

// Half the width, rising and falling like two quarters of a sine.
double half_width(const Leaf& leaf, double part) {
  const double way = part <= leaf.widest ? part / leaf.widest : (1.0 - part) / (1.0 - leaf.widest);
  return 0.5 * leaf.width * std::sin(0.5 * pi * std::max(way, 0.0));
}

// Rows along the leaf, one of them where it is widest.
std::vector<double> rows(const Leaf& leaf, double tolerance) {
  const auto count = [&](double length, double share) {
    const int bends = arc_steps(std::abs(leaf.bend) * share + 1e-9,
                                leaf.length / std::max(std::abs(leaf.bend), 1e-3), tolerance);
    const double sag = pi * pi / 8 * 0.5 * leaf.width;
    return std::clamp(std::max(static_cast<int>(std::ceil(std::sqrt(sag / tolerance) / 2)), bends),
                      length > 0.25 ? 3 : 2, 24);
  };
  const int before = count(leaf.widest, leaf.widest),
            after = count(1 - leaf.widest, 1 - leaf.widest);
  std::vector<double> result;
  for (int k = 0; k < before; ++k) result.push_back(leaf.widest * k / before);
  for (int k = 0; k <= after; ++k) result.push_back(leaf.widest + (1.0 - leaf.widest) * k / after);
  result.back() = 1.0;
  return result;
}

// One row: the edges, and the vein's upper and lower side between which the leaf is thick.
struct Section {
  Corner left, right, upper, lower;
};

Section section(const Leaf& leaf, double part) {
  const Vein middle = vein(leaf, part);
  const double half = half_width(leaf, part), along = leaf.length * part;
  const Vec3 rise = half * std::sin(leaf.fold) * middle.normal;
  const Vec3 across(0.0, half * std::cos(leaf.fold), 0.0);
  const bool tip = part == 0.0 || part == 1.0;
  const Vec3 thick = tip ? Vec3(Vec3::Zero()) : Vec3(0.5 * leaf.thickness * middle.normal);
  Section result;
  result.left = {middle.point + rise + across, {along, -half}, Vec3::Zero(), 0};
  result.right = {middle.point + rise - across, {along, half}, Vec3::Zero(), 0};
  if (tip) result.left.position = result.right.position = middle.point;
  result.upper = {middle.point + thick, {along, 0.0}, Vec3::Zero(), 0};
  result.lower = {middle.point - thick, {along, 0.0}, Vec3::Zero(), 0};
  return result;
}

void add_half(SurfaceBuilder& surface, const Corner& a, const Corner& b, const Corner& c, const Corner& d,
              int group) {
  std::array<Corner, 4> corners{a, b, c, d};
  for (auto& corner : corners) corner.group = group;
  surface.quad(corners[0], corners[1], corners[2], corners[3]);
}

}  // namespace

Result<Mesh> mesh(const Leaf& solid, double tolerance) {
  if (auto s = check_tolerance(tolerance); !s) return s.error();
  if (auto s = check_sizes("leaf", {solid.length, solid.width, solid.thickness}); !s)
    return s.error();
  if (!(solid.widest >= 0.05 && solid.widest <= 0.95))
    return input_error("leaf: the widest place must be between 0.05 and 0.95");
  if (!(std::abs(solid.bend) <= 1.5 * pi))
    return input_error("leaf: the bend must be at most three quarters of a turn");
  if (!(std::abs(solid.fold) <= 1.5)) return input_error("leaf: the fold must be at most 1.5");

  SurfaceBuilder surface;
  const auto parts = rows(solid, tolerance);
  for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
    const Section a = section(solid, parts[k]), b = section(solid, parts[k + 1]);
    add_half(surface, a.right, b.right, b.upper, a.upper, 0);
    add_half(surface, a.upper, b.upper, b.left, a.left, 1);
    add_half(surface, a.left, b.left, b.lower, a.lower, 2);
    add_half(surface, a.lower, b.lower, b.right, a.right, 3);
  }
  return surface.mesh();
}

}  // namespace roomgen::shape
