#include "geometry/free_rectangles.h"

#include "base/random.h"
#include "catch.h"

using namespace roomgen;

namespace {

double area_of(const Bounds2& box) {
  return box.size().prod();
}

struct Case {
  Polygon floor;
  std::vector<Footprint> taken;
};

// An L or a rectangle, its corners on the grid, with a few things turned anyhow.
Case random_case(Random& random) {
  const double w = 0.1 * random.integer(12, 22), d = 0.1 * random.integer(12, 22);
  Case result;
  if (random.chance(0.5)) {
    result.floor.points = {{0, 0}, {w, 0}, {w, d}, {0, d}};
  } else {
    const double x = 0.1 * random.integer(4, 8), y = 0.1 * random.integer(4, 8);
    result.floor.points = {{0, 0}, {w, 0}, {w, y}, {x, y}, {x, d}, {0, d}};
  }
  for (int n = random.integer(0, 4); n > 0; --n)
    result.taken.emplace_back(Vec2(random.uniform(0, w), random.uniform(0, d)),
                              Vec2(random.uniform(0.1, 0.8), random.uniform(0.1, 0.8)),
                              random.uniform(-pi, pi), random.chance(0.3));
  return result;
}

bool is_free(const Case& room, const Bounds2& box) {
  const Footprint footprint(0.5 * (box.low + box.high), box.size(), 0.0);
  if (!contains(room.floor, footprint)) return false;
  for (const auto& other : room.taken)
    if (overlaps(footprint, other)) return false;
  return true;
}

// Every rectangle of whole cells, one by one.
double largest_by_trial(const Case& room, double least_side) {
  const Vec2 size = bounds(room.floor).size();
  const int columns = static_cast<int>(std::lround(size.x() / 0.1)),
            rows = static_cast<int>(std::lround(size.y() / 0.1));
  double best = 0.0;
  for (int x0 = 0; x0 < columns; ++x0)
    for (int y0 = 0; y0 < rows; ++y0)
      for (int x1 = x0 + 1; x1 <= columns; ++x1)
        for (int y1 = y0 + 1; y1 <= rows; ++y1) {
          const Bounds2 box{0.1 * Vec2(x0, y0), 0.1 * Vec2(x1, y1)};
          if (area_of(box) <= best || box.size().minCoeff() < least_side - 1e-9) continue;
          if (is_free(room, box)) best = area_of(box);
        }
  return best;
}

}  // namespace

TEST_CASE("The first free rectangle is the largest there is") {
  Random random(3);
  int found = 0;
  for (int i = 0; i < 12; ++i) {
    const Case room = random_case(random);
    const auto boxes = free_rectangles(room.floor, room.taken, 0.3, 1);
    const double best = largest_by_trial(room, 0.3);
    CHECK((boxes.empty() ? 0.0 : area_of(boxes.front())) == Approx(best).margin(1e-9));
    found += boxes.empty() ? 0 : 1;
  }
  CHECK(found > 5);
}

TEST_CASE("Free rectangles are free, apart, no narrower than asked, and shrink") {
  Random random(4);
  std::size_t several = 0;
  for (int i = 0; i < 100; ++i) {
    const Case room = random_case(random);
    const auto boxes = free_rectangles(room.floor, room.taken, 0.3, 6);
    CHECK(boxes.size() <= 6);
    several += boxes.size() > 1 ? 1 : 0;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      CHECK(is_free(room, boxes[k]));
      CHECK(boxes[k].size().minCoeff() > 0.3 - 1e-9);
      if (k > 0) CHECK(area_of(boxes[k]) <= area_of(boxes[k - 1]) + 1e-9);
      for (std::size_t j = 0; j < k; ++j) CHECK_FALSE(boxes[k].overlaps(boxes[j], -1e-6));
    }
  }
  CHECK(several > 50);
}
