#include "sizing.h"

#include <algorithm>
#include <cmath>

namespace roomgen {

namespace {

// The share by which a mesh is stretched or squeezed at most.
constexpr double most_asset_stretch = 0.12;

// Small things: how small they get at most, and by how much with each refusal; the share of a surface
// that they take.
constexpr double least_shrink = 0.6;
constexpr double shrink_step = 0.9;
constexpr double fit_margin = 0.96;

}  // namespace

Vec3 fitted_size(const AssetInfo& asset, const PlanItem& item, const Kind& category) {
  Vec3 size = asset.size;
  if (item.mount != Mount::floor || asset.ref.procedural) return size;
  const Vec3 wanted = item.size.value_or(category.size);
  Vec2 factor = wanted.head<2>().cwiseQuotient(size.head<2>());
  if (asset.round) factor.setConstant(factor.mean());
  size.head<2>().array() *= factor.array().max(1.0 - most_asset_stretch).min(1.0 + most_asset_stretch);
  return size;
}

double shrink_factor(const Object& object, std::span<const SupportSurface> surfaces,
                     std::size_t refused) {
  double fit = 0.0;
  for (const auto& surface : surfaces) {
    const Vec2 room = surface.box().size();
    for (const Vec2& side : {Vec2(object.size.x(), object.size.y()),
                             Vec2(object.size.y(), object.size.x())})
      fit = std::max(fit, room.cwiseQuotient(side).minCoeff());
  }
  const double factor = std::min(1.0, fit_margin * fit) * std::pow(shrink_step, refused);
  return std::max(factor, least_shrink);
}

}  // namespace roomgen
