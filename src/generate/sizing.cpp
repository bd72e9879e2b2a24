#include "sizing.h"

#include <algorithm>
#include <cmath>

#include "evaluate/ledger.h"
#include "library/asset_object.h"

namespace roomgen {

namespace {

// Small things: how small they get at most, and by how much with each refusal; the share of a surface
// that they take.
constexpr double least_shrink = least_size_share;
constexpr double shrink_step = 0.9;
constexpr double fit_margin = 0.96;

}  // namespace

bool is_size_told(const PlanItem& item, const Kind& category) {
  if (!item.asked || !item.size) return false;
  return is_length_told(item.size->x(), category.size.x()) || is_length_told(item.size->y(), category.size.y());
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
