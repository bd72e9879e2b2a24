#include "view/camera.h"

#include "catch.h"
#include "support/furnished_room.h"

using namespace roomgen;

namespace {

View view_of(View::Kind kind, int pixels = 1024) {
  View view;
  view.kind = kind;
  view.pixels = pixels;
  return view;
}

bool inside(const Camera& camera, const Vec2& pixel) {
  return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= camera.width &&
         pixel.y() <= camera.height;
}

}  // namespace

TEST_CASE("the top view has x to the right, y up the page and one scale") {
  const auto camera = make_camera(test::furnished_room(), view_of(View::Kind::top));
  REQUIRE(camera);
  const Vec2 origin = camera->pixel({0, 0, 0}), right = camera->pixel({1, 0, 0}),
             up = camera->pixel({0, 1, 2});
  CHECK(right.x() - origin.x() == Approx(camera->pixels_per_metre));
  CHECK(right.y() == Approx(origin.y()));
  CHECK(origin.y() - up.y() == Approx(camera->pixels_per_metre));
  CHECK(up.x() == Approx(origin.x()));
}

TEST_CASE("both views show the whole room and all objects, the longer side as asked") {
  for (const auto kind : {View::Kind::top, View::Kind::isometric})
    for (int seed = 0; seed < 20; ++seed) {
      const Scene scene = test::random_scene(seed);
      const auto camera = make_camera(scene, view_of(kind, 640));
      REQUIRE(camera);
      CHECK(std::max(camera->width, camera->height) == 640);
      for (const auto& p : scene.room.polygon.points)
        CHECK(inside(*camera, camera->pixel({p.x(), p.y(), 0})));
      for (const auto& object : scene.objects)
        for (const auto& corner : box_corners(object)) {
          CHECK(inside(*camera, camera->pixel(corner)));
          CHECK(camera->depth(corner) < camera->near);
          CHECK(camera->depth(corner) > camera->far);
        }
    }
}

TEST_CASE("the corner view keeps the two far walls of a rectangular room") {
  const Scene scene = test::furnished_room();
  const View view = view_of(View::Kind::isometric);
  const auto camera = make_camera(scene, view);
  REQUIRE(camera);
  const auto heights = wall_heights(rooms_of(scene), 0, view, *camera);
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const bool far = scene.room.polygon.inward(k).dot(camera->backward.head<2>()) > 0;
    CHECK(heights[k] == (far ? scene.room.height : hidden_wall_height));
  }
  CHECK(std::count(heights.begin(), heights.end(), scene.room.height) == 2);
}

TEST_CASE("the corner view looks at the fronts of things") {
  Scene scene;
  scene.room = test::plain_room();
  for (const double yaw : {0.0, 90.0, 180.0, -90.0}) {
    scene.objects = {test::box("wardrobe-0", {1.2, 0.6, 2.0}, {2, 1.5, 0}, radians(yaw)),
                     test::box("wardrobe-1", {1.2, 0.6, 2.0}, {2, 1.5, 0}, radians(yaw))};
    const auto camera = make_camera(scene, view_of(View::Kind::isometric));
    REQUIRE(camera);
    CHECK(front_direction(radians(yaw)).dot(camera->backward.head<2>()) > 0);
  }
}

TEST_CASE("a wall that would hide a part of the room is lowered") {
  Scene scene;
  // A U open to the north: the wall at its bottom hides nothing, those of the notch may.
  scene.room.polygon.points = {{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 1.5}, {2, 1.5}, {2, 4}, {0, 4}};
  const View view = view_of(View::Kind::isometric);
  const auto camera = make_camera(scene, view);
  REQUIRE(camera);
  const auto heights = wall_heights(rooms_of(scene), 0, view, *camera);
  const Vec2 away = -camera->backward.head<2>().normalized();
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (heights[k] < scene.room.height) continue;
    const Vec2 behind = scene.room.polygon.edge(k).middle() + 1.0 * away;
    CHECK_FALSE(contains(scene.room.polygon, behind));
  }
}

TEST_CASE("sizes without sense and rooms without a floor are refused") {
  const Scene scene = test::furnished_room();
  for (const int pixels : {0, -5, 1, max_picture_pixels + 1, 2000000000}) {
    const auto camera = make_camera(scene, view_of(View::Kind::top, pixels));
    REQUIRE_FALSE(camera);
    CHECK(camera.error().kind == Error::Kind::invalid_input);
  }
  CHECK_FALSE(make_camera(Scene{}, view_of(View::Kind::top)));
}
