#pragma once

#include <span>
#include <vector>

#include "occupancy_grid.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// A placed thing with what is asked of it again and again.
struct FloorThing {
  const Object* object = nullptr;
  const Kind* category = nullptr;
  Footprint footprint;
};
FloorThing floor_thing(const Object& object, const KindTable& categories);
std::vector<FloorThing> floor_things(std::span<const Object> objects,
                                     const KindTable& categories);

/// Does the thing stand in the way of a person's feet or body? Not rugs, things on tables, lamps on
/// the ceiling, pictures on the wall and curtains, which give way, nor a parasol, which hangs above.
bool blocks_floor(const Object& object, const Kind& category);

/// May one slide under the other (a chair, a table, all a parasol) when their meshes allow it?
bool tucks(const Kind& a, const Kind& b);

/// Does the other thing stand in `area`, the zone's footprint, where it must not?
bool blocks_zone(const FloorThing& other, const FloorThing& owner, const UseZone& zone,
                 const Footprint& area);

/// Is the zone inside the room and free of others than the object itself and the zone's partners?
bool zone_is_free(const Room& room, std::span<const FloorThing> things, const FloorThing& owner,
                  const UseZone& zone);

/// Has its kind no use zones, or does it hang, lie flat or stand on others?
bool needs_no_zone(const FloorThing& thing);

/// Has the thing a free zone, reachable or not? True for things without zones.
bool has_free_zone(const Room& room, std::span<const FloorThing> things, const FloorThing& thing);

/// Is one of the object's use zones free and, in the flooded map, reachable? Things without zones
/// always are, and so are things that stand on others or hang.
bool is_usable(const Room& room, std::span<const FloorThing> things, const FloorThing& thing,
               const OccupancyGrid& flooded);

/// A map of the room with all its objects in it, flooded.
OccupancyGrid make_occupancy_grid(const Room& room, std::span<const FloorThing> things);

}  // namespace roomgen
