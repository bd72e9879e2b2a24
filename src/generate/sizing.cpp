#include "sizing.h"

#include <algorithm>
#include <cmath>

#include "evaluate/ledger.h"

namespace roomgen {

namespace {

// The share by which a mesh is stretched or squeezed at most, and where somebody named the length: up to what
// is no other size (library/looks.h).
constexpr double most_asset_stretch = 0.12, most_said_stretch = 0.3;
constexpr double usual_length = 0.02;  // as near to the kind's own a length says nothing

// Small things: how small they get at most, and by how much with each refusal; the share of a surface
// that they take.
constexpr double least_shrink = least_size_share;
constexpr double shrink_step = 0.9;
constexpr double fit_margin = 0.96;

bool is_told(double wanted, double usual) { return std::abs(wanted / usual - 1.0) > usual_length; }

}  // namespace

bool is_size_told(const PlanItem& item, const Kind& category) {
  if (!item.asked || !item.size) return false;
  return is_told(item.size->x(), category.size.x()) || is_told(item.size->y(), category.size.y());
}

Vec3 fitted_size(const AssetInfo& asset, const PlanItem& item, const Kind& category) {
  Vec3 size = asset.size;
  if (item.mount != Mount::floor || asset.ref.procedural) return size;
  const Vec3 wanted = item.size.value_or(category.size);
  Vec3 factor = wanted.cwiseQuotient(size);
  if (asset.round) factor.head<2>().setConstant(factor.head<2>().mean());
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_said = item.asked && is_told(wanted[axis], category.size[axis]);
    const double most = is_said ? most_said_stretch : axis < 2 ? most_asset_stretch : 0.0;
    size[axis] *= std::clamp(factor[axis], 1.0 - most, 1.0 + most);
  }
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
