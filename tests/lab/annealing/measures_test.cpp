// Every cost against figures worked out by hand.

#include "lab/annealing/measures.h"

#include <algorithm>
#include <numeric>

#include "base/random.h"
#include "catch.h"

using namespace roomgen;
using namespace roomgen::lab;
using namespace roomgen::lab::annealing;

namespace {

Body box(double x, double y, double width, double depth, double bottom, double height, double yaw = 0.0) {
  return {Footprint({x, y}, {width, depth}, yaw), bottom, bottom + height};
}

Room four_by_three() {
  Room room;
  room.polygon = *make_polygon({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  room.height = 2.5;
  return room;
}

}  // namespace

TEST_CASE("Distance goes through the air") {
  const Body table = box(0, 0, 1, 1, 0, 0.75);
  CHECK(distance(table, box(2, 0, 1, 1, 0, 1)) == Approx(1.0));
  CHECK(distance(table, box(0.2, 0, 1, 1, 0.75, 1)) == Approx(0.0).margin(1e-12));  // standing on it
  CHECK(distance(table, box(0, 0, 0.5, 0.1, 1.75, 0.5)) == Approx(1.0));            // above it
  CHECK(distance(table, box(3.5, 0, 1, 1, 4.75, 1)) == Approx(std::hypot(2.5, 4.0)));
}

TEST_CASE("Distances to the room's faces") {
  const Room room = four_by_three();
  const Body lamp = box(1, 1, 0.4, 0.4, 0.3, 1.2);
  CHECK(distance_to_room(lamp, Face::wall, room) == Approx(0.8));
  CHECK(distance_to_room(lamp, Face::floor, room) == Approx(0.3));
  CHECK(distance_to_room(lamp, Face::ceiling, room) == Approx(1.0));
}

TEST_CASE("Distances to one side of a thing") {
  const Body bed = box(0, 0, 1.6, 2.0, 0, 0.5);
  const Body table = box(1.2, 0, 0.4, 0.4, 0, 0.5);
  CHECK(distance_to_face(table, bed, Face::left) == Approx(0.2));         // +x is its left
  CHECK(distance_to_face(table, bed, Face::right) == Approx(1.8));
  CHECK(distance_to_face(box(1.2, 0, 0.4, 0.4, 0.9, 0.5), bed, Face::top) == Approx(std::hypot(0.2, 0.4)));
}

TEST_CASE("Access is how deep the other thing reaches into the space before a side") {
  const Body desk = box(0, 0, 1.2, 0.6, 0, 0.75);  // its front looks to -y
  const Body space = access_space(desk, Face::front, 1.0);
  CHECK(space.footprint.center().y() == Approx(-0.8));
  CHECK(penetration(space, box(0, -1.2, 0.4, 0.4, 0, 1)) == Approx(0.3));
  CHECK(penetration(space, box(0, -1.6, 0.4, 0.4, 0, 1)) == Approx(0.0).margin(1e-12));
  CHECK(penetration(space, box(0, -1.2, 0.4, 0.4, 0.8, 1)) == 0.0);  // higher than the desk
  CHECK(penetration(access_space(desk, Face::left, 0.5), box(1.0, 0, 0.6, 0.2, 0, 1)) == Approx(0.4));
  CHECK(penetration(access_space(desk, Face::top, 0.5), box(0, 0, 0.2, 0.2, 1.0, 1)) > 0.0);
}

TEST_CASE("Angles to sides and walls") {
  const Footprint table({0, 0}, {2, 1}, 0.0);
  CHECK(misalignment(Footprint({0, -2}, {0.5, 0.5}, 0.0), table) == Approx(0.0).margin(1e-12));
  CHECK(misalignment(Footprint({0, -2}, {0.5, 0.5}, pi), table) == Approx(0.0).margin(1e-12));
  CHECK(misalignment(Footprint({0, -2}, {0.5, 0.5}, pi / 2), table) == Approx(0.5));
  CHECK(misalignment(Footprint({0, -2}, {0.5, 0.5}, pi / 4), table) == Approx(0.5 * (1 - std::sqrt(0.5))));
  CHECK(misalignment_to_walls(Footprint({0.5, 1.5}, {0.5, 0.5}, pi / 2), four_by_three().polygon) ==
        Approx(0.0).margin(1e-12));
  CHECK(misalignment_to_walls(Footprint({0.5, 1.5}, {0.5, 0.5}, 0.0), four_by_three().polygon) == Approx(0.5));
}

TEST_CASE("Focus") {
  const Footprint chair({0, 0}, {0.5, 0.5}, 0.0);
  CHECK(unfocused(chair, {0, -3}) == Approx(0.0).margin(1e-12));
  CHECK(unfocused(chair, {0, 3}) == Approx(1.0));
  CHECK(unfocused(chair, {3, 0}) == Approx(0.5));
}

TEST_CASE("Mirror images across the longer middle plane of a table") {
  const Footprint table({1, 1}, {2, 1}, 0.0);  // the plane is y = 1
  const std::vector<Footprint> mirrored{Footprint({0.5, 0.2}, {0.4, 0.4}, pi), Footprint({0.5, 1.8}, {0.4, 0.4}, 0.0)};
  CHECK(reflection_asymmetry(mirrored, table) == Approx(0.0).margin(1e-12));
  // One chair 0.3 m along the table: each image is off by 0.3; they are hypot(0.3, 1.6) apart.
  const std::vector<Footprint> shifted{mirrored[0], Footprint({0.8, 1.8}, {0.4, 0.4}, 0.0)};
  const double off = 0.3 / std::hypot(0.3, 1.6);
  CHECK(reflection_asymmetry(shifted, table) == Approx(1 - 1 / (1 + off)));
  CHECK(reflection_asymmetry(std::span(mirrored).first(1), table) == 0.0);
}

TEST_CASE("Rotation about the common centre") {
  std::vector<Footprint> round;
  for (int i = 0; i < 5; ++i) {
    const double angle = 0.3 + i * 2 * pi / 5;
    round.emplace_back(Vec2(2 + std::cos(angle), 3 + std::sin(angle)), Vec2(0.4, 0.4), wrap_angle(angle + 1.0));
  }
  CHECK(rotation_asymmetry(round) == Approx(0.0).margin(1e-9));
  round[2] = Footprint(round[2].center(), {0.4, 0.4}, round[2].yaw() + 0.5);
  // Two headings are off by half a radian each, of five, and headings are a third of the measure.
  CHECK(rotation_asymmetry(round) == Approx(2 * 0.5 / pi / 15).epsilon(1e-6));
}

TEST_CASE("Coplanarity of a row") {
  const std::vector<Footprint> row{Footprint({0, 0}, {0.5, 0.6}, 0), Footprint({1, 0.1}, {0.5, 0.4}, 0),
                                   Footprint({2, 0}, {0.5, 0.6}, 0)};
  CHECK(uncoplanarity(row) == Approx(0.0).margin(1e-12));  // the backs are at 0.3
  const std::vector<Footprint> turned{row[0], Footprint({1, 0}, {0.6, 0.6}, pi / 2)};
  CHECK(uncoplanarity(turned) == Approx(0.5 + std::abs(0.3 - 0.0)).margin(0.31));
}

TEST_CASE("The floor that two footprints share") {
  CHECK(shared_area(Footprint({0, 0}, {2, 2}, 0), Footprint({1, 1}, {2, 2}, 0)) == Approx(1.0));
  CHECK(shared_area(Footprint({0, 0}, {2, 2}, 0), Footprint({3, 0}, {2, 2}, 0)) == 0.0);
  // A square within a square, turned by 45 degrees: an octagon of side 2 (sqrt 2 - 1), area 8 (sqrt 2 - 1).
  CHECK(shared_area(Footprint({0, 0}, {2, 2}, 0), Footprint({0, 0}, {2, 2}, pi / 4)) ==
        Approx(8 * (std::sqrt(2.0) - 1)));
}

TEST_CASE("Shared floor agrees with counted points") {
  Random random(7);
  for (int round = 0; round < 40; ++round) {
    const auto any = [&] {
      const double x = random.uniform(-0.5, 0.5), y = random.uniform(-0.5, 0.5), yaw = random.uniform(-3, 3);
      return Footprint({x, y}, {random.uniform(0.3, 1.5), random.uniform(0.3, 1.5)}, yaw);
    };
    const Footprint a = any(), b = any();
    int both = 0;
    constexpr int side = 300;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        const Vec2 point(-1.5 + 3.0 * (i + 0.5) / side, -1.5 + 3.0 * (j + 0.5) / side);
        both += contains(a, point) && contains(b, point);
      }
    CHECK(shared_area(a, b) == Approx(both * 9.0 / (side * side)).margin(0.02));
  }
}

TEST_CASE("The cheapest matching is that of all permutations") {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    const int n = random.integer(1, 6);
    std::vector<double> costs;
    for (int i = 0; i < n * n; ++i) costs.push_back(random.uniform(0, 5));
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    const auto sum = [&](const std::vector<int>& columns) {
      double total = 0;
      for (int i = 0; i < n; ++i) total += costs[static_cast<std::size_t>(i * n + columns[static_cast<std::size_t>(i)])];
      return total;
    };
    double least = 1e9;
    do least = std::min(least, sum(order));
    while (std::next_permutation(order.begin(), order.end()));
    CHECK(sum(cheapest_matching(costs, n)) == Approx(least));
  }
}
