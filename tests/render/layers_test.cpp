// What layers say against rays cast through the triangles of the same scene, which know nothing of OpenGL.
#include <Eigen/Geometry>
#include <limits>
#include <set>

#include "catch.h"
#include "drawing.h"
#include "geometry/mesh_tree.h"
#include "roomgen/render/pictures.h"
#include "scene/box_model.h"
#include "scene/room_shell.h"
#include "support/furnished_room.h"
#include "view/camera.h"

using namespace roomgen;

namespace {

Layers layers_of(Renderer& renderer, const Scene& scene, const Shot& shot, const ModelTable& models = {}) {
  auto layers = renderer.layers(scene, models, shot);
  if (!layers) FAIL(layers.error().message);
  return std::move(*layers);
}

struct Hit {
  int thing = -1;  ///< index into the things of layers
  double distance = std::numeric_limits<double>::infinity();
  Vec3 normal = Vec3::Zero();
};

// Triangles in the room, thing by thing, in the order of the layers' things.
class RayCaster {
 public:
  RayCaster(const Scene& scene, const Layers& layers) {
    for (const auto& object : scene.objects) add(placed(object));
    const auto shell = room_shell(scene.room);
    for (std::size_t k = scene.objects.size(); k < layers.things.size(); ++k) {
      Mesh mesh;
      for (const auto& part : shell)
        if (part.name == layers.things[k].id) mesh = merged_mesh(part.model);
      add(mesh);
    }
  }

  Hit first(const Vec3& origin, const Vec3& direction) const {
    Hit best;
    for (std::size_t k = 0; k < trees_.size(); ++k) {
      const auto at = trees_[k].empty() ? std::nullopt : trees_[k].first_hit({origin, direction});
      if (at && *at > 0 && *at < best.distance) best = {static_cast<int>(k), *at, Vec3::Zero()};
    }
    if (best.thing >= 0) best.normal = normal_at(best, origin, direction);
    return best;
  }

  /// Is the thing so far away along the ray?
  bool meets(int thing, const Vec3& origin, const Vec3& direction, double distance) const {
    if (thing < 0 || trees_[static_cast<std::size_t>(thing)].empty()) return false;
    const auto at = trees_[static_cast<std::size_t>(thing)].first_hit({origin, direction});
    return at && std::abs(*at - distance) < 1e-5;
  }

 private:
  static Mesh placed(const Object& object) {
    const Model model = box_model(object);
    const ModelPlacement placement = model_placement(object, bounds(model));
    Mesh mesh = merged_mesh(model);
    for (auto& p : mesh.positions) {
      const Vec3 scaled = placement.scale.cwiseProduct(p.cast<double>());
      const Vec2 turned = rotated(scaled.head<2>(), placement.yaw);
      p = (Vec3(turned.x(), turned.y(), scaled.z()) + placement.position).cast<float>();
    }
    return mesh;
  }

  void add(const Mesh& mesh) {
    meshes_.push_back(mesh);
    trees_.emplace_back(mesh);
  }

  // Of the triangle around the point, towards where the ray comes from.
  Vec3 normal_at(const Hit& hit, const Vec3& origin, const Vec3& direction) const {
    const Mesh& mesh = meshes_[static_cast<std::size_t>(hit.thing)];
    const Vec3 point = origin + hit.distance * direction;
    Vec3 best = Vec3::Zero();
    double least = 1e300;
    for (const auto& t : mesh.triangles) {
      const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
                 c = mesh.positions[t[2]].cast<double>();
      const Vec3 normal = (b - a).cross(c - a).normalized();
      double outside = std::abs(normal.dot(point - a));
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        outside = std::max(outside, (to - from).normalized().cross(normal).dot(point - from));
      if (outside >= least) continue;
      least = outside;
      best = normal;
    }
    return best.dot(direction) > 0 ? Vec3(-best) : best;
  }

  std::vector<Mesh> meshes_;
  std::vector<MeshTree> trees_;
};

struct Sight {
  Vec3 origin, direction;  ///< 1 m along the camera's axis
};

// The ray through a point of the picture, from the camera's own description.
Sight sight(const Camera& camera, double x, double y) {
  const double u = (x - 0.5 * camera.width) / camera.pixels_per_metre + camera.center.x();
  const double v = (0.5 * camera.height - y) / camera.pixels_per_metre + camera.center.y();
  if (camera.eye) return {*camera.eye, u * camera.right + v * camera.up - camera.backward};
  return {u * camera.right + v * camera.up + camera.near * camera.backward, -camera.backward};
}

// Does one thing, and one face of it, fill the surroundings of the pixel's middle?
bool is_away_from_edges(const RayCaster& rays, const Camera& camera, double x, double y, const Hit& middle) {
  for (const Vec2& step : {Vec2(0.8, 0), Vec2(-0.8, 0), Vec2(0, 0.8), Vec2(0, -0.8)}) {
    const Sight s = sight(camera, x + step.x(), y + step.y());
    const Hit hit = rays.first(s.origin, s.direction);
    if (hit.thing != middle.thing || hit.normal.dot(middle.normal) < 0.999) return false;
  }
  return true;
}

struct Agreement {
  int checked = 0, same_thing = 0, same_distance = 0, same_normal = 0;
};

Agreement compare(const Scene& scene, const Layers& layers, int step) {
  const RayCaster rays(scene, layers);
  const Camera& camera = layers.camera;
  Agreement agreement;
  for (int y = 1; y < camera.height; y += step)
    for (int x = 1; x < camera.width; x += step) {
      const Sight s = sight(camera, x + 0.5, y + 0.5);
      const Hit hit = rays.first(s.origin, s.direction);
      if (!is_away_from_edges(rays, camera, x + 0.5, y + 0.5, hit)) continue;
      const auto i = static_cast<std::size_t>(y * camera.width + x);
      ++agreement.checked;
      // Where two things lie in one plane (a ceiling on walls), either is right.
      if (layers.objects[i] != hit.thing + 1 && !rays.meets(layers.objects[i] - 1, s.origin, s.direction, hit.distance))
        continue;
      ++agreement.same_thing;
      if (hit.thing < 0) continue;
      agreement.same_distance += std::abs(layers.depths[i] - hit.distance) < 1e-3 * std::max(1.0, hit.distance);
      agreement.same_normal += layers.normals[i].cast<double>().dot(hit.normal) > 0.9999;
    }
  return agreement;
}

void check_agreement(const Agreement& found) {
  CHECK(found.checked > 500);
  CHECK(found.same_thing > 0.995 * found.checked);
  CHECK(found.same_distance > 0.995 * found.checked);
  CHECK(found.same_normal > 0.995 * found.checked);
}

// Somewhere above the floor of the room, looking anywhere.
Camera random_camera(const Scene& scene, Random& random) {
  const Bounds2 floor = bounds(scene.room.polygon);
  const auto inside = [&](double low, double high) {
    return Vec3(random.uniform(floor.low.x() + 0.2, floor.high.x() - 0.2),
                random.uniform(floor.low.y() + 0.2, floor.high.y() - 0.2), random.uniform(low, high));
  };
  const auto camera = pinhole_camera(inside(2.05, 2.5), inside(0.0, 1.5), radians(random.uniform(40, 100)), 200, 150);
  REQUIRE(camera);
  return *camera;
}

Shot shot_of(const Camera& camera) {
  Shot shot;
  shot.camera = camera;
  shot.color = false;
  return shot;
}

}  // namespace

TEST_CASE("a box in an empty room is as far away as arithmetic says") {
  auto renderer = make_renderer();
  Scene scene;
  scene.room = test::plain_room();
  scene.objects = {test::box("box-0", {1.0, 0.5, 0.8}, {2.0, 2.0, 0})};
  const auto camera = pinhole_camera({2.0, 0.5, 0.4}, {2.0, 2.0, 0.4}, radians(90), 300, 200);
  REQUIRE(camera);
  const Layers layers = layers_of(*renderer, scene, shot_of(*camera));
  // The front of the box is 1.25 m ahead, 1 m wide and 0.8 m high: 120 by 96 pixels around the middle.
  std::size_t count = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) {
      const auto i = static_cast<std::size_t>(y * 300 + x);
      const bool on_box = x >= 90 && x < 210 && y >= 52 && y < 148;
      INFO(x << ", " << y);
      REQUIRE((layers.objects[i] == 1) == on_box);
      count += on_box;
      if (!on_box) continue;
      REQUIRE(std::abs(layers.depths[i] - 1.25f) < 1e-5f);
      REQUIRE((layers.normals[i] - Eigen::Vector3f(0, -1, 0)).norm() < 1e-3f);
    }
  CHECK(layers.things[0].id == "box-0");
  CHECK(layers.things[0].pixels == count);
}

TEST_CASE("pinhole cameras anywhere see what rays meet") {
  auto renderer = make_renderer();
  Random random(11);
  for (const int seed : {1, 2, 3, 4}) {
    const Scene scene = seed == 1 ? test::furnished_room() : test::random_scene(seed);
    for (int view = 0; view < 4; ++view) {
      INFO("scene " << seed << ", view " << view);
      check_agreement(compare(scene, layers_of(*renderer, scene, shot_of(random_camera(scene, random))), 4));
    }
  }
}

TEST_CASE("parallel rays from any direction see what rays meet") {
  auto renderer = make_renderer();
  Random random(12);
  const Scene scene = test::furnished_room();
  for (int view = 0; view < 6; ++view) {
    Camera camera = random_camera(scene, random);
    const Vec3 middle(2.0, 1.5, 1.0);
    camera.eye.reset();
    camera.center = {camera.right.dot(middle), camera.up.dot(middle)};
    camera.pixels_per_metre = 30.0;
    camera.near = camera.depth(middle) + 6.0;
    camera.far = camera.depth(middle) - 6.0;
    INFO("view " << view);
    check_agreement(compare(scene, layers_of(*renderer, scene, shot_of(camera)), 3));
  }
}

TEST_CASE("depths, numbers and normals say nothing where nothing is, and are sound elsewhere") {
  auto renderer = make_renderer();
  const Scene scene = test::furnished_room();
  Shot shot;
  shot.kind = View::Kind::top;
  shot.camera = *make_camera(scene, {});
  const Layers layers = layers_of(*renderer, scene, shot);
  std::size_t nothing = 0, seen = 0;
  for (const auto& thing : layers.things) seen += thing.pixels;
  for (std::size_t i = 0; i < layers.objects.size(); ++i) {
    const bool empty = layers.objects[i] == 0;
    nothing += empty;
    REQUIRE(std::isinf(layers.depths[i]) == empty);
    REQUIRE((layers.categories[i] == 0) == empty);
    REQUIRE(std::abs(layers.normals[i].norm() - (empty ? 0.0f : 1.0f)) < 1e-5f);
    if (!empty) REQUIRE(layers.categories[i] == layers.things[layers.objects[i] - 1u].category_id);
  }
  CHECK(nothing > 0);
  CHECK(seen + nothing == layers.objects.size());
  CHECK(layers.color.width == shot.camera.width);
  // From above a box shows its top, so far below the near plane.
  const Vec2 bed = shot.camera.pixel({2.6, 2.0, 0.5});
  const auto at = static_cast<std::size_t>(bed.y()) * shot.camera.width + static_cast<std::size_t>(bed.x());
  CHECK(layers.things[layers.objects[at] - 1u].id == "bed-0");
  CHECK(std::abs(layers.depths[at] - (shot.camera.near - 0.5)) < 1e-4);
}

TEST_CASE("what hides a thing makes it show less than it would alone") {
  auto renderer = make_renderer();
  Scene scene;
  scene.room = test::plain_room();
  scene.objects = {test::box("bed-0", {1.0, 0.2, 1.0}, {2.0, 2.5, 0}),
                   test::box("chair-0", {0.2, 0.2, 1.0}, {2.0, 1.5, 0}),
                   test::box("desk-0", {0.5, 0.2, 0.5}, {2.0, 0.3, 0})};
  Shot shot = shot_of(*pinhole_camera({2.0, 0.5, 0.5}, {2.0, 2.0, 0.5}, radians(90), 400, 300));
  shot.alone = true;
  const Layers layers = layers_of(*renderer, scene, shot);
  const auto share = [&](std::size_t k) {
    return static_cast<double>(layers.things[k].pixels) / static_cast<double>(layers.things[k].pixels_alone);
  };
  CHECK(layers.things[1].pixels == layers.things[1].pixels_alone);
  // At 1.9 m the chair's front at 0.9 m hides 0.2 * 1.9 / 0.9 of the bed's metre.
  CHECK(std::abs(share(0) - (1.0 - 0.2 * 1.9 / 0.9)) < 0.02);
  CHECK(layers.things[2].pixels_alone == 0);  // behind the eye
  for (const auto& thing : layers.things) CHECK(thing.pixels <= thing.pixels_alone);
}

TEST_CASE("layers of one scene are the same byte by byte, whatever was drawn before") {
  auto one = make_renderer(), other = make_renderer();
  const Scene scene = test::furnished_room();
  Random random(5);
  const Camera first = random_camera(scene, random), second = random_camera(scene, random);
  Shot shot;
  shot.camera = first;
  const Layers a = layers_of(*one, scene, shot);
  shot.camera = second;
  (void)layers_of(*other, scene, shot);
  (void)other->render(scene, {}, {});
  shot.camera = first;
  const Layers b = layers_of(*other, scene, shot);
  CHECK((a.color.pixels == b.color.pixels));
  CHECK((a.depths == b.depths));
  CHECK((a.normals == b.normals));
  CHECK((a.objects == b.objects));
}

TEST_CASE("tiles of a large picture fit") {
  auto renderer = make_renderer();
  const Scene scene = test::furnished_room();
  const auto camera = pinhole_camera({0.4, 0.4, 2.2}, {3.0, 2.5, 0.3}, radians(80), 1400, 1100);
  check_agreement(compare(scene, layers_of(*renderer, scene, shot_of(*camera)), 17));
}

TEST_CASE("glass is a thing, a hole in foliage is none") {
  auto renderer = make_renderer();
  ModelTable models;
  Scene scene;
  scene.room = test::plain_room();
  scene.objects = {test::box("glass-0", {1.0, 1.0, 0.1}, {1.0, 1.5, 0.5}),
                   test::box("plant-0", {1.0, 1.0, 0.1}, {3.0, 1.5, 0.5})};
  test::use_model(scene.objects[0], models, "glass", test::colored_box({1, 1, 0.1}, {255, 255, 255}, 0.3f));
  Model leaves = test::colored_box({1, 1, 0.1}, {255, 255, 255});
  leaves.materials[0].texture = test::checkerboard(true);
  test::use_model(scene.objects[1], models, "leaves", leaves);
  Shot shot;
  shot.kind = View::Kind::top;
  shot.color = false;
  shot.alone = true;
  shot.camera = *make_camera(scene, {});
  const Layers layers = layers_of(*renderer, scene, shot, models);
  const double square = std::pow(shot.camera.pixels_per_metre, 2);
  CHECK(std::abs(static_cast<double>(layers.things[0].pixels) / square - 1.0) < 0.02);
  CHECK(static_cast<double>(layers.things[1].pixels) / square < 0.9);
}

TEST_CASE("categories have numbers of their own, the same in every scene") {
  auto renderer = make_renderer();
  const auto numbers = [&](const Scene& scene) {
    Shot shot;
    shot.color = false;
    shot.kind = View::Kind::top;
    shot.camera = *make_camera(scene, {});
    std::map<std::string, int> result;
    for (const auto& thing : layers_of(*renderer, scene, shot).things) {
      const auto [known, added] = result.emplace(thing.category, thing.category_id);
      CHECK(known->second == thing.category_id);
    }
    std::set<int> distinct;
    for (const auto& [category, number] : result) distinct.insert(number);
    CHECK(distinct.size() == result.size());
    return result;
  };
  Scene scene = test::furnished_room();
  const auto before = numbers(scene);
  scene.objects.insert(scene.objects.begin(), test::box("wardrobe-0", {1, 0.5, 2}, {3, 1, 0}));
  for (const auto& [category, number] : before) CHECK(numbers(scene).at(category) == number);
}

TEST_CASE("a camera that cannot be is an error that says why") {
  CHECK_FALSE(pinhole_camera({1, 1, 1}, {1, 1, 1}, 1.0, 100, 100));
  CHECK_FALSE(pinhole_camera({1, 1, 1}, {2, 1, 1}, 0.0, 100, 100));
  CHECK_FALSE(pinhole_camera({1, 1, 1}, {2, 1, 1}, pi, 100, 100));
  CHECK_FALSE(pinhole_camera({1, 1, 1}, {2, 1, 1}, 1.0, 8, 100));
  CHECK_FALSE(pinhole_camera({1, 1, std::nan("")}, {2, 1, 1}, 1.0, 100, 100));
  CHECK(pinhole_camera({1, 1, 2}, {1, 1, 0}, 1.0, 100, 100));
  auto renderer = make_renderer();
  Shot shot = shot_of(*pinhole_camera({1, 1, 1}, {2, 1, 1}, 1.0, 100, 100));
  shot.camera.up *= 2.0;
  CHECK_FALSE(renderer->layers(test::furnished_room(), {}, shot));
  shot.camera = Camera{};
  CHECK_FALSE(renderer->layers(test::furnished_room(), {}, shot));
}
