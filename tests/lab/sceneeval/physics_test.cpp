#include <cmath>

#include "base/random.h"
#include "catch.h"
#include "lab/sceneeval/physics.h"
#include "support/rooms.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

Object at(Object object, double z, Mount mount = Mount::floor) {
  object.position.z() = z;
  object.mount = mount;
  return object;
}

std::vector<bool> supported(const Room& room, const std::vector<Object>& objects) {
  std::vector<Thing> things;
  std::vector<Mount> mounts;
  for (const auto& object : objects) {
    things.push_back(thing_of(object, ModelTable()));
    mounts.push_back(object.mount);
  }
  return sceneeval::supported(things, mounts, room, room_things(room));
}

double navigability(const Room& room, const std::vector<Object>& objects) {
  std::vector<OrientedBox> boxes;
  for (const auto& object : objects) boxes.push_back(box_of(object));
  return sceneeval::navigability(boxes, room);
}

}  // namespace

TEST_CASE("On the floor within five millimetres is held, in the air is not, wherever and however turned") {
  const Room room = rooms::box(5, 4);
  Random random(1);
  for (int i = 0; i < 30; ++i) {
    const Object thing = rooms::thing("a-0", "thing", {random.uniform(0.1, 1), random.uniform(0.1, 1), 0.5},
                                      {random.uniform(1, 4), random.uniform(1, 3)}, random.uniform(-180, 180));
    CHECK(supported(room, {at(thing, 0.0)})[0]);
    CHECK(supported(room, {at(thing, 0.004)})[0]);
    CHECK(supported(room, {at(thing, -0.004)})[0]);
    CHECK_FALSE(supported(room, {at(thing, 0.006)})[0]);
    CHECK_FALSE(supported(room, {at(thing, -0.006)})[0]);
  }
}

TEST_CASE("What stands on a table is held while its middle is over it") {
  const Room room = rooms::box(5, 4);
  const Object table = rooms::thing("table-0", "table", {1, 1, 0.7}, {2, 2});
  for (double x = 2.0; x < 2.9; x += 0.04) {
    const Object lamp = at(rooms::thing("lamp-0", "lamp", {0.4, 0.4, 0.5}, {x, 2}), 0.7, Mount::surface);
    INFO(x);
    if (std::abs(x - 2.5) > 0.02) CHECK(supported(room, {table, lamp})[1] == (x < 2.5));
  }
}

TEST_CASE("A thing on a wall is held by the wall behind it, one under the ceiling by that") {
  const Room room = rooms::box(5, 4);
  // Fronts look into the room: yaw 0 with the back to the wall at y = 4.
  const Object picture = rooms::thing("picture-0", "picture", {0.6, 0.04, 0.5}, {2, 3.98});
  CHECK(supported(room, {at(picture, 1.4, Mount::wall)})[0]);
  Object off = picture;
  off.position.y() -= 0.02;
  CHECK_FALSE(supported(room, {at(off, 1.4, Mount::wall)})[0]);
  off = picture;
  off.yaw = radians(180);
  CHECK_FALSE(supported(room, {at(off, 1.4, Mount::wall)})[0]);
  const Object side = rooms::thing("picture-1", "picture", {0.6, 0.04, 0.5}, {0.02, 2}, 90);
  CHECK(supported(room, {at(side, 1.4, Mount::wall)})[0]);
  const Object lamp = rooms::thing("lamp-0", "lamp", {0.4, 0.4, 0.3}, {2, 2});
  CHECK(supported(room, {at(lamp, room.height - 0.3, Mount::ceiling)})[0]);
  CHECK_FALSE(supported(room, {at(lamp, room.height - 0.32, Mount::ceiling)})[0]);
}

TEST_CASE("A door cut into the wall holds what hangs on it, as SceneEval has it") {
  Room room = rooms::box(5, 4);
  room.openings = {rooms::window("window-0", 2, 1, 4)};
  const Object blind = rooms::thing("blind-0", "blind", {1, 0.04, 0.5}, {2.5, 3.98});
  CHECK(supported(room, {at(blind, 1.2, Mount::wall)})[0]);
}

TEST_CASE("The floor of an empty room hangs together") {
  CHECK(navigability(rooms::box(5, 4), {}) == 1.0);
  CHECK(navigability(rooms::box(2, 9), {}) == 1.0);
}

TEST_CASE("A wall of cupboards parts the floor in the share of the areas") {
  const Room room = rooms::box(6, 4);
  for (const double x : {1.0, 2.0, 3.0, 4.5}) {
    const Object row = rooms::thing("cupboard-0", "cupboard", {0.4, 4, 1.8}, {x, 2});
    // Half a robot is 0.1 m: off both walls and both sides of the row.
    const double left = x - 0.2 - 0.2, right = 6 - x - 0.2 - 0.2;
    CHECK(navigability(room, {row}) == Approx(std::max(left, right) / (left + right)).margin(0.02));
    Object high = row;
    high.position.z() = 1.2;
    CHECK(navigability(room, {high}) == 1.0);
  }
  const Object all = rooms::thing("stage-0", "stage", {6, 4, 0.3}, {3, 2});
  CHECK(navigability(room, {all}) == 0.0);
}

TEST_CASE("A gap narrower than the robot parts the floor, a wider one does not") {
  const Room room = rooms::box(6, 4);
  const auto leaving = [&](double gap) {
    return navigability(room, {rooms::thing("cupboard-0", "cupboard", {0.4, 4 - gap, 1.8}, {3, 2 - 0.5 * gap})});
  };
  CHECK(leaving(0.1) < 0.6);
  CHECK(leaving(0.4) == 1.0);
}

TEST_CASE("Before a door is as deep as it is wide, before a window half a metre") {
  Room room = rooms::box(5, 4);
  room.openings = {rooms::door("door-0", 0, 1, 1.9), rooms::window("window-0", 2, 1, 3)};
  const auto before = [&](const Vec2& at, double height) {
    const std::vector<OrientedBox> boxes = {box_of(rooms::thing("a-0", "thing", {0.4, 0.4, height}, at))};
    return sceneeval::in_the_way(boxes, room);
  };
  for (double y = 0.3; y < 1.6; y += 0.1) CHECK(before({1.45, y}, 0.5)[0].empty() == (y - 0.2 + 0.02 > 0.9));
  CHECK(before({2.5, 0.3}, 0.5)[0].empty());
  // Wall 2 runs back from x = 5: the window is from x = 4 to x = 2.
  CHECK(before({3, 3.7}, 0.5)[1].empty());
  CHECK_FALSE(before({3, 3.7}, 1.4)[1].empty());
  CHECK(before({3, 3.2}, 1.4)[1].empty());
}

TEST_CASE("The share in bounds is that of the surface over the floor") {
  const Room room = rooms::box(5, 4);
  const auto share = [&](double x) {
    const Vec3 center(x, 2, 0.5), half(0.5, 0.5, 0.5);
    return sceneeval::share_in_bounds(Thing({center, half, 0.0}, make_box(center - half, center + half)), room);
  };
  CHECK(share(0.5) == 1.0);
  // Of a cube's six faces the four along x are cut in two, one is out.
  CHECK(share(0.3) == Approx((4 * 0.8 + 1) / 6).margin(0.02));
  CHECK(share(-3) == 0.0);
}
