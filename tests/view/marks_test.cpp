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

Laid lay(const Scene& scene, bool paper = false, int pixels = 1024) {
  View view;
  view.pixels = pixels;
  view.marks = true;
  view.paper_frame = paper;
  const auto camera = make_camera(scene, view);
  REQUIRE(camera);
  return {*camera, layout_marks(scene, *camera, view)};
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

const Drawing::Label& label_of(const Drawing& drawing, const std::string& text) {
  for (const auto& label : drawing.labels)
    if (label.kind == Drawing::Text::object && label.text == text) return label;
  throw std::runtime_error("no label " + text);
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

TEST_CASE("every object is named once, near itself or tied to it") {
  for (int seed = 0; seed < 40; ++seed) {
    const Scene scene = test::random_scene(seed);
    const auto [camera, drawing] = lay(scene);
    std::map<std::string, int> count;
    for (const auto& label : labels_of(drawing, Drawing::Text::object)) ++count[label.text];
    CHECK(count.size() == scene.objects.size());
    for (const auto& object : scene.objects) {
      INFO("seed " << seed << ", " << object.id);
      REQUIRE(count[object.id] == 1);
      const auto& label = label_of(drawing, object.id);
      const Vec2 center = camera.pixel(object.position);
      CHECK((label.center - center).norm() < 0.3 * std::max(camera.width, camera.height));
      // The label's point on the floor, turned into the object's frame.
      const Vec2 metres((label.center.x() - center.x()) / camera.pixels_per_metre,
                        (center.y() - label.center.y()) / camera.pixels_per_metre);
      const Vec2 local = rotated(metres, -object.yaw).cwiseAbs();
      const bool on_object =
          local.x() <= 0.5 * object.size.x() && local.y() <= 0.5 * object.size.y();
      const bool tied = std::any_of(drawing.strokes.begin(), drawing.strokes.end(),
                                    [&](const Drawing::Stroke& stroke) {
                                      return stroke.kind == Drawing::Line::leader &&
                                             (stroke.points.back() - center).norm() < 0.5;
                                    });
      CHECK((on_object || tied));
    }
  }
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
