#include <algorithm>

#include "roomgen/view/view.h"
#include "scene/dwelling.h"

namespace roomgen {

bool is_indoors(const Scene& scene, const Vec2& place) {
  const auto rooms = rooms_of(scene);
  return std::any_of(rooms.begin(), rooms.end(), [&](const Room& room) {
    return contains(room.polygon, place) ||
           std::any_of(room.openings.begin(), room.openings.end(), [&](const Opening& opening) {
             return opening.is_entrance() && distance(segment(room, opening), place) <= wall_thickness;
           });
  });
}

}  // namespace roomgen
