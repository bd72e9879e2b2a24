#include "alignment.h"

#include <algorithm>
#include <map>

#include "part_roles.h"
#include "search.h"
#include "standing.h"

namespace roomgen::create::detail {

namespace {

// A post's upper end: the mean of its highest vertices, and how far they reach from it.
struct Top {
  Vec2 center = Vec2::Zero();
  double radius = 0.0;
  std::size_t vertex = 0;
};

Top top_of(const Part& part) {
  const Bounds3& box = part.box();
  const double from = box.high.z() - std::max(0.005, 0.05 * box.size().z());
  Bounds3 end;
  Top top;
  const auto& positions = part.solid.mesh().positions;
  for (std::size_t k = 0; k < positions.size(); ++k)
    if (positions[k].z() >= from) {
      end.add(positions[k].cast<double>());
      top.vertex = k;
    }
  top.center = end.center().head<2>();
  top.radius = 0.5 * end.size().head<2>().minCoeff();
  return top;
}

// Towards the outline's middle until the whole end is under it.
Vec2 way_inside(const std::vector<Vec2>& outline, const Top& top) {
  Vec2 middle = Vec2::Zero();
  for (const auto& point : outline) middle += point / static_cast<double>(outline.size());
  const double wanted = std::min(top.radius, 0.5 * std::max(0.0, depth_in(outline, middle)));
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 30; ++k) {
    const double along = 0.5 * (low + high);
    const Vec2 at = top.center + along * (middle - top.center);
    (depth_in(outline, at) >= wanted ? high : low) = along;
  }
  return high * (middle - top.center);
}

bool carries(const Part& foot, const Part& load) {
  return load.box().center().z() > foot.box().center().z() &&
         load.box().high.z() > foot.box().high.z() - 0.02 && load.box().size().x() > 0.02 &&
         load.box().size().y() > 0.02;
}

Vec3 middle_of(const Assembly& assembly, const ComponentPath& path) {
  Bounds3 box;
  for (const auto& part : assembly.parts())
    if (starts_with(part.source, path)) {
      box.add(part.box().low);
      box.add(part.box().high);
    }
  return box.center();
}

}  // namespace

std::vector<Astray> find_astray(const Assembly& assembly, const std::vector<Link>& links) {
  std::vector<Astray> result;
  std::map<std::uint64_t, std::vector<Vec2>> outlines;
  std::map<std::size_t, Astray> best;
  for (const auto& link : links) {
    if (link.floor || link.one.size() != 1) continue;
    const std::size_t foot = link.one.front();
    const Part& part = assembly.parts()[foot];
    if (!is_foot(part.label) || part.box().size().z() < 0.05) continue;
    const Top top = top_of(part);
    for (std::size_t load : link.other) {
      const Part& above = assembly.parts()[load];
      if (!carries(part, above) || is_foot(above.label)) continue;
      auto& outline = outlines[above.id];
      if (outline.empty()) outline = plan_outline(above);
      const double outside = std::max(0.0, -depth_in(outline, top.center));
      const auto known = best.find(foot);
      if (known != best.end() && known->second.outside <= outside) continue;
      const Vec2 way = outside > 0 ? way_inside(outline, top) : Vec2(Vec2::Zero());
      best[foot] = {foot, load, outside, {foot, top.vertex, Vec3(way.x(), way.y(), 0)}};
    }
  }
  for (const auto& [foot, astray] : best)
    if (astray.outside > 0.001) result.push_back(astray);
  return result;
}

void try_alignment(Trials& trials) {
  const Assembly& assembly = trials.from().assembly;
  const auto astray = find_astray(assembly, trials.links());
  if (astray.empty() || trials.exhausted()) return;
  const ComponentPath& source = assembly.parts()[astray.front().foot].source;
  for (std::size_t length = source.size(); length > 0; --length) {
    const Handle inwards{Handle::Kind::move, {source.begin(), source.begin() + length}};
    std::vector<Wish> wishes;
    for (const auto& one : astray)
      if (starts_with(assembly.parts()[one.foot].source, inwards.path)) wishes.push_back(one.wish);
    Assembly trial = assembly;
    const auto amounts = solve(trial, inwards, wishes);
    if (amounts && pull(trial, inwards, *amounts))
      trials.consider(std::move(trial), "moved under what it carries");
  }
  const ComponentPath load = {assembly.parts()[astray.front().load].source.front()};
  const Handle over{Handle::Kind::move, load};
  Vec3 way = middle_of(assembly, {source.front()}) - middle_of(assembly, load);
  way.z() = 0;
  Assembly trial = assembly;
  const auto amounts = solve(trial, over, {{astray.front().load, 0, way}});
  if (amounts && pull(trial, over, *amounts))
    trials.consider(std::move(trial), "moved over what carries it");
}

}  // namespace roomgen::create::detail
