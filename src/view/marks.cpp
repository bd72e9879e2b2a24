#include "marks.h"

#include <algorithm>

#include "label_placer.h"
#include "object_labels.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double letters_at_1024 = 11.0;
constexpr double part_letters_at_1024 = 20.0;  // small pictures, few words
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
  strokes.push_back({mark.look, std::move(outline)});
  if (mark.arrow_end != mark.arrow_start && mark.look != Drawing::Line::overhead)
    strokes.push_back({Drawing::Line::arrow, {mark.arrow_start, mark.arrow_end}});
}

bool hangs(const Object& object) {
  return object.mount == Mount::wall || object.mount == Mount::ceiling;
}

// Nearly as high as the sill of a window before which it stands: what may be there depends on
// centimetres.
bool nearly_reaches_sill(const Room& room, const Object& object) {
  constexpr double near = 0.8;
  return object.mount == Mount::floor && !object.traits.flat &&
         std::any_of(room.openings.begin(), room.openings.end(), [&](const Opening& opening) {
           return opening.type == OpeningType::window && object.size.z() >= near * opening.sill &&
                  overlaps(footprint(object), window_clearance(room, opening));
         });
}

std::vector<detail::ObjectMark> object_marks(const Scene& scene, const Camera& camera,
                                             const View& view) {
  std::vector<detail::ObjectMark> marks;
  const auto is_named = [&](const std::string& id) {
    return std::find(view.in_the_way.begin(), view.in_the_way.end(), id) != view.in_the_way.end();
  };
  for (const auto& object : scene.objects) {
    auto mark = detail::object_mark(object, camera);
    if (is_outline_only(scene, view, object)) mark.look = Drawing::Line::overhead;
    if (nearly_reaches_sill(scene.room, object))
      mark.text += " h " + format_number(object.size.z(), 2);
    mark.may_be_nameless = object.mount == Mount::surface || mark.look == Drawing::Line::overhead;
    if (is_named(object.id)) mark.look = Drawing::Line::in_the_way, mark.may_be_nameless = false;
    marks.push_back(std::move(mark));
  }
  const Bounds2 picture{Vec2::Zero(), Vec2(camera.width, camera.height)};
  for (const auto& object : view.refused) {
    auto mark = detail::object_mark(object, camera);
    mark.look = Drawing::Line::refused;
    // Who answers may have meant any place.
    if (picture.overlaps({mark.center, mark.center})) marks.push_back(std::move(mark));
  }
  return marks;
}

double pixels_of_floor(const Room& room, const Camera& camera) {
  return area(room.polygon) * camera.pixels_per_metre * camera.pixels_per_metre;
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
  auto marks = object_marks(scene, camera, view);
  if (!view.part)
    detail::name_marks(marks, letters, pixels_of_floor(scene.room, camera), placer,
                       drawing.strokes);
  detail::lay_grid(scene.room, camera, view.paper_frame, letters, placer, drawing.strokes);

  for (const auto& box : view.free_floor)
    drawing.strokes.push_back({Drawing::Line::free, outline_of(box, camera)});

  if (!view.part)
    detail::place_part_labels(scene.room, camera, letters, placer, detail::PartNames::titles);
  for (const auto& mark : marks) add_object_strokes(mark, drawing.strokes);
  if (!detail::place_object_labels(marks, letters, placer, drawing.strokes)) return std::nullopt;

  detail::lay_grid_points(scene, camera, view.paper_frame, 0.72 * letters, placer,
                          drawing.strokes);
  drawing.labels = placer.labels();
  return drawing;
}

// As large as can be.
Drawing largest_layout(const Scene& scene, const Camera& camera, const View& view) {
  const double longest = std::max(camera.width, camera.height);
  const double letters_wanted = view.part ? part_letters_at_1024 : letters_at_1024;
  double letters = std::max(letters_wanted * longest / 1024.0, smallest_letters);
  for (;; letters *= shrink) {
    if (auto drawing = try_layout(scene, camera, view, letters)) return *drawing;
    // So many objects or so few pixels that nobody could read them anyway: what fits must do.
    if (letters < 1.0) return {};
  }
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

// The part as a room of its own, with what is in it.
Scene part_of(const Scene& scene, const Bounds2& part) {
  Scene framed = scene;
  framed.room.openings.clear();
  set_rectangle(part, framed.room);
  std::erase_if(framed.objects, [&](const Object& object) {
    const Vec2 at = object.position.head<2>();
    return hangs(object) || (at - part.low).minCoeff() < 0.0 || (part.high - at).minCoeff() < 0.0;
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
  double widest = 0.0, width = 0.0, height = 1.75;
  for (const char c : text) {
    if (c == '\n')
      width = 0.0, height += line_spacing;
    else
      widest = std::max(widest, width += advance(c));
  }
  return {letter_height * (widest + 0.5), letter_height * height};
}

bool is_outline_only(const Scene& scene, const View& view, const Object& object) {
  if (!hangs(object) || view.asked == Mount::wall || view.asked == Mount::ceiling) return false;
  if (view.asked || object.mount == Mount::ceiling) return true;
  return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& other) {
    return !hangs(other) && !other.traits.flat && top(other) <= bottom(object) + 1e-3 &&
           overlaps(footprint(object), footprint(other));
  });
}

Drawing layout_marks(const Scene& scene, const Camera& camera, const View& view) {
  if (view.part) return largest_layout(part_of(scene, *view.part), camera, view);
  Drawing drawing =
      largest_layout(scene.rooms.empty() ? scene : with_one_room(scene), camera, view);
  for (const auto& part : parts_of(scene)) detail::lay_clear_zones(part, camera, drawing.strokes);
  return drawing;
}

}  // namespace roomgen
