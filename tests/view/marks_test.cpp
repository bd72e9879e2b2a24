#include "view/marks.h"

#include <map>

#include "catch.h"
#include "roomgen/base/text.h"
#include "support/furnished_room.h"

using namespace roomgen;

namespace {

struct Laid {
  Camera camera;
  Drawing drawing;
};

Laid lay(const Scene& scene, View view) {
  view.marks = true;
  const auto camera = make_camera(scene, view);
  REQUIRE(camera);
  return {*camera, layout_marks(scene, *camera, view)};
}

Laid lay(const Scene& scene, bool paper = false, int pixels = 1024) {
  View view;
  view.pixels = pixels;
  view.paper_frame = paper;
  return lay(scene, view);
}

bool overlap(const Drawing::Label& a, const Drawing::Label& b) {
  const double dx = std::abs(a.center.x() - b.center.x()),
               dy = std::abs(a.center.y() - b.center.y());
  return dx < 0.5 * (a.size.x() + b.size.x()) - 1e-9 && dy < 0.5 * (a.size.y() + b.size.y()) - 1e-9;
}

std::vector<Drawing::Label> labels_of(const Drawing& drawing, Drawing::Text kind) {
  std::vector<Drawing::Label> result;
  for (const auto& label : drawing.labels)
    if (label.kind == kind) result.push_back(label);
  return result;
}

// The ids that a name in the picture stands for: "bed-0", or by the legend "b3" and "b3..5,8";
// heights are left away.
std::vector<std::string> ids_of(const std::string& text, const Drawing& drawing) {
  std::string name = text.substr(0, text.find(" h "));
  for (const auto& line : labels_of(drawing, Drawing::Text::legend)) {
    const auto sides = split(line.text, '=');
    const auto letters = name.find_first_of("0123456789");
    if (name.substr(0, letters) != sides[0]) continue;
    std::vector<std::string> ids;
    for (const auto& run : split(name.substr(letters), ',')) {
      const auto dots = run.find("..");
      const int first = std::stoi(run),
                last = dots == std::string::npos ? first : std::stoi(run.substr(dots + 2));
      for (int i = first; i <= last; ++i) ids.push_back(sides[1] + "-" + std::to_string(i));
    }
    return ids;
  }
  return {name};
}

std::vector<const Drawing::Stroke*> strokes_of(const Drawing& drawing, Drawing::Line kind) {
  std::vector<const Drawing::Stroke*> found;
  for (const auto& stroke : drawing.strokes)
    if (stroke.kind == kind) found.push_back(&stroke);
  return found;
}

// Around the floor between these corners?
bool is_around(const Drawing::Stroke& stroke, const Camera& camera, const Vec2& low,
               const Vec2& high) {
  Bounds2 box, wanted;
  for (const auto& p : stroke.points) box.add(p);
  wanted.add(camera.pixel({low.x(), low.y(), 0.0}));
  wanted.add(camera.pixel({high.x(), high.y(), 0.0}));
  return (box.low - wanted.low).norm() < 1e-6 && (box.high - wanted.high).norm() < 1e-6;
}

bool any_around(const Laid& laid, Drawing::Line kind, const Vec2& low, const Vec2& high) {
  const auto strokes = strokes_of(laid.drawing, kind);
  return std::any_of(strokes.begin(), strokes.end(), [&](const auto* stroke) {
    return is_around(*stroke, laid.camera, low, high);
  });
}

bool has_text(const Drawing& drawing, Drawing::Text kind, const std::string& text) {
  const auto labels = labels_of(drawing, kind);
  return std::any_of(labels.begin(), labels.end(),
                     [&](const auto& label) { return label.text == text; });
}

Object hanging(const std::string& id, Mount mount, const Vec3& size, const Vec3& position) {
  Object object = test::box(id, size, position);
  object.mount = mount;
  return object;
}

}  // namespace

TEST_CASE("no two labels overlap and all lie in the picture, in 100 random scenes") {
  for (int seed = 0; seed < 100; ++seed) {
    const Scene scene = test::random_scene(seed);
    const auto [camera, drawing] = lay(scene, seed % 2 == 1, seed % 3 == 0 ? 640 : 1024);
    INFO("seed " << seed << ", " << scene.objects.size() << " objects");
    std::size_t overlaps = 0, outside = 0;
    for (std::size_t i = 0; i < drawing.labels.size(); ++i) {
      const auto& label = drawing.labels[i];
      const Vec2 low = label.center - 0.5 * label.size, high = label.center + 0.5 * label.size;
      outside += low.x() < 0 || low.y() < 0 || high.x() > camera.width || high.y() > camera.height;
      for (std::size_t j = 0; j < i; ++j) overlaps += overlap(label, drawing.labels[j]);
    }
    CHECK(overlaps == 0);
    CHECK(outside == 0);
  }
}

TEST_CASE(
    "every object is named once, near itself or tied to it, and what is on others where there is "
    "room") {
  for (int seed = 0; seed < 40; ++seed) {
    const Scene scene = test::random_scene(seed);
    const auto [camera, drawing] = lay(scene);
    std::map<std::string, std::vector<Drawing::Label>> named;
    for (const auto& label : labels_of(drawing, Drawing::Text::object))
      for (const auto& id : ids_of(label.text, drawing)) named[id].push_back(label);
    CHECK(named.size() == scene.objects.size());
    for (const auto& object : scene.objects) {
      INFO("seed " << seed << ", " << object.id);
      REQUIRE(named[object.id].size() == 1);
      const auto& label = named[object.id].front();
      const Vec2 center = camera.pixel(object.position);
      // The label's point on the floor, turned into the object's frame.
      const Vec2 metres((label.center.x() - center.x()) / camera.pixels_per_metre,
                        (center.y() - label.center.y()) / camera.pixels_per_metre);
      const Vec2 local = rotated(metres, -object.yaw).cwiseAbs();
      const bool on_object =
          local.x() <= 0.5 * object.size.x() && local.y() <= 0.5 * object.size.y();
      const auto leaders = strokes_of(drawing, Drawing::Line::leader);
      const bool tied = std::any_of(leaders.begin(), leaders.end(), [&](const auto* leader) {
        return std::any_of(leader->points.begin(), leader->points.end(),
                           [&](const Vec2& p) { return (p - center).norm() < 0.5; });
      });
      CHECK((on_object || tied));
    }
  }
  CHECK(has_text(lay(test::furnished_room()).drawing, Drawing::Text::object, "lamp-0"));
}

TEST_CASE(
    "rows of one kind share a name where single ones would not fit, and small things have none") {
  Scene scene;
  scene.room = test::plain_room();
  scene.room.polygon.points = {{0, 0}, {18, 0}, {18, 12}, {0, 12}};
  for (int i = 0; i < 60; ++i)
    scene.objects.push_back(test::box("folding chair-" + std::to_string(i), {0.4, 0.4, 0.8},
                                      {2.0 + 0.5 * (i % 20), 3.0 + 1.5 * (i / 20), 0.0}));
  for (int i = 0; i < 60; ++i)
    scene.objects.push_back(hanging("book-" + std::to_string(i), Mount::surface, {0.2, 0.2, 0.05},
                                    scene.objects[i].position + Vec3(0.0, 0.0, 0.45)));
  const auto [camera, drawing] = lay(scene);
  for (const char* row : {"fc0..19", "fc20..39", "fc40..59"})
    CHECK(has_text(drawing, Drawing::Text::object, row));
  CHECK(labels_of(drawing, Drawing::Text::object).size() == 3);
  CHECK(has_text(drawing, Drawing::Text::legend, "fc = folding chair"));
}

TEST_CASE("what hangs over things is an outline, unless the question is about what hangs") {
  Scene scene = test::furnished_room();
  scene.objects.push_back(
      hanging("wall cabinet-0", Mount::wall, {0.8, 0.35, 0.7}, {0.4, 2.0, 1.4}));  // over the desk
  scene.objects.push_back(hanging("mirror-0", Mount::wall, {0.6, 0.04, 0.9}, {3.5, 0.02, 1.0}));
  scene.objects.push_back(hanging("lamp-1", Mount::ceiling, {0.4, 0.4, 0.5}, {3.4, 0.7, 2.2}));
  const auto outlined = [&](std::optional<Mount> asked) {
    View view;
    view.asked = asked;
    std::string found;
    for (const auto& object : scene.objects)
      if (is_outline_only(scene, view, object)) found += object.id + " ";
    CHECK(strokes_of(lay(scene, view).drawing, Drawing::Line::overhead).size() ==
          static_cast<std::size_t>(std::count(found.begin(), found.end(), '-')));
    return found;
  };
  CHECK(outlined({}) == "wall cabinet-0 lamp-1 ");
  CHECK(outlined(Mount::floor) == "wall cabinet-0 mirror-0 lamp-1 ");
  CHECK(outlined(Mount::surface) == "wall cabinet-0 mirror-0 lamp-1 ");
  CHECK(outlined(Mount::wall).empty());
  CHECK(outlined(Mount::ceiling).empty());
}

TEST_CASE(
    "the way of doors, strips before windows and the one side of use are hatched, with the heights "
    "that count") {
  Scene scene;
  scene.room = test::plain_room();
  scene.objects = {test::box("sideboard-0", {1.2, 0.4, 0.8}, {2.0, 2.8, 0.0}),
                   test::box("wardrobe-0", {1.0, 0.6, 2.0}, {3.5, 0.3, 0.0}, radians(180))};
  const Laid laid = lay(scene);
  CHECK(any_around(laid, Drawing::Line::keep_clear, {0.5, 0.0}, {1.4, door_approach}));
  CHECK(any_around(laid, Drawing::Line::keep_clear, {1.0, 3.0 - window_strip}, {3.0, 3.0}));
  CHECK(strokes_of(laid.drawing, Drawing::Line::use).size() == 2);
  CHECK(has_text(laid.drawing, Drawing::Text::part, "window-0, sill 0.9, head 2.1"));
  CHECK(has_text(laid.drawing, Drawing::Text::part, "wall-2 north"));
  CHECK(has_text(laid.drawing, Drawing::Text::object, "sideboard-0 h 0.8"));
  CHECK(has_text(laid.drawing, Drawing::Text::object, "wardrobe-0"));
}

TEST_CASE(
    "an answer that was refused is drawn where it would have put things, with what is in the way") {
  const Scene scene = test::furnished_room();
  View view;
  view.refused = {test::box("sofa-0", {2.0, 0.8, 0.8}, {2.5, 2.0, 0.0}),
                  test::box("sofa-1", {2.0, 0.8, 0.8}, {250.0, 2.0, 0.0})};  // nowhere
  view.in_the_way = {"bed-0"};
  const Laid laid = lay(scene, view);
  CHECK(any_around(laid, Drawing::Line::refused, {1.5, 1.6}, {3.5, 2.4}));
  CHECK(strokes_of(laid.drawing, Drawing::Line::refused).size() == 1);
  CHECK(any_around(laid, Drawing::Line::in_the_way, {1.8, 1.0}, {3.4, 3.0}));
  CHECK(has_text(laid.drawing, Drawing::Text::red, "sofa-0"));
  CHECK(has_text(laid.drawing, Drawing::Text::red, "bed-0"));
}

TEST_CASE("an elevation shows walls from inside, with coordinates of the room") {
  Scene scene = test::furnished_room();
  scene.objects.push_back(hanging("mirror-0", Mount::wall, {0.6, 0.04, 0.9}, {3.5, 0.02, 1.0}));
  scene.objects.back().yaw = radians(180);  // on wall-0, looking north
  View view;
  view.kind = View::Kind::elevation;
  view.refused = {scene.objects.back()};
  view.refused.back().id = "mirror-1";
  view.refused.back().position = {2.2, 0.3, 1.2};
  const auto sheet = layout_elevation(scene, view);
  REQUIRE(sheet);
  CHECK(std::max(sheet->width, sheet->height) == view.pixels);
  const auto walls = strokes_of(sheet->drawing, Drawing::Line::paper);
  REQUIRE(walls.size() == 4);
  Bounds2 south, mirror, door;
  for (const auto& p : walls[0]->points) south.add(p);
  const auto hung = strokes_of(sheet->drawing, Drawing::Line::hung);
  REQUIRE(hung.size() == 1);
  for (const auto& p : hung[0]->points) mirror.add(p);
  for (const auto& p : strokes_of(sheet->drawing, Drawing::Line::hole).at(0)->points) door.add(p);
  // Who looks south has x = 4 at the left.
  const double scale = south.size().x() / 4.0;
  CHECK(south.size().y() == Approx(default_room_height * scale));
  CHECK(mirror.low.x() == Approx(south.low.x() + (4.0 - 3.8) * scale));
  CHECK(mirror.high.y() == Approx(south.high.y() - 1.0 * scale));
  CHECK(door.high.x() == Approx(south.high.x() - 0.5 * scale));
  CHECK(has_text(sheet->drawing, Drawing::Text::object, "mirror-0 z 1"));
  CHECK(has_text(sheet->drawing, Drawing::Text::red, "mirror-1 z 1.2"));
  CHECK(has_text(sheet->drawing, Drawing::Text::part, "wall-0 south (x)"));
  int ticks = 0;
  for (const auto& label : labels_of(sheet->drawing, Drawing::Text::tick)) {
    const bool below = label.center.x() > south.low.x() - 1 &&
                       label.center.x() < south.high.x() + 1 && label.center.y() > south.high.y() &&
                       label.center.y() < south.high.y() + 0.35 * scale;
    if (!below) continue;
    CHECK(label.center.x() == Approx(south.high.x() - std::stod(label.text) * scale));
    ++ticks;
  }
  CHECK(ticks == 9);
  view.pixels = 1;
  CHECK_FALSE(layout_elevation(scene, view));
}

TEST_CASE("coordinates stand where the coordinate is, in both frames") {
  const Scene scene = test::furnished_room();  // 4 x 3 m
  for (const bool paper : {false, true}) {
    const auto [camera, drawing] = lay(scene, paper);
    const Vec2 low = camera.pixel({0, 0, 0}), high = camera.pixel({4, 3, 0});
    int along_x = 0, along_y = 0;
    for (const auto& label : labels_of(drawing, Drawing::Text::tick)) {
      const double value = std::stod(label.text);
      const bool beside_room = label.center.x() < low.x() || label.center.x() > high.x();
      INFO((paper ? "paper " : "plan ") << label.text);
      if (beside_room) {  // measures up the page, or down from the top
        const double y = paper ? 3.0 - value : value;
        CHECK(label.center.y() == Approx(low.y() + y / 3.0 * (high.y() - low.y())).margin(0.01));
        ++along_y;
      } else {  // to the right, or to the left from the right
        const double x = paper ? 4.0 - value : value;
        CHECK(label.center.x() == Approx(low.x() + x / 4.0 * (high.x() - low.x())).margin(0.01));
        ++along_x;
      }
    }
    CHECK(along_x == 2 * 9);  // 0, 0.5, …, 4 above and below
    CHECK(along_y == 2 * 7);
  }
}

TEST_CASE("points of the grid carry both coordinates of their crossing") {
  const Scene scene = test::furnished_room();
  for (const bool paper : {false, true}) {
    const auto [camera, drawing] = lay(scene, paper);
    const auto points = labels_of(drawing, Drawing::Text::point);
    CHECK(points.size() >= 3);
    for (const auto& label : points) {
      const auto pieces = split(label.text, ',');
      const double a = std::stod(pieces[0]), b = std::stod(pieces[1]);
      const Vec2 room = paper ? Vec2(4.0 - b, 3.0 - a) : Vec2(a, b);
      const Vec2 crossing = camera.pixel({room.x(), room.y(), 0});
      CHECK((label.center - crossing).norm() < label.size.norm());
    }
  }
}

TEST_CASE("the paper's frame counts from the far corner and back") {
  const Room room = test::l_shaped_room();  // to x = 6, y = 5
  CHECK(mark_from_room(room, {6, 5}, true) == Vec2(0, 0));
  CHECK(mark_from_room(room, {1, 2}, true) == Vec2(3, 5));
  CHECK(mark_from_room(room, {1, 2}, false) == Vec2(1, 2));
  for (const bool paper : {false, true})
    CHECK(room_from_mark(room, mark_from_room(room, {1.25, 3.5}, paper), paper) == Vec2(1.25, 3.5));
}

TEST_CASE("arrows point to the fronts, and only things with a front have one") {
  Scene scene = test::furnished_room();
  const auto [camera, drawing] = lay(scene);
  std::vector<Drawing::Stroke> arrows;
  for (const auto& stroke : drawing.strokes)
    if (stroke.kind == Drawing::Line::arrow) arrows.push_back(stroke);
  REQUIRE(arrows.size() == 3);  // bed, desk, chair
  const Vec2 desk = arrows[1].points.back() - arrows[1].points.front();
  CHECK(desk.x() > 0);  // yaw 90: the front looks to +X
  CHECK(std::abs(desk.y()) < 1e-6);
  const Vec2 bed = arrows[0].points.back() - arrows[0].points.front();
  CHECK(bed.y() > 0);  // yaw 0: down the page
}

TEST_CASE("the grid grows coarser with the room") {
  Room room = test::plain_room();
  CHECK(grid_step(room) == 0.5);
  room.polygon.points = {{0, 0}, {9, 0}, {9, 3}, {0, 3}};
  CHECK(grid_step(room) == 1.0);
  room.polygon.points = {{0, 0}, {19, 0}, {19, 3}, {0, 3}};
  CHECK(grid_step(room) == 2.0);
}

TEST_CASE("grid lines stay inside a room with a corner cut out") {
  Scene scene;
  scene.room = test::l_shaped_room();
  const auto [camera, drawing] = lay(scene);
  for (const auto& stroke : drawing.strokes) {
    if (stroke.kind != Drawing::Line::grid) continue;
    const Vec2 middle = 0.5 * (stroke.points[0] + stroke.points[1]) - camera.pixel({0, 0, 0});
    const Vec2 room(middle.x() / camera.pixels_per_metre, -middle.y() / camera.pixels_per_metre);
    CHECK_FALSE((room.x() > 4.001 && room.y() > 3.001));
  }
}

TEST_CASE("a picture too small for its labels still gets what fits") {
  const Scene scene = test::random_scene(3);
  const auto [camera, drawing] = lay(scene, false, min_picture_pixels);
  for (const auto& label : drawing.labels) CHECK(label.center.x() <= camera.width);
}

TEST_CASE("a door is drawn open with the arc of its swing") {
  Scene scene;
  scene.room = test::plain_room();  // door from x = 0.5 to 1.4 in the south wall, hinge at 0.5
  const auto camera = lay(scene).camera;
  const Drawing drawing = plan_symbols(rooms_of(scene), camera);
  const Vec2 hinge = camera.pixel({0.5, 0, 0}), open = camera.pixel({0.5, 0.9, 0}),
             shut = camera.pixel({1.4, 0, 0});
  bool has_leaf = false, has_arc = false;
  for (const auto& stroke : drawing.strokes) {
    const auto &first = stroke.points.front(), &last = stroke.points.back();
    has_leaf = has_leaf || ((first - hinge).norm() < 1e-6 && (last - open).norm() < 1e-6);
    has_arc = has_arc || ((first - shut).norm() < 1e-6 && (last - open).norm() < 1e-6);
  }
  CHECK(has_leaf);
  CHECK(has_arc);
}
