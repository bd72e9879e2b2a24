#include <algorithm>

#include "label_placer.h"

namespace roomgen::detail {

namespace {

constexpr double touching = 0.02;  // metres that count as beside each other

struct Standing {
  const Kind* kind;
  Footprint area;
};

std::vector<Standing> standing_in(const Scene& scene) {
  std::vector<Standing> things;
  for (const auto& object : scene.objects)
    if (object.mount == Mount::floor && !object.traits.flat)
      things.push_back({&KindTable::built_in().get(object.category), footprint(object)});
  return things;
}

// Could somebody stand there who uses the thing? What belongs there is not in the way.
bool is_free(const Room& room, const std::vector<Standing>& things, const Standing& user,
             const UseZone& zone) {
  const Footprint area = zone_footprint(user.area, zone);
  return contains(room.polygon, area, touching) &&
         std::none_of(things.begin(), things.end(), [&](const Standing& other) {
           return &other != &user && !is_any_of(*other.kind, zone.partners) &&
                  overlaps(area, other.area, touching);
         });
}

void add_closed(Drawing::Line kind, const Footprint& area, const Camera& camera,
                std::vector<Drawing::Stroke>& strokes) {
  Drawing::Stroke stroke{kind, {}};
  for (const auto& corner : area.outline())
    stroke.points.push_back(camera.pixel({corner.x(), corner.y(), 0.0}));
  stroke.points.push_back(stroke.points.front());
  strokes.push_back(std::move(stroke));
}

}  // namespace

void lay_clear_zones(const Scene& scene, const Camera& camera,
                     std::vector<Drawing::Stroke>& strokes) {
  for (const auto& opening : scene.room.openings)
    for (const auto& area : clearances(scene.room, opening))
      add_closed(Drawing::Line::keep_clear, area, camera, strokes);
  const auto things = standing_in(scene);
  for (const auto& user : things) {
    std::vector<const UseZone*> free;
    for (const auto& zone : user.kind->zones)
      if (is_free(scene.room, things, user, zone)) free.push_back(&zone);
    // Where there are several, none of them has to stay free.
    if (free.size() == 1)
      add_closed(Drawing::Line::use, zone_footprint(user.area, *free.front()), camera, strokes);
  }
}

}  // namespace roomgen::detail
