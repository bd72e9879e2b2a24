#include "catch.h"
#include "support/furnished_room.h"
#include "view/camera.h"

using namespace roomgen;

namespace {

View eye_view(int pixels = 800) {
  View view;
  view.kind = View::Kind::eye;
  view.pixels = pixels;
  return view;
}

Camera camera_of(const Scene& scene) {
  const auto camera = make_camera(scene, eye_view());
  REQUIRE(camera);
  REQUIRE(camera->eye);
  return *camera;
}

// Free space around a point at this height, by its own reckoning: boxes and walls.
double free_space(const Scene& scene, const Vec3& point) {
  double free = distance_to_boundary(scene.room.polygon, Vec2(point.head<2>()));
  for (const auto& object : scene.objects) {
    if (top(object) < point.z() || bottom(object) > point.z()) continue;
    const Footprint box(object.position.head<2>(), object.size.head<2>(), object.yaw,
                        object.traits.round);
    free = std::min(free, gap(box, Vec2(point.head<2>())));
  }
  return free;
}

}  // namespace

TEST_CASE("the eye is in the room and in nothing else") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Scene scene = test::random_scene(seed);
    // As many things as a room might have; where they lie no one has checked.
    scene.objects.resize(std::min<std::size_t>(scene.objects.size(), 12));
    if (seed % 3 == 0) scene.room = test::l_shaped_room();
    const Camera camera = camera_of(scene);
    INFO("seed " << seed);
    CHECK(contains(scene.room.polygon, Vec2(camera.eye->head<2>())));
    CHECK(camera.eye->z() == Approx(eye_level));
    CHECK(free_space(scene, *camera.eye) >= eye_clearance - 1e-9);
  }
}

TEST_CASE("a low ceiling lowers the eye") {
  Scene scene = test::furnished_room();
  scene.room.height = 1.7;
  scene.room.openings.clear();
  CHECK(camera_of(scene).eye->z() < 1.45);
}

TEST_CASE("verticals are upright and the horizon is level") {
  const Scene scene = test::furnished_room();
  const Camera camera = camera_of(scene);
  for (double angle = -0.6; angle <= 0.6; angle += 0.3)
    for (const double distance : {1.0, 2.5}) {
      const Vec2 way = rotated(Vec2(-camera.backward.head<2>()), angle);
      const Vec2 p = camera.eye->head<2>() + distance * way;
      const Vec2 foot = camera.pixel({p.x(), p.y(), 0.0}), head = camera.pixel({p.x(), p.y(), 2.0});
      CHECK(foot.x() == Approx(head.x()).margin(1e-6));
      CHECK(foot.y() > head.y());
      const Vec2 level = camera.pixel({p.x(), p.y(), camera.eye->z()});
      CHECK(level.y() == Approx(camera.pixel(*camera.eye - camera.backward).y()).margin(1e-6));
      // Half the angle of view lies on each side.
      const double middle = 0.5 * camera.width;
      CHECK((level.x() - middle) / middle ==
            Approx(-std::tan(angle) / std::tan(0.5 * eye_view_angle)).margin(1e-6));
    }
}

TEST_CASE("what is before the eye lies between the planes") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Scene scene = test::random_scene(seed);
    const Camera camera = camera_of(scene);
    for (const auto& p : offset_outward(scene.room.polygon, wall_thickness))
      CHECK(camera.depth({p.x(), p.y(), 0.0}) > camera.far);
    CHECK(camera.near < camera.depth(*camera.eye));
    CHECK(camera.depth(*camera.eye) - camera.near < eye_clearance);
  }
}

TEST_CASE("the eye looks into the room and not at the next wall") {
  Scene scene;
  scene.room = test::plain_room();
  const Camera camera = camera_of(scene);
  const Vec2 at = camera.eye->head<2>(), ahead = at - 2.0 * camera.backward.head<2>();
  CHECK(contains(scene.room.polygon, ahead));
}

TEST_CASE("what stands in a corner sends the eye elsewhere") {
  Scene scene;
  scene.room = test::plain_room();
  const Camera before = camera_of(scene);
  const Vec3 place(before.eye->x(), before.eye->y(), 0.0);
  scene.objects = {test::box("wardrobe-0", {0.9, 0.9, 2.1}, place)};
  CHECK(free_space(scene, *camera_of(scene).eye) >= eye_clearance - 1e-9);
}

TEST_CASE("what the room is about is in the midst of the picture, and shows its front") {
  for (std::size_t wall = 0; wall < 4; ++wall)
    for (const double along : {0.35, 0.65}) {
      Scene scene;
      scene.room = test::plain_room();
      scene.room.polygon.points = {{0, 0}, {5, 0}, {5, 4.5}, {0, 4.5}};
      const Polygon& polygon = scene.room.polygon;
      const Segment line = polygon.edge(wall);
      const Vec2 in = polygon.inward(wall), at = line.a + along * (line.b - line.a);
      Object bed = test::box("bed-0", {1.4, 2.0, 0.5}, Vec3::Zero());
      bed.traits.front = true;
      bed.yaw = yaw_facing(in);
      bed.position.head<2>() = at + 1.0 * in;
      const Vec2 far = line.b - 0.5 * (line.b - line.a).normalized() + 0.3 * in;
      Object wardrobe = test::box("wardrobe-0", {0.8, 0.6, 2.2}, Vec3(far.x(), far.y(), 0.0));
      wardrobe.yaw = bed.yaw;
      scene.objects = {wardrobe, bed};
      const Camera camera = camera_of(scene);
      const Vec2 way = (bed.position - *camera.eye).head<2>().normalized();
      INFO("wall " << wall << ", " << along);
      CHECK(std::acos(-way.dot(camera.backward.head<2>())) < 0.3 * eye_view_angle);
      CHECK(way.dot(front_direction(bed.yaw)) < 0.0);
    }
}
