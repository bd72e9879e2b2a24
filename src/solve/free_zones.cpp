#include "free_zones.h"

namespace roomgen {

namespace {

// Those in which the thing stands have one blocker more, or less.
void count_in(const FloorThing& thing, const FloorThing& owner, std::vector<FreeZones::Zone>& zones,
              int change) {
  for (std::size_t z = 0; z < zones.size(); ++z)
    if (blocks_zone(thing, owner, owner.category->zones[z], zones[z].area))
      zones[z].blockers += change;
}

}  // namespace

void FreeZones::add(const Room& room, std::span<const FloorThing> things) {
  const FloorThing& own = things.back();
  auto& zones = zones_.emplace_back();
  if (!needs_no_zone(own))
    for (const auto& zone : own.category->zones) {
      const Footprint area = zone_footprint(own.footprint, zone);
      zones.push_back({area, zone_is_free(room, {}, own, zone), 0});
    }
  for (std::size_t i = 0; i + 1 < things.size(); ++i) {
    count_in(things[i], own, zones, +1);
    count_in(own, things[i], zones_[i], +1);
  }
}

void FreeZones::remove(std::span<const FloorThing> things, std::size_t i) {
  for (std::size_t j = 0; j < things.size(); ++j)
    if (j != i) count_in(things[i], things[j], zones_[j], -1);
  zones_.erase(zones_.begin() + static_cast<std::ptrdiff_t>(i));
}

}  // namespace roomgen
