#include "marks.h"

#include <algorithm>

#include "label_placer.h"
#include "object_labels.h"

namespace roomgen {

namespace {

constexpr double letters_at_1024 = 11.0;
constexpr double part_letters_at_1024 = 17.0;  // small pictures, few words
constexpr double smallest_letters = 4.0;
constexpr double shrink = 0.88;

// Advance of a character in heights of a capital letter; generous for any plain sans-serif font.
double advance(char c) {
  constexpr std::string_view narrow = ".,:;'|!iljft()1- ", wide = "mwMW";
  if (narrow.find(c) != std::string_view::npos) return 0.75;
  if (wide.find(c) != std::string_view::npos) return 1.35;
  return 0.98;
}

void add_object_strokes(const detail::ObjectMark& mark, std::vector<Drawing::Stroke>& strokes) {
  auto outline = mark.outline;
  outline.push_back(outline.front());
  strokes.push_back({Drawing::Line::outline, std::move(outline)});
  if (mark.arrow_end != mark.center)
    strokes.push_back({Drawing::Line::arrow, {mark.center, mark.arrow_end}});
}

std::vector<Vec2> outline_of(const Bounds2& box, const Camera& camera) {
  std::vector<Vec2> corners;
  for (const Vec2& p : {box.low, Vec2(box.high.x(), box.low.y()), box.high,
                        Vec2(box.low.x(), box.high.y()), box.low})
    corners.push_back(camera.pixel({p.x(), p.y(), 0.0}));
  return corners;
}

// The whole layout with letters of this height, or nothing if the labels do not fit.
std::optional<Drawing> try_layout(const Scene& scene, const Camera& camera, const View& view,
                                  double letters) {
  detail::LabelPlacer placer(camera.width, camera.height);
  Drawing drawing;
  drawing.text_height = letters;
  detail::lay_grid(scene.room, camera, view.paper_frame, letters, placer, drawing.strokes);

  for (const auto& box : view.free_floor)
    drawing.strokes.push_back({Drawing::Line::free, outline_of(box, camera)});

  if (!view.part) detail::place_part_labels(scene.room, camera, letters, placer);
  std::vector<detail::ObjectMark> marks;
  for (const auto& object : scene.objects) marks.push_back(detail::object_mark(object, camera));
  for (const auto& mark : marks) add_object_strokes(mark, drawing.strokes);
  if (!detail::place_object_labels(marks, letters, placer, drawing.strokes)) return std::nullopt;

  detail::lay_grid_points(scene, camera, view.paper_frame, 0.72 * letters, placer,
                          drawing.strokes);
  drawing.labels = placer.labels();
  return drawing;
}

void set_rectangle(const Bounds2& box, Room& room) {
  room.polygon.points = {box.low, {box.high.x(), box.low.y()}, box.high,
                         {box.low.x(), box.high.y()}};
}

// The grid of a dwelling is that of the rectangle around it.
Scene with_one_room(const Scene& scene) {
  Scene framed = scene;
  Bounds2 box;
  for (const auto& room : scene.rooms)
    for (const auto& p : room.polygon.points) box.add(p);
  framed.rooms.clear();
  set_rectangle(box, framed.room);
  return framed;
}

bool is_framed(const Scene& scene, const Bounds2& part) {
  const Bounds2 box = bounds(scene.room.polygon);
  return box.low == part.low && box.high == part.high && scene.room.openings.empty();
}

// The part as a room of its own, with what is in it.
Scene part_of(const Scene& scene, const Bounds2& part) {
  Scene framed = scene;
  framed.room.openings.clear();
  set_rectangle(part, framed.room);
  std::erase_if(framed.objects, [&](const Object& object) {
    const Vec2 at = object.position.head<2>();
    return (at - part.low).minCoeff() < 0.0 || (part.high - at).minCoeff() < 0.0;
  });
  return framed;
}

}  // namespace

double grid_step(const Room& room) {
  const double length = bounds(room.polygon).size().maxCoeff();
  if (length <= 2.0) return length <= 1.0 ? 0.1 : 0.2;
  return length <= 6.5 ? 0.5 : length <= 13.0 ? 1.0 : 2.0;
}

Vec2 mark_from_room(const Room& room, const Vec2& point, bool paper_frame) {
  if (!paper_frame) return point;
  const Vec2 far = bounds(room.polygon).high;
  return {far.y() - point.y(), far.x() - point.x()};
}

Vec2 room_from_mark(const Room& room, const Vec2& mark, bool paper_frame) {
  if (!paper_frame) return mark;
  const Vec2 far = bounds(room.polygon).high;
  return {far.x() - mark.y(), far.y() - mark.x()};
}

Vec2 label_size(const std::string& text, double letter_height) {
  double width = 0.0;
  for (const char c : text) width += advance(c);
  return {letter_height * (width + 0.5), letter_height * 1.75};
}

Drawing layout_marks(const Scene& scene, const Camera& camera, const View& view) {
  if (!scene.rooms.empty()) return layout_marks(with_one_room(scene), camera, view);
  if (view.part && !is_framed(scene, *view.part))
    return layout_marks(part_of(scene, *view.part), camera, view);
  const double longest = std::max(camera.width, camera.height);
  const double letters_wanted = view.part ? part_letters_at_1024 : letters_at_1024;
  double letters = std::max(letters_wanted * longest / 1024.0, smallest_letters);
  for (;; letters *= shrink) {
    if (auto drawing = try_layout(scene, camera, view, letters)) return *drawing;
    // So many objects or so few pixels that nobody could read them anyway: what fits must do.
    if (letters < 1.0) return {};
  }
}

}  // namespace roomgen
