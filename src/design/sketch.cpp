#include "sketch.h"

#include <algorithm>

namespace roomgen::design {

namespace {

// Overlap of boxes that a solver settles by itself.
constexpr double solid_tolerance = 0.005;
// docs/constraints.md: use zones.
constexpr double zone_tolerance = 0.02;
constexpr double over_heads = 1.9;
constexpr double over_hips = 1.2;
constexpr double thin = 0.001;

bool blocks_zone(const Object& object, double at) {
  if (object.traits.flat || object.mount == Mount::surface || !object.on.empty()) return false;
  if (at > over_heads) return false;
  return object.mount != Mount::wall || at <= over_hips;
}

Target target_of(const Object& object) {
  return {object.id, footprint(object), bottom(object), top(object), &object};
}

Target target_of(const Room& room, const Opening& opening) {
  const Vec2 normal = inward(room, opening);
  return {opening.id,
          Footprint(segment(room, opening).middle(), {opening.width(), thin}, yaw_facing(normal)),
          opening.sill, opening.head, nullptr};
}

}  // namespace

double usual_bottom(const Object& object, const Kind& category, const Room& room) {
  switch (object.mount) {
    case Mount::ceiling:
      return std::max(0.0, room.height - object.size.z());
    case Mount::wall:
      return std::clamp(category.mount == Mount::wall ? category.elevation : over_hips, 0.0,
                        std::max(0.0, room.height - object.size.z() - 0.05));
    case Mount::floor:
    case Mount::surface:
      break;
  }
  return 0.0;
}

Sketch::Sketch(const Scene& scene, const KindTable& categories,
               const Arrangements& arrangements)
    : room_(&scene.room), objects_(scene.objects), categories_(&categories) {
  for (const auto& opening : room_->openings) {
    if (opening.is_entrance())
      door_strips_.push_back(door_clearance(*room_, opening));
    else
      window_strips_.emplace_back(window_clearance(*room_, opening), opening.sill + window_overlap);
  }
  for (const auto& object : scene.objects)
    standing_.push_back({&object,
                         footprint(object),
                         &categories.get(object.category),
                         &arrangements.get(categories, object.category, object.mount),
                         {}});
  for (auto& one : standing_)
    for (const auto& zone : one.category->zones)
      if (zone_free(zone_footprint(one.footprint, zone), zone, one.object))
        one.zones.push_back(zone);
}

bool Sketch::clear_of_solids(const Object& self, const Footprint& fp, double bottom) const {
  if (self.traits.flat) {
    // Two rugs do not lie on each other.
    return std::none_of(standing_.begin(), standing_.end(), [&](const Standing& other) {
      return other.object->traits.flat && overlaps(fp, other.footprint, zone_tolerance);
    });
  }
  const double top = bottom + self.size.z();
  return std::none_of(standing_.begin(), standing_.end(), [&](const Standing& other) {
    const Object& object = *other.object;
    if (object.traits.flat) return false;
    const bool level = roomgen::bottom(object) < top - thin && bottom < roomgen::top(object) - thin;
    return level && overlaps(fp, other.footprint, solid_tolerance);
  });
}

bool Sketch::clear_of_openings(const Object& self, const Footprint& fp, double bottom) const {
  if (self.traits.flat) return true;
  const auto meets = [&](const Footprint& strip) { return overlaps(fp, strip, solid_tolerance); };
  if (bottom < default_door_head && std::any_of(door_strips_.begin(), door_strips_.end(), meets))
    return false;
  if (categories_->get(self.category).covers_window) return true;
  const double hidden = self.mount == Mount::wall ? window_overlap : 0.0;
  const double top = bottom + self.size.z() + hidden;
  return std::none_of(window_strips_.begin(), window_strips_.end(), [&](const auto& window) {
    return top > window.second && bottom < room_->height - 0.3 && meets(window.first);
  });
}

bool Sketch::zone_free(const Footprint& zone, const UseZone& needs, const Object* owner) const {
  if (!contains(room_->polygon, zone, zone_tolerance)) return false;
  return std::none_of(standing_.begin(), standing_.end(), [&](const Standing& other) {
    return other.object != owner && blocks_zone(*other.object, bottom(*other.object)) &&
           overlaps(zone, other.footprint, zone_tolerance) &&
           !categories_->is_any_of(other.object->category, needs.partners);
  });
}

bool Sketch::usable(const Object& self, const Footprint& fp) const {
  const auto& zones = categories_->get(self.category).zones;
  return zones.empty() || std::any_of(zones.begin(), zones.end(), [&](const UseZone& zone) {
           return zone_free(zone_footprint(fp, zone), zone, nullptr);
         });
}

bool Sketch::leaves_others_usable(const Object& self, const Footprint& fp, double bottom) const {
  if (!blocks_zone(self, bottom)) return true;
  return std::all_of(standing_.begin(), standing_.end(), [&](const Standing& other) {
    return other.zones.empty() ||
           std::any_of(other.zones.begin(), other.zones.end(), [&](const UseZone& zone) {
             return !overlaps(zone_footprint(other.footprint, zone), fp, zone_tolerance) ||
                    categories_->is_any_of(self.category, zone.partners);
           });
  });
}

bool Sketch::allows(const Object& self, const Pose& pose, double bottom) const {
  const Footprint fp = footprint_at(self, pose);
  return contains(room_->polygon, fp) && clear_of_openings(self, fp, bottom) &&
         clear_of_solids(self, fp, bottom) && usable(self, fp) &&
         leaves_others_usable(self, fp, bottom);
}

bool Sketch::blocked(const Footprint& fp) const {
  const auto meets = [&](const Footprint& other) { return overlaps(fp, other, solid_tolerance); };
  return std::any_of(door_strips_.begin(), door_strips_.end(), meets) ||
         std::any_of(standing_.begin(), standing_.end(), [&](const Standing& one) {
           return one.object->mount == Mount::floor && !one.object->traits.flat &&
                  meets(one.footprint);
         });
}

std::vector<Target> Sketch::find(std::string_view id) const {
  for (const auto& one : standing_)
    if (one.object->id == id) return {target_of(*one.object)};
  if (const Opening* opening = find_opening(*room_, id)) return {target_of(*room_, *opening)};
  for (std::size_t k = 0; k < room_->polygon.size(); ++k)
    if (id == "wall-" + std::to_string(k)) return {wall(k)};
  return {};
}

std::vector<Target> Sketch::openings(bool entrances) const {
  std::vector<Target> found;
  for (const auto& opening : room_->openings)
    if (opening.is_entrance() == entrances) found.push_back(target_of(*room_, opening));
  return found;
}

Target Sketch::wall(std::size_t k) const {
  const Segment line = room_->polygon.edge(k);
  return {"wall-" + std::to_string(k),
          Footprint(line.middle(), {line.length(), thin}, yaw_facing(room_->polygon.inward(k))),
          0.0, room_->height, nullptr};
}

}  // namespace roomgen::design
