#include "label_placer.h"

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
  for (const double off : {-(wall + reach + 2.0), reach + 3.0}) {
    if (off < 0 && where.inside_only) continue;
    for (const double step : slides)
      if (placer.place({Drawing::Text::part, id, middle + off * into + step * slide * along, size}))
        return;
  }
}

}  // namespace

void place_part_labels(const Room& room, const Camera& camera, double letter_height,
                       LabelPlacer& placer, bool inside_only) {
  for (const auto& opening : room.openings)
    place_beside({segment(room, opening), inward(room, opening), inside_only}, opening.id, camera, letter_height,
                 placer);
  for (std::size_t k = 0; k < room.polygon.size(); ++k)
    place_beside({room.polygon.edge(k), room.polygon.inward(k), inside_only}, "wall-" + std::to_string(k), camera,
                 letter_height, placer);
}

}  // namespace roomgen::detail
