#include "opening_need.h"

#include <algorithm>

namespace roomgen::plan {

namespace {

constexpr double least_door = 0.6, narrowest_door = 0.3, wide_door = 1.2;
constexpr double door_clear = 0.05;      // beside a door that fills its stretch: its leaf or frame
constexpr double glazing_clear = 0.1;    // from the corner of a bay to its glass
constexpr double bay_sill = 0.5;
constexpr double wide_window = 1.5;      // against a usual one
constexpr double under_ceiling = 0.1;    // of a window's head
constexpr double least_height = 0.3;     // of a window
constexpr double least_door_head = 1.8;  // that somebody asks for

Opening opening_of(OpeningType type, double width, double head) {
  Opening made;
  made.type = type;
  made.to = width;
  made.head = head;
  return made;
}

double window_width(const brief::RoomKind& kind, bool wide, Random& random) {
  const double width = random.uniform(kind.windows.width.low, kind.windows.width.high);
  return wide ? wide_window * width : width;
}

Opening window_of(const brief::RoomKind& kind, double width, double ceiling) {
  Opening window =
      opening_of(OpeningType::window, width, std::min(kind.windows.head, ceiling - under_ceiling));
  window.sill = std::min(kind.windows.sill, window.head - least_height);
  return window;
}

double wished_width(const brief::OpeningWish& wish, const OpeningKind& kind,
                    const brief::RoomKind& room, Random& random) {
  if (wish.width) return *wish.width;
  const bool window = kind.type == OpeningType::window;
  const double width = kind.width ? *kind.width
                       : window   ? window_width(room, false, random)
                                  : room.door;
  return std::max(kind.least_width, width * (window && wish.wide > 1.0 ? wide_window : wish.wide));
}

void set_heights(const brief::OpeningWish& wish, const OpeningKind& kind,
                 const brief::RoomKind& room, double ceiling, Opening& opening) {
  const double highest = ceiling - under_ceiling;
  const bool window = kind.type == OpeningType::window;
  const double usual_head = window ? room.windows.head : default_door_head;
  opening.head = kind.to_ceiling ? highest : std::min(kind.head.value_or(usual_head), highest);
  opening.sill = window ? kind.sill.value_or(room.windows.sill) : 0.0;
  if (wish.high > 1.0) {
    opening.head = std::min(highest, opening.head * wish.high);
    opening.sill /= wish.high * wish.high;
  }
  if (wish.high < 1.0 && window)
    opening.sill = opening.head - wish.high * (opening.head - opening.sill);
  if (wish.height && window) opening.sill = std::max(0.0, opening.head - *wish.height);
  if (wish.height && !window) opening.head = std::min(highest, std::max(least_door_head, *wish.height));
  opening.sill = std::clamp(opening.sill, 0.0, std::max(0.0, opening.head - least_height));
}

}  // namespace

bool OpeningNeed::likes_corner() const {
  return opening.is_entrance() && opening.width() < wide_door;
}

OpeningNeed plain_door(double width, double least, double ceiling) {
  OpeningNeed need;
  need.opening = opening_of(OpeningType::door, width, std::min(default_door_head, ceiling));
  need.least = std::min(width, least);
  need.clear = door_clear;
  need.yields = true;
  return need;
}

OpeningNeed usual_door(const brief::RoomKind& kind, double ceiling) {
  OpeningNeed need = plain_door(kind.door, least_door, ceiling);
  need.opening.swing = kind.swing;
  return need;
}

OpeningNeed usual_window(const brief::RoomKind& kind, bool wide, double ceiling, Random& random) {
  OpeningNeed need;
  need.opening = window_of(kind, window_width(kind, wide, random), ceiling);
  need.least = std::min(need.opening.width(), least_window);
  need.clear = window_margin;
  need.yields = true;
  return need;
}

OpeningNeed glazing(const brief::RoomKind& kind, double width, double ceiling) {
  OpeningNeed need;
  need.opening = window_of(kind, width - 2.0 * glazing_clear, ceiling);
  need.opening.sill = std::min(need.opening.sill, bay_sill);
  need.least = std::min(need.opening.width(), least_window);
  need.clear = glazing_clear;
  return need;
}

OpeningNeed wished_opening(const brief::OpeningWish& wish, const OpeningKind& kind,
                           const brief::RoomKind& room, double ceiling, Random& random) {
  OpeningNeed need;
  Opening& opening = need.opening;
  opening = opening_of(kind.type, wished_width(wish, kind, room, random), default_door_head);
  opening.kind = kind.name == name(kind.type) ? std::string() : kind.name;
  opening.leaves = kind.leaves;
  opening.glazed = kind.glazed;
  opening.outline = kind.outline;
  opening.swing = kind.swing.value_or(room.swing);
  set_heights(wish, kind, room, ceiling, opening);
  need.least = std::min(opening.width(), kind.least_width);
  need.asked = true;
  need.opposite = wish.opposite;
  need.beside = wish.beside;
  return need;
}

void squeeze(OpeningNeed& door, std::span<const WallStretch> stretches) {
  double longest = 0.0;
  for (const auto& stretch : stretches) longest = std::max(longest, stretch.length());
  door.least = std::min(door.least, std::max(narrowest_door, longest - 2.0 * door.clear));
}

}  // namespace roomgen::plan
