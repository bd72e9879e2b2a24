#include "window_cover.h"

#include <algorithm>

namespace roomgen {

namespace {

// Beyond the sides of the hole, where there is wall: cloth is drawn aside, slats are not.
constexpr double curtain_overhang = 0.2, blind_overhang = 0.05;
constexpr double narrow_overhang = 0.02;
constexpr double over_head = 0.1;  // of the rod
constexpr double under_sill = 0.06;
constexpr double under_ceiling = 0.02;
constexpr double off_wall = 0.004;  // so that faces do not coincide
constexpr double least_width = 0.3, least_height = 0.3, least_said_height = 0.1;
constexpr double short_share =
    0.85;  // of the usual height: what is said to be less is not drawn down

// The wall that is free at each side of the window: to its end, or half-way to the next opening.
double free_beside(const Room& room, const Opening& window) {
  double least =
      std::min(window.from, room.polygon.edge(window.wall).length() - window.to) - off_wall;
  for (const auto& other : room.openings) {
    if (other.wall != window.wall || other.id == window.id) continue;
    const bool entrance = other.is_entrance();
    const double gap = other.from >= window.to ? other.from - window.to : window.from - other.to;
    if (gap >= 0) least = std::min(least, entrance ? gap - off_wall : 0.5 * gap - off_wall);
  }
  return std::max(0.0, least);
}

Object hung(const Object& object, const Room& room, const Opening& window, double overhang,
            double low) {
  const Vec2 normal = inward(room, window);
  const Vec2 middle = segment(room, window).middle();
  const double high = std::min(window.head + over_head, room.height - under_ceiling);
  Object result = object;
  result.size = {window.width() + 2.0 * overhang, object.size.y(), high - low};
  const Vec2 at = middle + (0.5 * object.size.y() + off_wall) * normal;
  result.position = {at.x(), at.y(), low};
  result.yaw = yaw_facing(normal);
  return with_rounded_pose(std::move(result));
}

bool hangs_at(const Object& object, const Room& room, const Opening& window) {
  const Segment line = segment(room, window);
  return distance(line, object.position.head<2>()) < 0.5 * object.size.y() + 0.1;
}

}  // namespace

std::vector<Object> hangings(const Object& object, const Kind& category, const Room& room,
                             const Opening& window, std::optional<double> height) {
  const double sill = std::max(0.0, window.sill - under_sill);
  const bool falls_lower = category.elevation < sill;
  const double usual = falls_lower ? curtain_overhang : blind_overhang;
  const double overhang = std::min(usual, free_beside(room, window));
  const double narrow = std::min(narrow_overhang, overhang);
  const double middle = 0.5 * (window.sill + window.head);
  std::vector<Object> all = {
      hung(object, room, window, overhang, falls_lower ? category.elevation : sill),
      hung(object, room, window, overhang, sill), hung(object, room, window, narrow, sill),
      hung(object, room, window, overhang, middle), hung(object, room, window, narrow, middle)};
  std::erase_if(all, [](const Object& one) {
    return one.size.x() < least_width || one.size.z() < least_height;
  });
  if (height && !all.empty() && *height < short_share * all.front().size.z())
    all.insert(all.begin(), hung(object, room, window, overhang,
                                 top(all.front()) - std::max(*height, least_said_height)));
  return all;
}

std::vector<const Opening*> windows_to_cover(const Room& room, std::span<const Object> objects,
                                             const std::string& category) {
  std::vector<const Opening*> windows;
  for (const auto& opening : room.openings)
    if (!opening.is_entrance()) windows.push_back(&opening);
  std::stable_partition(windows.begin(), windows.end(), [&](const Opening* window) {
    return std::none_of(objects.begin(), objects.end(), [&](const Object& object) {
      return object.category == category && hangs_at(object, room, *window);
    });
  });
  return windows;
}

}  // namespace roomgen
