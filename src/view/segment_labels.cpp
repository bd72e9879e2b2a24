#include <algorithm>

#include "label_placer.h"
#include "marks.h"
#include "object_labels.h"

namespace roomgen {

namespace {

constexpr double segment_letters_at_1024 = 12.5, least_segment_letters = 4.0;
constexpr double readable_letters = 8.0;  // pixels
constexpr double segment_shrink = 0.9;
constexpr double most_covered = 0.3;  // by names, of what they are the names of

// The rectangle around all rooms: what coordinates are written beside.
Room room_around(const Scene& scene) {
  Bounds2 box;
  for (const auto& room : rooms_of(scene))
    for (const auto& p : room.polygon.points) box.add(p);
  Room around;
  around.polygon.points = {box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
  return around;
}

std::vector<detail::ObjectMark> shown_marks(const Scene& scene, const Camera& camera) {
  std::vector<detail::ObjectMark> marks;
  for (const auto& object : scene.objects)
    if (object.mount != Mount::ceiling) marks.push_back(detail::object_mark(object, camera));
  return marks;
}

void name_room(const Room& room, const Camera& camera, double letters, detail::LabelPlacer& placer) {
  const Bounds2 box = bounds(room.polygon);
  const Vec2 middle = 0.5 * (box.low + box.high);
  placer.place({Drawing::Text::part, room.id, camera.pixel({middle.x(), middle.y(), 0.0}),
                label_size(room.id, letters)});
}

double area_of(const std::vector<detail::ObjectMark>& marks) {
  double area = 0.0;
  for (const auto& mark : marks) area += std::abs(signed_area(mark.outline));
  return area;
}

double area_of_names(const Drawing& drawing) {
  double area = 0.0;
  for (const auto& label : drawing.labels)
    if (label.kind == Drawing::Text::object) area += label.size.x() * label.size.y();
  return area;
}

// The whole layout with letters of this height, or nothing if an object's label does not fit.
std::optional<Drawing> try_segment_labels(const Scene& scene, const Camera& camera, double letters) {
  detail::LabelPlacer placer(camera.width, camera.height);
  Drawing drawing;
  drawing.text_height = letters;
  detail::lay_grid(room_around(scene), camera, false, letters, placer, drawing.strokes);
  std::erase_if(drawing.strokes, [](const auto& stroke) { return stroke.kind == Drawing::Line::grid; });
  // Behind the walls of a dwelling's room are others.
  const auto names = scene.rooms.empty() ? detail::PartNames::ids : detail::PartNames::inside;
  for (const auto& room : scene.rooms) name_room(room, camera, letters, placer);
  for (const auto& room : rooms_of(scene))
    detail::place_part_labels(room, camera, letters, placer, names);
  const auto marks = shown_marks(scene, camera);
  for (const auto& mark : marks)
    if (mark.arrow_end != mark.arrow_start)
      drawing.strokes.push_back({Drawing::Line::front, {mark.arrow_start, mark.arrow_end}});
  if (!detail::place_object_labels(marks, letters, placer, drawing.strokes)) return std::nullopt;
  drawing.labels = placer.labels();
  return drawing;
}

}  // namespace

Drawing layout_segment_labels(const Scene& scene, const Camera& camera) {
  const double wanted = segment_letters_at_1024 * std::max(camera.width, camera.height) / 1024.0;
  const double things = area_of(shown_marks(scene, camera));
  for (double letters = std::max(wanted, least_segment_letters); letters >= 1.0; letters *= segment_shrink) {
    auto drawing = try_segment_labels(scene, camera, letters);
    // Small things shall not vanish under their names, as long as these can be read.
    if (drawing && (letters <= readable_letters || area_of_names(*drawing) < most_covered * things)) return *drawing;
  }
  // So many objects or so few pixels that nobody could read them anyway.
  return {};
}

}  // namespace roomgen
