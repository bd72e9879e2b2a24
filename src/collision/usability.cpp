#include "usability.h"

#include <algorithm>

namespace roomgen {

namespace {

// docs/constraints.md, "Use zones and reachability".
constexpr double above_heads = 1.75;  // who must passes under a lamp at 1.8 m
constexpr double above_hips = 1.2;
constexpr double zone_tolerance = 0.02;

}  // namespace

bool blocks_floor(const Object& object, const Kind& category) {
  if (category.covers_window || category.foot > 0.0 || object.traits.flat || object.mount == Mount::surface) return false;
  if (object.mount == Mount::wall) return bottom(object) <= above_hips;
  return bottom(object) <= above_heads;
}

FloorThing floor_thing(const Object& object, const KindTable& categories) {
  return {&object, &categories.get(object.category), footprint(object)};
}

std::vector<FloorThing> floor_things(std::span<const Object> objects,
                                     const KindTable& categories) {
  std::vector<FloorThing> things;
  for (const auto& object : objects) things.push_back(floor_thing(object, categories));
  return things;
}

bool tucks(const Kind& a, const Kind& b) {
  return a.foot > 0.0 || b.foot > 0.0 || is_any_of(a, b.tucks_under) || is_any_of(b, a.tucks_under);
}

bool blocks_zone(const FloorThing& other, const FloorThing& owner, const UseZone& zone,
                 const Footprint& area) {
  return other.object != owner.object && blocks_floor(*other.object, *other.category) &&
         overlaps(area, other.footprint, zone_tolerance) &&
         !is_any_of(*other.category, zone.partners);
}

bool zone_is_free(const Room& room, std::span<const FloorThing> things, const FloorThing& owner,
                  const UseZone& zone) {
  const Footprint area = zone_footprint(owner.footprint, zone);
  if (!contains(room.polygon, area, zone_tolerance)) return false;
  return std::none_of(things.begin(), things.end(), [&](const FloorThing& other) {
    return blocks_zone(other, owner, zone, area);
  });
}

bool needs_no_zone(const FloorThing& thing) {
  return thing.category->zones.empty() || thing.object->traits.flat ||
         thing.object->mount != Mount::floor;
}

bool has_free_zone(const Room& room, std::span<const FloorThing> things, const FloorThing& thing) {
  const auto& zones = thing.category->zones;
  return needs_no_zone(thing) || std::any_of(zones.begin(), zones.end(), [&](const UseZone& zone) {
           return zone_is_free(room, things, thing, zone);
         });
}

bool is_usable(const Room& room, std::span<const FloorThing> things, const FloorThing& thing,
               const OccupancyGrid& flooded) {
  const auto& zones = thing.category->zones;
  return needs_no_zone(thing) || std::any_of(zones.begin(), zones.end(), [&](const UseZone& zone) {
           return flooded.reaches(zone_footprint(thing.footprint, zone)) &&
                  zone_is_free(room, things, thing, zone);
         });
}

OccupancyGrid make_occupancy_grid(const Room& room, std::span<const FloorThing> things) {
  OccupancyGrid map(room);
  for (const auto& thing : things)
    if (blocks_floor(*thing.object, *thing.category)) map.add(thing.footprint);
  map.flood();
  return map;
}

}  // namespace roomgen
