#include <algorithm>

#include "label_placer.h"
#include "roomgen/base/text.h"
#include "scene/wall_sides.h"

namespace roomgen::detail {

namespace {

// Of the label's own extent along the line.
constexpr double slides[] = {0.0, 0.8, -0.8, 1.6, -1.6, 2.4, -2.4};

Vec2 pixel_at(const Camera& camera, const Vec2& point) {
  return camera.pixel({point.x(), point.y(), 0.0});
}

// Where of a line a label goes.
struct Beside {
  Segment line;
  Vec2 inward;
  bool inside_only;
};

// Beside the middle of a line of the room, or a little along it.
void place_beside(const Beside& where, const std::string& id, const Camera& camera, double letter_height,
                  LabelPlacer& placer) {
  const Segment& line = where.line;
  const Vec2 size = label_size(id, letter_height);
  const Vec2 middle = pixel_at(camera, line.middle());
  const Vec2 along = (pixel_at(camera, line.b) - pixel_at(camera, line.a)).normalized();
  const Vec2 into = (pixel_at(camera, line.middle() + where.inward) - middle).normalized();
  const double reach = 0.5 * into.cwiseAbs().dot(size), slide = along.cwiseAbs().dot(size);
  const double wall = wall_thickness * camera.pixels_per_metre;
  // Beside the wall, beyond the coordinates there, or inside.
  for (const double off :
       {-(wall + reach + 2.0), -(wall + reach + 2.0 + 2.2 * letter_height), reach + 3.0}) {
    if (off < 0 && where.inside_only) continue;
    for (const double step : slides)
      if (placer.place({Drawing::Text::part, id, middle + off * into + step * slide * along, size}))
        return;
  }
}

}  // namespace

std::string wall_title(const Room& room, std::size_t wall, const std::string& separator) {
  const std::string id = "wall-" + std::to_string(wall);
  for (const char* side : {"south", "east", "north", "west"}) {
    const auto walls = walls_named(room, side);
    if (std::find(walls.begin(), walls.end(), wall) != walls.end()) return id + separator + side;
  }
  return id;
}

std::string opening_title(const Opening& opening, const std::string& separator) {
  if (opening.type != OpeningType::window) return opening.id;
  return opening.id + separator + "sill " + format_number(opening.sill, 2) + separator + "head " +
         format_number(opening.head, 2);
}

void place_part_labels(const Room& room, const Camera& camera, double letter_height,
                       LabelPlacer& placer, PartNames names) {
  const bool inside_only = names == PartNames::inside, titles = names == PartNames::titles;
  const auto is_upright = [&](std::size_t wall) {
    return std::abs(room.polygon.inward(wall).x()) > 0.7;
  };
  for (const auto& opening : room.openings)
    place_beside(
        {segment(room, opening), inward(room, opening), inside_only},
        titles ? opening_title(opening, is_upright(opening.wall) ? "\n" : ", ") : opening.id,
        camera, letter_height, placer);
  for (std::size_t k = 0; k < room.polygon.size(); ++k)
    place_beside(
        {room.polygon.edge(k), room.polygon.inward(k), inside_only},
        titles ? wall_title(room, k, is_upright(k) ? "\n" : " ") : "wall-" + std::to_string(k),
        camera, letter_height, placer);
}

}  // namespace roomgen::detail
