#include <algorithm>
#include <cmath>

#include "surroundings.h"
#include "ways.h"

namespace roomgen {

namespace {

bool is_open(const Surroundings& around, const Vec2& point) {
  return around.inside.contains(point) &&
         std::none_of(around.neighbours.begin(), around.neighbours.end(),
                      [&](const auto& one) { return !one.flat && contains(one.footprint, point); }) &&
         std::none_of(around.zones_in_use.begin(), around.zones_in_use.end(),
                      [&](const Footprint& zone) { return contains(zone, point); });
}

Side side_of(const Footprint& footprint, const Vec2& point) {
  const Vec2 local = footprint.to_local(point).cwiseQuotient(footprint.half());
  if (std::abs(local.x()) > std::abs(local.y())) return local.x() > 0 ? Side::left : Side::right;
  return local.y() > 0 ? Side::back : Side::front;
}

}  // namespace

double reserve_open(const Surroundings& around, const Footprint& footprint) {
  int open = 0, total = 0;
  for (std::size_t side = 0; side < around.arrangement.reserve.size(); ++side) {
    const double depth = around.arrangement.reserve[side];
    if (depth <= 0.0) continue;
    const Footprint zone = zone_footprint(footprint, {static_cast<Side>(side), depth, {}});
    for (double x : {-0.8, 0.0, 0.8})
      for (double y : {-0.9, 0.0, 0.9}) {
        open += is_open(around, zone.to_world(Vec2(x, y).cwiseProduct(zone.half()))) ? 1 : 0;
        ++total;
      }
  }
  return total > 0 ? static_cast<double>(open) / total : 1.0;
}

double reserves_taken(const Surroundings& around, const Footprint& footprint) {
  double taken = 0.0;
  for (const auto& reserve : around.reserves) {
    if (!footprint.bounds().overlaps(reserve.bounds)) continue;
    const auto hits =
        std::count_if(reserve.points.begin(), reserve.points.end(),
                      [&](const Vec2& point) { return contains(footprint, point); });
    taken += static_cast<double>(hits) / static_cast<double>(reserve.points.size());
  }
  return taken;
}

bool is_on_crowded_side(const Surroundings& around, const Footprint& footprint) {
  const auto& all = around.neighbours;
  return std::any_of(all.begin(), all.end(), [&](const auto& partner) {
    if (!partner.partner) return false;
    const Side own = side_of(partner.footprint, footprint.center());
    return std::any_of(all.begin(), all.end(), [&](const auto& other) {
      return &other != &partner && other.like &&
             gap(other.footprint, partner.footprint) < partner_gap &&
             side_of(partner.footprint, other.footprint.center()) == own;
    });
  });
}

}  // namespace roomgen
