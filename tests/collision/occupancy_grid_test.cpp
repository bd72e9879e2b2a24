#include "collision/occupancy_grid.h"

#include "catch.h"
#include "support/rooms.h"
#include "support/shapes.h"

using namespace roomgen;

namespace {

//  +--------+------+--------+     Two blocks leave a corridor between the halves of the room. The door
//  |        | high |        |     is on the left; the whole room is turned by some angle.
//  D        +------+        |
//  |        | low  |        |
//  +--------+------+--------+
struct Corridor {
  Room room;
  std::vector<Footprint> blocks;
  Footprint beyond;

  Corridor(double width, double angle, const Vec2& shift) {
    room = rooms::moved(rooms::box(6, 4), angle, shift);
    room.openings = {rooms::door("door-0", 3, 1.5, 2.4)};
    const double depth = 0.5 * (4.0 - width);
    for (double y : {0.5 * depth, 4.0 - 0.5 * depth})
      blocks.emplace_back(rooms::moved(Vec2(3, y), angle, shift), Vec2(1, depth), angle);
    beyond = Footprint(rooms::moved(Vec2(5, 2), angle, shift), {0.2, 0.2}, angle);
  }

  bool open() const {
    OccupancyGrid map(room);
    for (const auto& block : blocks) map.add(block);
    map.flood();
    return map.reaches(beyond);
  }
};

}  // namespace

TEST_CASE("A person of 0.5 m passes no corridor of 0.45 m, at any angle") {
  Random random(1);
  for (int degree = 0; degree < 180; degree += 5)
    for (int i = 0; i < 3; ++i) {
      INFO("turned by " << degree);
      CHECK_FALSE(Corridor(0.45, radians(degree), shapes::random_point(random, -1, 1)).open());
    }
}

TEST_CASE("A corridor of 0.55 m square to the grid is open wherever it lies") {
  Random random(2);
  for (int quarter = 0; quarter < 4; ++quarter)
    for (int i = 0; i < 20; ++i) {
      INFO("turned by " << 90 * quarter);
      CHECK(Corridor(0.55, quarter * pi / 2, shapes::random_point(random, -1, 1)).open());
    }
}

TEST_CASE("A corridor of 0.58 m is open at any angle: the grid costs at most 8 cm") {
  Random random(3);
  for (int degree = 0; degree < 180; degree += 5)
    for (int i = 0; i < 3; ++i) {
      INFO("turned by " << degree);
      CHECK(Corridor(0.58, radians(degree), shapes::random_point(random, -1, 1)).open());
    }
}

TEST_CASE("A corridor of exactly 0.5 m along the grid is open") {
  //  Its middle is at a cell's centre: walls at 2.025 - 0.25 and + 0.25.
  Room room = rooms::box(6, 4);
  room.openings = {rooms::door("door-0", 3, 1.5, 2.4)};
  OccupancyGrid map(room);
  map.add(Footprint({3, 0.5 * 1.775}, {1, 1.775}, 0));
  map.add(Footprint({3, 0.5 * (2.275 + 4)}, {1, 4 - 2.275}, 0));
  map.flood();
  CHECK(map.reaches(Footprint({5, 2}, {0.2, 0.2}, 0)));
}

TEST_CASE("Taking out what was put in restores the map") {
  Random random(4);
  Room room = rooms::box(5, 4);
  room.openings = {rooms::door("door-0", 0, 0.5, 1.4)};
  OccupancyGrid fresh(room), used(room);
  for (int round = 0; round < 20; ++round) {
    std::vector<Footprint> things;
    for (int i = 0; i < 12; ++i)
      things.push_back(Footprint(shapes::random_point(random, -1, 5), shapes::random_point(random, 0.1, 2),
                                 random.uniform(-4, 4), random.chance(0.3)));
    for (const auto& thing : things) used.add(thing);
    random.shuffle(things);
    for (const auto& thing : things) used.remove(thing);
    fresh.flood();
    used.flood();
    for (int i = 0; i < 50; ++i) {
      const Footprint zone(shapes::random_point(random, -1, 5), {0.05, 0.05}, 0);
      REQUIRE(used.reaches(zone) == fresh.reaches(zone));
    }
  }
}

TEST_CASE("Doors are connected when one can walk from the first to all others") {
  Room room = rooms::box(6, 3);
  room.openings = {rooms::door("door-0", 3, 1, 1.9), rooms::door("door-1", 1, 1, 1.9)};
  OccupancyGrid map(room);
  map.flood();
  CHECK(map.doors_connected());
  const Footprint wall({3, 1.5}, {0.2, 3}, 0);
  map.add(wall);
  map.flood();
  CHECK_FALSE(map.doors_connected());
  map.remove(wall);
  map.flood();
  CHECK(map.doors_connected());
}

TEST_CASE("A room without doors is walked from everywhere") {
  OccupancyGrid map(rooms::box(4, 4));
  map.add(Footprint({2, 2}, {0.2, 4}, 0));
  map.flood();
  CHECK(map.doors_connected());
  CHECK(map.reaches(Footprint({0.5, 2}, {0.1, 0.1}, 0)));
  CHECK(map.reaches(Footprint({3.5, 2}, {0.1, 0.1}, 0)));
}

TEST_CASE("A zone is reached when the disc touches it, and not behind a thing") {
  //  D        +----+
  //  |        |    |  zone inside the block: as near as the disc gets is 0.25 m from its face
  //  +--------+----+
  Room room = rooms::box(5, 3);
  room.openings = {rooms::door("door-0", 3, 1, 1.9)};
  OccupancyGrid map(room);
  map.add(Footprint({3.5, 1.5}, {1, 3}, 0));
  map.flood();
  CHECK(map.reaches(Footprint({2.9, 1.5}, {0.2, 0.2}, 0)));   // before the block
  CHECK_FALSE(map.reaches(Footprint({3.5, 1.5}, {0.2, 0.2}, 0)));
  CHECK_FALSE(map.reaches(Footprint({4.5, 1.5}, {0.5, 0.5}, 0)));
}

TEST_CASE("A room that is too small to stand in has nothing to reach") {
  OccupancyGrid map(rooms::box(0.4, 0.4));
  map.flood();
  CHECK_FALSE(map.reaches(Footprint({0.2, 0.2}, {0.2, 0.2}, 0)));
}

TEST_CASE("Cells are free where the disc is inside and clear of every wall, whatever the room's shape") {
  Random random(7);
  for (int round = 0; round < 40; ++round) {
    Room room;
    room.polygon = shapes::random_star(random, shapes::random_point(random, -2, 2), 0.4, 4, random.integer(3, 40));
    OccupancyGrid map(room);
    map.flood();
    const Vec2 low = bounds(room.polygon).low;
    // Is there a cell at which the disc, so much larger, touches the point?
    const auto touched = [&](const Vec2& p, double larger) {
      const Vec2 first = ((p - low).array() / 0.05 - 8.0).floor().max(0.0);
      for (int c = static_cast<int>(first.x()); c < first.x() + 17; ++c)
        for (int r = static_cast<int>(first.y()); r < first.y() + 17; ++r) {
          const Vec2 at = low + 0.05 * Vec2(c + 0.5, r + 0.5);
          if ((at - p).norm() > person_radius - larger || !shapes::winds_around(room.polygon.points, at)) continue;
          double clear = 1e9;
          for (std::size_t k = 0; k < room.polygon.size(); ++k) clear = std::min(clear, distance(room.polygon.edge(k), at));
          if (clear > person_radius + larger) return true;
        }
      return false;
    };
    for (int i = 0; i < 100; ++i) {
      const Vec2 p = low + shapes::random_point(random, 0, 1).cwiseProduct(bounds(room.polygon).size());
      const bool reached = map.reaches(Footprint(p, {2e-4, 2e-4}, 0));
      INFO("round " << round << ", (" << p.x() << ", " << p.y() << ")");
      if (touched(p, 3e-4)) CHECK(reached);
      if (!touched(p, -3e-4)) CHECK_FALSE(reached);
    }
  }
}
