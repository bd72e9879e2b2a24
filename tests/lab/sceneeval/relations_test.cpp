#include <cmath>

#include "base/random.h"
#include "catch.h"
#include "lab/sceneeval/object_relations.h"
#include "lab/sceneeval/room_relations.h"
#include "support/rooms.h"

// SceneEval's functions against what plain boxes say by arithmetic.

using namespace roomgen;
using namespace roomgen::lab;

namespace {

Thing box_thing(const Vec3& size, const Vec3& at, double yaw = 0.0) {
  Object object = rooms::thing("a-0", "thing", size, at.head<2>(), yaw);
  object.position.z() = at.z();
  return thing_of(object, ModelTable());
}

Vec3 random_size(Random& random) {
  return {random.uniform(0.2, 1.5), random.uniform(0.2, 1.5), random.uniform(0.2, 1.5)};
}

double gauss(double excess, double deviation) {
  return std::exp(-excess * excess / (2 * deviation * deviation));
}

// Between two boxes with sides along the axes.
double gap_of(const Vec3& a, const Vec3& a_size, const Vec3& b, const Vec3& b_size) {
  Vec3 gap;
  for (int axis = 0; axis < 3; ++axis) {
    const double half = 0.5 * (a_size[axis] + b_size[axis]);
    const double lift = axis == 2 ? 0.5 * (a_size.z() - b_size.z()) : 0.0;
    gap[axis] = std::max(0.0, std::abs(a[axis] - b[axis] + lift) - half);
  }
  return gap.norm();
}

}  // namespace

TEST_CASE("Distances between random boxes give the four relations of distance") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 a_size = random_size(random), b_size = random_size(random);
    const Vec3 at(random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(0, 2));
    const double gap = gap_of(at, a_size, Vec3::Zero(), b_size);
    if (gap < 0.01) continue;
    const Thing a = box_thing(a_size, at), b = box_thing(b_size, Vec3::Zero());
    CHECK(sceneeval::distance_between(a, b) == Approx(gap).margin(1e-4));
    CHECK(sceneeval::distance_between(b, a) == Approx(gap).margin(1e-4));
    CHECK(sceneeval::next_to(a, b) == Approx(gap < 0.5 ? 1.0 : gauss(gap - 0.5, 0.25)).margin(1e-3));
    const double near = gap < 0.5 ? gauss(0.5 - gap, 0.25) : gap < 1.5 ? 1.0 : gauss(gap - 1.5, 0.25);
    CHECK(sceneeval::near(a, b) == Approx(near).margin(1e-3));
    const double across = gap < 1.5 ? gauss(1.5 - gap, 0.25) : gap < 4 ? 1.0 : gauss(gap - 4, 0.25);
    CHECK(sceneeval::across_from(a, b) == Approx(across).margin(1e-3));
    CHECK(sceneeval::far(a, b) == Approx(gap < 4 ? gauss(4 - gap, 0.25) : 1.0).margin(1e-3));
  }
}

TEST_CASE("Shares of a box inside, above and beside another are products of lengths") {
  Random random(2);
  const Thing anchor = box_thing({2, 1, 0.7}, Vec3::Zero());
  for (int i = 0; i < 100; ++i) {
    const Vec3 size = random_size(random);
    const Vec3 at(random.uniform(-2, 2), random.uniform(-1.5, 1.5), random.uniform(0, 1));
    const Thing target = box_thing(size, at);
    const auto common = [&](int axis, double low, double high) {
      const double from = axis == 2 ? at.z() : at[axis] - 0.5 * size[axis];
      return std::clamp((std::min(from + size[axis], high) - std::max(from, low)) / size[axis], 0.0, 1.0);
    };
    const double along = common(0, -1, 1), across = common(1, -0.5, 0.5), up = common(2, 0, 0.7);
    // Ten points an axis: each end may be off by half a point.
    const double grid = 0.16;
    CHECK(sceneeval::inside_of(target, anchor) == Approx(along * across * up).margin(grid));
    CHECK(sceneeval::outside_of(target, anchor) == Approx(1 - along * across * up).margin(grid));
    CHECK(sceneeval::on_top(target, anchor) == Approx(along * across * common(2, 0.35, 100)).margin(grid));
    // The left is that of who looks at the front: towards -x. The face counts as larger by a quarter.
    const double left = common(0, -100, -1) * common(1, -0.625, 0.625) * common(2, 0.35 - 0.4375, 0.35 + 0.4375);
    CHECK(sceneeval::side_of(target, anchor, BoxSide::left) == Approx(left).margin(grid));
  }
}

TEST_CASE("A side of a turned box turns along") {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const double yaw = random.uniform(-180, 180);
    const Thing anchor = box_thing({1, 1, 1}, Vec3::Zero(), yaw);
    const Vec2 front = front_direction(radians(yaw));
    const Vec2 place = 1.2 * front;
    const Thing target = box_thing({0.3, 0.3, 0.3}, {place.x(), place.y(), 0.2}, yaw);
    CHECK(sceneeval::side_of(target, anchor, BoxSide::front) == 1.0);
    CHECK(sceneeval::side_of(target, anchor, BoxSide::back) == 0.0);
    CHECK(sceneeval::side_of(target, anchor, BoxSide::left) == 0.0);
  }
}

TEST_CASE("Facing falls by a thirtieth a degree, and a miss is none") {
  const Thing anchor = box_thing({4, 0.2, 2}, {0, -3, 0});
  for (const double off : {0.0, 5.0, 10.0, 14.0}) {
    const Thing target = box_thing({0.4, 0.4, 1}, Vec3::Zero(), off);
    // The rays go straight on, so the mean hit lies along the front: SceneEval sees no deviation.
    CHECK(sceneeval::face_to(target, anchor) > 0.9);
  }
  CHECK(sceneeval::face_to(box_thing({0.4, 0.4, 1}, Vec3::Zero(), 90), anchor) == 0.0);
  CHECK(sceneeval::face_to(box_thing({0.4, 0.4, 1}, Vec3::Zero(), 180), anchor) == 0.0);
}

TEST_CASE("Long and short sides, the middle, and around") {
  const Thing table = box_thing({2, 1, 0.7}, Vec3::Zero());
  const Thing at_front = box_thing({0.4, 0.4, 0.7}, {0.3, -0.2, 0});
  CHECK(sceneeval::long_short_side_of(at_front, table, true) > 0.8);
  CHECK(sceneeval::long_short_side_of(box_thing({1, 1, 1}, Vec3::Zero()), box_thing({1, 1, 1}, {2, 0, 0}), true) == 0.0);
  for (const double d : {0.0, 0.1, 0.3, 0.6})
    CHECK(sceneeval::middle_of(box_thing({0.2, 0.2, 0.2}, {d, 0, 0.7}), table) == Approx(gauss(d, 0.25)));
  for (const int count : {3, 4, 6}) {
    std::vector<Thing> ring;
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * pi * k / count;
      ring.push_back(box_thing({0.4, 0.4, 0.7}, {1.5 * std::cos(angle), 1.5 * std::sin(angle), 0}));
    }
    CHECK(sceneeval::surround(ring, table) == Approx(1.0).margin(1e-3));
    ring.pop_back();
    if (count == 3) CHECK(sceneeval::surround(ring, table) == 0.0);
    else CHECK(sceneeval::surround(ring, table) < 0.95);
  }
}

TEST_CASE("Walls, corner, ceiling and middle of a rectangular room") {
  const Room room = rooms::box(5, 4);
  const RoomThings parts = room_things(room);
  for (const double gap : {0.0, 0.1, 0.25, 0.4, 0.6, 1.0}) {
    const Thing thing = box_thing({1, 0.5, 1}, {2.5, 4 - 0.25 - gap, 0});
    const double against = gap < 0.3 ? 1.0 : gauss(gap - 0.3, 0.1);
    CHECK(sceneeval::against_wall(thing, parts.walls) == Approx(against).margin(1e-3));
    CHECK(sceneeval::next_to(thing, parts.walls) == Approx(gap < 0.5 ? 1.0 : gauss(gap - 0.5, 0.25)).margin(1e-3));
    const Thing hung = box_thing({1, 0.05, 0.6}, {2.5, 4 - 0.025 - gap, 1.4});
    CHECK(sceneeval::on_wall(hung, parts.walls) == Approx(gap < 0.01 ? 1.0 : gauss(gap - 0.01, 0.01)).margin(1e-3));
    const Thing cornered = box_thing({0.5, 0.5, 1}, {0.25 + gap, 0.25 + gap, 0});
    const double wall = gap < 0.8 ? 1.0 : gauss(gap - 0.8, 0.25);
    CHECK(sceneeval::corner_of_room(cornered, parts.walls, room) == Approx(wall * wall).margin(1e-3));
    const Thing lamp = box_thing({0.4, 0.4, 0.3}, {2, 2, room.height - 0.3 - gap});
    CHECK(sceneeval::hang_from_ceiling(lamp, room) == Approx(gap < 0.01 ? 1.0 : gauss(gap - 0.01, 0.03)).margin(1e-3));
    const Thing central = box_thing({1, 1, 1}, {2.5 + gap, 2, 0});
    CHECK(sceneeval::middle_of_room(central, room) == Approx(gauss(gap, 0.5 + 1 - 1 / 4.5)).margin(1e-6));
  }
  CHECK(sceneeval::inside_room(box_thing({1, 1, 1}, {0, 2, 0}), room) == Approx(0.5));
}
