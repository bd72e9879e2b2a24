// Tours against geometry that shares nothing with them: points along every way, projections by hand, pictures taken
// anew.
#include "roomgen/lab/tour.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "base/random.h"
#include "catch.h"
#include "roomgen/render/pictures.h"
#include "roomgen/lab/frames.h"
#include "support/brute_force.h"
#include "support/rooms.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

Renderer& shared_renderer() {
  static const auto renderer = make_osmesa_renderer();
  REQUIRE(renderer);
  return **renderer;
}

Result<Tour> try_tour(const Scene& scene, const TourOptions& options = {}) {
  return make_tour(scene, {}, KindTable::built_in(), shared_renderer(), options);
}

Tour tour_of(const Scene& scene, const TourOptions& options = {}) {
  auto tour = try_tour(scene, options);
  if (!tour) FAIL(tour.error().message);
  return std::move(*tour);
}

// Boxes that keep apart, a door in the first wall.
Scene random_room(std::uint64_t seed) {
  Random random(seed);
  const double width = random.uniform(3.5, 6.0), depth = random.uniform(3.0, 5.0);
  Scene scene = rooms::scene(rooms::box(width, depth), {});
  scene.room.openings = {rooms::door("door-0", 0, 0.4, 1.3)};
  const char* kinds[] = {"wardrobe", "chair", "desk", "nightstand", "bookshelf", "sofa"};
  for (int tries = 0; tries < 40 && scene.objects.size() < 8; ++tries) {
    const Vec3 size(random.uniform(0.3, 1.4), random.uniform(0.3, 0.8), random.uniform(0.3, 1.9));
    const double x = random.uniform(0.8, width - 0.8), y = random.uniform(1.5, depth - 0.8);
    const int kind = random.integer(0, 5);
    auto object = rooms::thing(kinds[kind] + ("-" + std::to_string(tries)), kinds[kind], size, {x, y},
                               random.uniform(-180.0, 180.0));
    const bool apart = std::none_of(scene.objects.begin(), scene.objects.end(), [&](const Object& other) {
      return overlaps(footprint(object), footprint(other), 0.0);
    });
    if (apart) scene.objects.push_back(object);
  }
  return scene;
}

double wall_distance(const Room& room, const Vec2& p) {
  double least = 1e9;
  const auto& points = room.polygon.points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 a = points[k], along = points[(k + 1) % points.size()] - a;
    const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (a + t * along - p).norm());
  }
  return least;
}

double room_to_spare(const Scene& scene, const Vec2& p) {
  double least = wall_distance(scene.room, p);
  for (const auto& object : scene.objects) least = std::min(least, brute_force::outside_by(object, p));
  return least;
}

// Along all ways of a tour.
double least_to_spare(const Scene& scene, const Tour& tour) {
  double least = 1e9;
  for (std::size_t k = 1; k < tour.keyframes.size(); ++k) {
    const Vec3 a = tour.keyframes[k - 1].pose.eye, b = tour.keyframes[k].pose.eye;
    for (int i = 0; i <= 10; ++i) least = std::min(least, room_to_spare(scene, (a + 0.1 * i * (b - a)).head<2>()));
  }
  return least;
}

struct Axes {
  Vec3 ahead, right, up;
};

Axes axes_of(const CameraPose& pose) {
  const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
  const Vec3 ahead(s * std::cos(pose.pitch), -c * std::cos(pose.pitch), std::sin(pose.pitch));
  const Vec3 right(-c, -s, 0.0);
  const double level = right.x() * ahead.y() - right.y() * ahead.x();
  return {ahead, right, Vec3(right.y() * ahead.z(), -right.x() * ahead.z(), level)};
}

bool in_picture(const CameraPose& pose, const TourIntrinsics& intrinsics, const Vec3& point) {
  const Axes axes = axes_of(pose);
  const Vec3 way = point - pose.eye;
  const double half = std::tan(0.5 * intrinsics.field_of_view) * axes.ahead.dot(way) + 1e-6;
  return half > 0 && std::abs(axes.right.dot(way)) <= half &&
         std::abs(axes.up.dot(way)) <= half * intrinsics.height / intrinsics.width + 1e-6;
}

bool all_in_picture(const CameraPose& pose, const TourIntrinsics& intrinsics, const Object& o) {
  const double c = std::cos(o.yaw), s = std::sin(o.yaw);
  bool inside = true;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {0.0, 1.0}) {
        const Vec3 corner(c * x * o.size.x() - s * y * o.size.y(), s * x * o.size.x() + c * y * o.size.y(),
                          z * o.size.z());
        inside = inside && in_picture(pose, intrinsics, o.position + corner);
      }
  return inside;
}

LayerThing seen_from(const Scene& scene, const CameraPose& pose, const TourIntrinsics& intrinsics,
                     const std::string& id) {
  const auto camera = tour_camera(pose, intrinsics);
  REQUIRE(camera);
  Shot shot;
  shot.camera = *camera;
  shot.alone = true;
  const auto layers = shared_renderer().layers(scene, {}, shot);
  REQUIRE(layers);
  return *std::find_if(layers->things.begin(), layers->things.end(),
                       [&](const LayerThing& thing) { return thing.id == id; });
}

double hidden_share(const LayerThing& thing) {
  return 1.0 - static_cast<double>(thing.pixels) / static_cast<double>(thing.pixels_alone);
}

std::string cause_of(const Tour& tour, const std::string& id) {
  for (const auto& target : tour.unseen)
    if (target.id == id) return target.reason.empty() ? "no reason" : std::string(name(target.cause));
  return "seen";
}

}  // namespace

TEST_CASE("Every way of a tour keeps its distance to walls and things") {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    INFO("seed " << seed);
    const Scene scene = random_room(seed);
    TourOptions options;
    options.agent_radius = seed % 2 ? 0.25 : 0.2;
    const Tour tour = tour_of(scene, options);
    REQUIRE(!tour.views.empty());
    CHECK(least_to_spare(scene, tour) >= options.agent_radius - 1e-5);
  }
}

// Where places to walk by lie farther apart.
TEST_CASE("So does every way through a hall of 6,000 square metres") {
  for (std::uint64_t seed = 60; seed < 63; ++seed) {
    INFO("seed " << seed);
    Scene scene = random_room(seed);
    scene.room.polygon = rooms::box(100, 60).polygon;
    for (auto& object : scene.objects) object.position.head<2>() *= 12.0;
    const Tour tour = tour_of(scene);
    CHECK(tour.views.size() == scene.objects.size());
    CHECK(least_to_spare(scene, tour) >= TourOptions().agent_radius - 1e-5);
    for (std::size_t k = 1; k < tour.views.size(); ++k) {
      const auto &from = tour.views[k - 1].pose.eye, &to = tour.views[k].pose.eye;
      CHECK(tour.views[k].walked >= (to - from).head<2>().norm() - 1e-6);
      CHECK(tour.views[k].walked <= 1.2 * (to - from).head<2>().norm() + 1.0);  // little is in the way
    }
  }
}

TEST_CASE("Every view shows all of its target's box and has as much of it hidden as was asked for") {
  for (std::uint64_t seed = 20; seed < 32; ++seed) {
    INFO("seed " << seed);
    const Scene scene = random_room(seed);
    TourOptions options;
    if (seed % 3 == 0) options.least_hidden = 0.2, options.greatest_hidden = 0.7;
    const Tour tour = tour_of(scene, options);
    for (const auto& view : tour.views) {
      INFO(view.target);
      CHECK(all_in_picture(view.pose, tour.intrinsics, *find_object(scene, view.target)));
      const LayerThing thing = seen_from(scene, view.pose, tour.intrinsics, view.target);
      CHECK(thing.pixels == view.pixels);
      CHECK(thing.pixels_alone == view.pixels_alone);
      CHECK(hidden_share(thing) >= options.least_hidden);
      CHECK(hidden_share(thing) <= options.greatest_hidden);
      CHECK(view.pose.eye.z() == options.eye_height);
      const CameraPose& there = tour.keyframes.at(view.keyframe).pose;
      CHECK((there.eye - view.pose.eye).norm() < 1e-9);
      CHECK(std::abs(wrap_angle(there.yaw - view.pose.yaw)) < 1e-9);
      CHECK(there.pitch == view.pose.pitch);
    }
  }
}

TEST_CASE("Each target is in a view or reported, once") {
  for (std::uint64_t seed = 40; seed < 48; ++seed) {
    const Scene scene = random_room(seed);
    const Tour tour = tour_of(scene);
    std::multiset<std::string> told, all;
    for (const auto& view : tour.views) told.insert(view.target);
    for (const auto& target : tour.unseen) told.insert(target.id);
    for (const auto& object : scene.objects) all.insert(object.id);
    CHECK(told == all);
  }
}

TEST_CASE("What a tour does not see cannot be seen from a grid of free places either") {
  int seen = 0, missed = 0;
  std::string which;
  for (std::uint64_t seed = 60; seed < 70; ++seed) {
    const Scene scene = random_room(seed);
    TourOptions options;
    const Tour tour = tour_of(scene, options);
    const brute_force::Walk walk(scene);
    seen += static_cast<int>(tour.views.size());
    for (const auto& target : tour.unseen) {
      const Object& object = *find_object(scene, target.id);
      const Vec3 middle = object.position + Vec3(0, 0, 0.5 * object.size.z());
      bool visible = false;
      for (double x = 0.3; x < 6.0 && !visible; x += 0.3)
        for (double y = 0.3; y < 5.0 && !visible; y += 0.3) {
          const Vec3 eye(x, y, options.eye_height), way = middle - eye;
          const double away = way.head<2>().norm(), pitch = std::atan2(way.z(), away);
          if (!shapes::winds_around(scene.room.polygon.points, {x, y}) || std::abs(pitch) > options.steepest_pitch ||
              room_to_spare(scene, {x, y}) < 0.25 || !walk.touches(Footprint({x, y}, {0.01, 0.01}, 0.0)) ||
              brute_force::outside_by(object, {x, y}) > 4.0)
            continue;
          const CameraPose pose{eye, std::atan2(way.x(), -way.y()), pitch};
          if (!all_in_picture(pose, tour.intrinsics, object)) continue;
          visible = hidden_share(seen_from(scene, pose, tour.intrinsics, object.id)) <= options.greatest_hidden;
        }
      missed += visible;
      if (visible) which += "\n" + std::to_string(seed) + ": " + target.id + ": " + target.reason;
    }
  }
  INFO(seen << " seen, " << missed << " missed" << which);
  CHECK(seen > 50);
  CHECK(50 * missed <= seen);
}

TEST_CASE("A tour walks at one speed or turns where it stands, and begins inside the door") {
  const Scene scene = random_room(3);
  TourOptions options;
  options.speed = 0.8;
  const Tour tour = tour_of(scene, options);
  REQUIRE(tour.keyframes.size() > 20);
  CHECK(tour.keyframes[0].time == 0.0);
  CHECK(contains(door_clearance(scene.room, scene.room.openings[0]), tour.keyframes[0].pose.eye.head<2>()));
  for (std::size_t k = 1; k < tour.keyframes.size(); ++k) {
    const auto &from = tour.keyframes[k - 1], &to = tour.keyframes[k];
    const double seconds = to.time - from.time, metres = (to.pose.eye - from.pose.eye).norm();
    const double turned = std::abs(wrap_angle(to.pose.yaw - from.pose.yaw));
    const double up = std::abs(to.pose.pitch - from.pose.pitch);
    REQUIRE(seconds > 0);
    CHECK(seconds <= 1.0 / options.keyframes_per_second + 1e-9);
    CHECK((metres < 1e-9 || std::abs(metres - options.speed * seconds) < 1e-6));
    CHECK((metres < 1e-9 || turned + up < 1e-9));
    CHECK(std::max(turned, up) <= options.turn_rate * seconds + 1e-9);
    CHECK((to.pose.yaw > -pi && to.pose.yaw <= pi));
  }
}

TEST_CASE("Same seed, same tour") {
  const Scene scene = random_room(5);
  TourOptions options;
  options.seed = 1;
  const std::string once = dump_json(to_json(tour_of(scene, options)));
  CHECK(once == dump_json(to_json(tour_of(scene, options))));
  options.seed = 2;
  CHECK(once != dump_json(to_json(tour_of(scene, options))));
}

TEST_CASE("What is in a closed cabinet is reported as hidden") {
  Scene scene = rooms::scene(rooms::box(4, 4), {rooms::thing("cabinet-0", "cabinet", {0.8, 0.6, 1.0}, {2, 3.5}),
                                                rooms::thing("vase-0", "vase", {0.2, 0.2, 0.3}, {2, 3.5})});
  scene.room.openings = {rooms::door("door-0", 0, 0.5, 1.4)};
  scene.objects[1].position.z() = 0.3;
  const Tour tour = tour_of(scene);
  CHECK(cause_of(tour, "vase-0") == "hidden");
  CHECK(cause_of(tour, "cabinet-0") == "seen");
}

TEST_CASE("Without a way in all targets are reported") {
  Scene scene = random_room(7);
  TourOptions wide;
  wide.agent_radius = 3.0;
  for (const auto& object : scene.objects) CHECK(cause_of(tour_of(scene, wide), object.id) == "no-way-in");
  scene.room.openings.clear();
  const Tour tour = tour_of(scene);
  CHECK(tour.keyframes.empty());
  for (const auto& object : scene.objects) CHECK(cause_of(tour, object.id) == "no-way-in");
}

TEST_CASE("What stands behind a barrier is reported as out of reach") {
  Scene scene = rooms::scene(rooms::box(4, 6), {rooms::thing("bookshelf-0", "bookshelf", {3.98, 0.4, 0.8}, {2, 3}),
                                                rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9}, {2, 5.5})});
  scene.room.openings = {rooms::door("door-0", 0, 0.5, 1.4)};
  TourOptions options;
  options.greatest_distance = 1.5;
  CHECK(cause_of(tour_of(scene, options), "chair-0") == "out-of-reach");
}

TEST_CASE("A share that nothing hides is reported, an empty range is refused") {
  Scene scene = rooms::scene(rooms::box(4, 4), {rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9}, {2, 2.5})});
  scene.room.openings = {rooms::door("door-0", 0, 0.5, 1.4)};
  TourOptions options;
  options.least_hidden = 0.4, options.greatest_hidden = 0.6;
  CHECK(cause_of(tour_of(scene, options), "chair-0") == "hidden");
  options.greatest_hidden = 0.3;
  CHECK(!try_tour(scene, options));
  options = {};
  options.eye_height = 2.7;
  CHECK(!try_tour(scene, options));
  options = {};
  options.targets = {"sofa-0"};
  CHECK(!try_tour(scene, options));
}

TEST_CASE("A tour walks through the inner doors of a dwelling") {
  Scene scene;
  Room hall = rooms::box(4, 3), study = rooms::box(4, 3);
  hall.id = "hall-0", study.id = "study-0";
  for (auto& point : study.polygon.points) point.x() += 4.0 + wall_thickness;
  hall.openings = {rooms::door("door-0", 0, 0.5, 1.4), rooms::door("door-1", 1, 1.0, 1.9)};
  study.openings = {rooms::door("door-0", 3, 1.1, 2.0)};
  hall.openings[1].leads_to = "study-0", study.openings[0].leads_to = "hall-0";
  scene.rooms = {hall, study};
  scene.objects = {rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {6.5, 2.6})};
  scene.objects[0].room = "study-0";
  REQUIRE(check(scene));
  TourOptions options;
  options.greatest_distance = 1.5;
  const Tour tour = tour_of(scene, options);
  REQUIRE(tour.views.size() == 1);
  CHECK(shapes::winds_around(study.polygon.points, tour.views[0].pose.eye.head<2>()));
  for (const auto& keyframe : tour.keyframes) {
    const Vec2 p = keyframe.pose.eye.head<2>();
    if (p.x() > 4.0 && p.x() < 4.0 + wall_thickness) CHECK((p.y() >= 1.25 - 1e-5 && p.y() <= 1.65 + 1e-5));
  }
}

TEST_CASE("Words say how a scene is filmed") {
  const Scene scene = rooms::scene(rooms::box(5, 5), {rooms::thing("bookshelf-0", "bookshelf", {0.8, 0.3, 1.8}, {1, 4}),
                                                      rooms::thing("bed-0", "bed", {1.6, 2.0, 0.5}, {3.5, 3}),
                                                      rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {1, 1})});
  const auto read = [&](const char* text) { return read_tour_words(text, scene, KindTable::built_in()); };
  const auto order = read("A bedroom. Look at the bed first, then the desk, and at the shelf last.").options;
  CHECK(order.first == std::vector<std::string>{"bed-0", "desk-0"});
  CHECK(order.last == std::vector<std::string>{"bookshelf-0"});
  CHECK(read("The eye height is 1.2 m.").options.eye_height == Approx(1.2));
  CHECK(read("Film it with an eye height of about 120 cm").options.eye_height == Approx(1.2));
  CHECK(read("The camera should show the things half hidden.").options.least_hidden == Approx(0.4));
  CHECK(read("The camera should capture objects with partial occlusion.").options.greatest_hidden == Approx(0.7));
  const auto range = read("Views with 30 to 50 % of each thing hidden.").options;
  CHECK(range.least_hidden == Approx(0.3));
  CHECK(range.greatest_hidden == Approx(0.5));
  CHECK(read("A tour from a bird's-eye view").options.flies);
  CHECK(read("The camera has a field of view of 70 degrees").options.field_of_view == Approx(radians(70.0)));
  CHECK(read("Look only at the desk").options.targets == std::vector<std::string>{"desk-0"});
  CHECK(read("The camera should dance.").not_understood.size() == 1);
  // A room's own words are no wishes.
  const auto plain = read("A bedroom with a bed and a desk. A shelf stands first to the left of the last desk.");
  CHECK((plain.understood.empty() && plain.not_understood.empty()));
}

TEST_CASE("Targets are visited in the order that was asked for") {
  const Scene scene = random_room(9);
  TourOptions options;
  const Tour free_order = tour_of(scene, options);
  REQUIRE(free_order.views.size() >= 4);
  options.last = {free_order.views[0].target, free_order.views[1].target};
  options.first = {free_order.views.back().target};
  const Tour tour = tour_of(scene, options);
  std::vector<std::string> order;
  for (const auto& view : tour.views) order.push_back(view.target);
  REQUIRE(order.size() >= 4);
  CHECK(order.front() == options.first[0]);
  const auto place = [&](const std::string& id) { return std::find(order.begin(), order.end(), id) - order.begin(); };
  CHECK(place(options.last[1]) >= static_cast<std::ptrdiff_t>(order.size()) - 1);
}

TEST_CASE("A bird's-eye tour passes over what is low and keeps away from what is high") {
  Scene scene = rooms::scene(rooms::box(4, 6), {rooms::thing("bookshelf-0", "bookshelf", {3.98, 0.4, 0.8}, {2, 3}),
                                                rooms::thing("wardrobe-0", "wardrobe", {1.0, 0.6, 2.2}, {0.6, 4.6}),
                                                rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9}, {3, 5})});
  scene.room.openings = {rooms::door("door-0", 0, 0.5, 1.4)};
  TourOptions options = birds_eye(scene);
  options.greatest_distance = 1.5;
  const Tour tour = tour_of(scene, options);
  CHECK(cause_of(tour, "chair-0") == "seen");
  for (const auto& keyframe : tour.keyframes) {
    CHECK(keyframe.pose.eye.z() == Approx(2.0));
    CHECK(brute_force::outside_by(scene.objects[1], keyframe.pose.eye.head<2>()) >= options.agent_radius - 1e-5);
  }
}

TEST_CASE("tour.json reads as it was written, and frames fall on its keyframes") {
  const Tour tour = tour_of(random_room(4));
  const std::string text = dump_json(to_json(tour));
  const auto read = tour_from_json(*parse_json(text, "tour.json"), "tour.json");
  REQUIRE(read);
  CHECK(dump_json(to_json(*read)) == text);
  const auto frames = frames_of(*read, 4.0);
  REQUIRE(frames);
  for (std::size_t k = 0; k < frames->size(); ++k) {
    CHECK((*frames)[k].number == k);
    CHECK((k == 0 || (*frames)[k].time > (*frames)[k - 1].time));
    CHECK((k == 0 || (*frames)[k].time - (*frames)[k - 1].time < 0.25 + 0.11));
  }
  for (const auto& view : tour.views)
    CHECK(std::count_if(frames->begin(), frames->end(), [&](const TourFrame& frame) {
            return frame.target == view.target && frame.keyframe == view.keyframe;
          }) == 1);
  CHECK(!frames_of(*read, 0.0));
  CHECK(!tour_from_json(*parse_json(R"({"format": "roomgen-scene"})", "x"), "x"));
}

TEST_CASE("Behind a gap that is narrower than the agent, what is there is out of reach, and the reason says so") {
  Scene scene = rooms::scene(rooms::box(4, 6), {rooms::thing("wardrobe-0", "wardrobe", {3.45, 0.4, 2.0}, {1.725, 3}),
                                                rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9}, {2, 5.5})});
  scene.room.openings = {rooms::door("door-0", 0, 0.5, 1.4)};
  TourOptions options;
  options.greatest_distance = 1.5;
  CHECK(cause_of(tour_of(scene, options), "chair-0") == "seen");
  options.agent_radius = 0.35;
  const Tour tour = tour_of(scene, options);
  CHECK(cause_of(tour, "chair-0") == "out-of-reach");
  REQUIRE(!tour.unseen.empty());
  CHECK(tour.unseen.back().reason.find("0.7 m wide") != std::string::npos);
}

TEST_CASE("What stands in a room without a way in is out of reach, and the reason names the room") {
  Scene scene;
  Room hall = rooms::box(4, 3), vault = rooms::box(4, 3);
  hall.id = "hall-0", vault.id = "vault-0";
  for (auto& point : vault.polygon.points) point.x() += 4.0 + wall_thickness;
  hall.openings = {rooms::door("door-0", 0, 0.5, 1.4)};
  scene.rooms = {hall, vault};
  scene.objects = {rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9}, {2.0, 2.0}),
                   rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {7.4, 2.6})};
  scene.objects[0].room = "hall-0", scene.objects[1].room = "vault-0";
  TourOptions options;
  options.greatest_distance = 1.5;
  const Tour tour = tour_of(scene, options);
  CHECK(cause_of(tour, "chair-0") == "seen");
  CHECK(cause_of(tour, "desk-0") == "out-of-reach");
  REQUIRE(tour.unseen.size() == 1);
  CHECK(tour.unseen[0].reason.find("vault-0") != std::string::npos);
}

TEST_CASE("A camera in a wall or outdoors is told from one in a room or in a doorway") {
  Scene scene = rooms::scene(rooms::box(4, 3), {});
  scene.room.openings = {rooms::door("door-0", 0, 0.5, 1.4)};
  CHECK(is_indoors(scene, {2.0, 1.5}));
  CHECK(is_indoors(scene, {1.0, -0.5 * wall_thickness}));   // in the doorway
  CHECK(!is_indoors(scene, {3.0, -0.5 * wall_thickness}));  // in the wall beside it
  CHECK(!is_indoors(scene, {1.0, -1.0}));
  CHECK(!is_indoors(scene, {30.0, 1.5}));
  for (std::uint64_t seed = 80; seed < 84; ++seed) {
    const Scene room = random_room(seed);
    for (const auto& keyframe : tour_of(room).keyframes) CHECK(is_indoors(room, keyframe.pose.eye.head<2>()));
  }
}
