#include "on_surface.h"

#include <algorithm>
#include <cmath>

namespace roomgen {

namespace {

constexpr double edge_comfort = 0.04;     // metres between a thing and the edge
constexpr double same_level = 0.03;
constexpr double sunk = 0.1;              // what the bottom of a basin is worth against its rim
constexpr double high_furniture = 1.15;   // whose top is not where its things are
constexpr double hand_low = 0.35, hand_high = 1.5;
constexpr double seat_reach = 0.45;       // of a chair from its table

// What a surface is worth: of low furniture the top, of high furniture what hands and eyes reach; of
// shelves the boards.
double level_degree(const SupportSurface& surface, double base, double height, double most_area,
                    bool shelves) {
  const double at = base + surface.height;
  const double area = std::min(1.0, surface.area / (0.6 * most_area));
  const bool covered = surface.clearance != SupportSurface::open;
  const double usual = covered == shelves ? 1.0 : 0.4;
  if (base + height < high_furniture) return area * usual;
  const double off = std::max({0.0, hand_low - at, at - hand_high});
  return area * (shelves ? usual : 1.0) * std::clamp(1.0 - 1.5 * off, 0.1, 1.0);
}

const SupportSurface* surface_at(const std::vector<SupportSurface>& surfaces, double height) {
  const SupportSurface* best = nullptr;
  for (const auto& surface : surfaces) {
    const double off = std::abs(surface.height - height);
    if (off < same_level && (!best || off < std::abs(best->height - height))) best = &surface;
  }
  return best;
}

// The nearest of the seats at the support decides, else the support's own front.
double user_yaw(const ProposalContext& context, const Object& support, const Footprint& own) {
  static const std::vector<std::string> seats = {"seat"};
  const Footprint area = footprint(support);
  double yaw = support.yaw, nearest = 1e9;
  for (const auto& thing : context.layout.things()) {
    if (!is_any_of(*thing.category, seats) ||
        gap(thing.footprint, area) > seat_reach ||
        ray_hit(area, thing.footprint.center(), thing.footprint.front()) < 0)
      continue;
    const double distance = (thing.footprint.center() - own.center()).norm();
    if (distance < nearest) nearest = distance, yaw = thing.footprint.yaw() + pi;
  }
  return yaw;
}

double inset_degree(const Footprint& own, const Footprint& area) {
  const Vec2 half = area.half();
  double least = edge_comfort;
  for (const auto& corner : own.outline()) {
    const Vec2 local = area.to_local(corner).cwiseAbs();
    least = std::min(least, (half - local).minCoeff());
  }
  return std::clamp(least / edge_comfort, 0.0, 1.0);
}

}  // namespace

double rest_degree(const ProposalContext& context, const Footprint& footprint, double bottom) {
  const Object& object = context.task.object;
  const Object* support = object.mount == Mount::surface ? context.layout.find(object.on) : nullptr;
  if (!support) return 1.0;
  const auto& surfaces = context.layout.support_poses().surfaces(*support);
  if (surfaces.empty()) return 0.0;
  const double base = roomgen::bottom(*support);
  const bool shelves =
      context.layout.categories().is_any_of(support->category, {"bookshelf", "shelf"});
  const bool basin =
      context.layout.categories().is_any_of(support->category, {"washbasin", "kitchen sink"});
  double rim = 0.0;
  for (const auto& surface : surfaces) rim = std::max(rim, surface.height);
  const auto worth = [&](const SupportSurface& surface) {
    const double degree =
        level_degree(surface, base, support->size.z(), surfaces.front().area, shelves);
    return basin && surface.height < rim - same_level ? sunk * degree : degree;
  };
  double best = 1e-6;
  for (const auto& surface : surfaces) best = std::max(best, worth(surface));
  const SupportSurface* own = surface_at(surfaces, bottom - base);
  const double level = own ? worth(*own) / best : 0.0;
  const double facing =
      object.traits.front
          ? 0.5 + 0.5 * std::cos(footprint.yaw() - user_yaw(context, *support, footprint))
          : 1.0;
  return 0.55 * level + 0.3 * facing +
         0.15 * inset_degree(footprint, roomgen::footprint(*support));
}

}  // namespace roomgen
