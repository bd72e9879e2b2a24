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

std::optional<Rest> Rest::of(const Layout& layout, const Object& object) {
  static const std::vector<std::string> seats = {"seat"}, shelves = {"bookshelf", "shelf"},
                                        basins = {"washbasin", "kitchen sink"};
  const Object* support = object.mount == Mount::surface ? layout.find(object.on) : nullptr;
  if (!support) return std::nullopt;
  const Kind& category = layout.categories().get(support->category);
  Rest rest;
  rest.surfaces_ = &layout.support_poses().surfaces(*support);
  rest.area_ = footprint(*support);
  rest.base_ = bottom(*support);
  rest.height_ = support->size.z();
  rest.has_front_ = object.traits.front;
  rest.shelves_ = is_any_of(category, shelves);
  rest.basin_ = is_any_of(category, basins);
  for (const auto& surface : *rest.surfaces_) rest.rim_ = std::max(rest.rim_, surface.height);
  rest.best_worth_ = 1e-6;
  for (const auto& surface : *rest.surfaces_)
    rest.best_worth_ = std::max(rest.best_worth_, rest.worth(surface));
  for (const auto& thing : layout.things())
    if (is_any_of(*thing.category, seats) && gap(thing.footprint, rest.area_) <= seat_reach &&
        ray_hit(rest.area_, thing.footprint.center(), thing.footprint.front()) >= 0)
      rest.seats_.push_back(thing.footprint);
  return rest;
}

double Rest::worth(const SupportSurface& surface) const {
  const double degree = level_degree(surface, base_, height_, surfaces_->front().area, shelves_);
  return basin_ && surface.height < rim_ - same_level ? sunk * degree : degree;
}

// The nearest of the seats at the support decides, else the support's own front.
double Rest::user_yaw(const Footprint& own) const {
  double yaw = area_.yaw(), nearest = 1e9;
  for (const auto& seat : seats_) {
    const double distance = (seat.center() - own.center()).norm();
    if (distance < nearest) nearest = distance, yaw = seat.yaw() + pi;
  }
  return yaw;
}

double Rest::degree(const Footprint& footprint, double bottom) const {
  if (surfaces_->empty()) return 0.0;
  const SupportSurface* own = surface_at(*surfaces_, bottom - base_);
  const double level = own ? worth(*own) / best_worth_ : 0.0;
  const double facing =
      has_front_ ? 0.5 + 0.5 * std::cos(footprint.yaw() - user_yaw(footprint)) : 1.0;
  // The right board first, then the right way round, then off the rim: each outweighs those after it.
  constexpr double level_share = 0.55, facing_share = 0.3, inset_share = 0.15;
  return level_share * level + facing_share * facing + inset_share * inset_degree(footprint, area_);
}

}  // namespace roomgen
