#include "free_rectangles.h"

#include <algorithm>

namespace roomgen {

namespace {

constexpr double cell = 0.1;

// Which cells of the floor are free, row by row from the lowest y.
class FreeCells {
 public:
  FreeCells(const Polygon& floor, std::span<const Footprint> taken)
      : low_(bounds(floor).low),
        columns_(static_cast<int>(std::floor(bounds(floor).size().x() / cell + 1e-6))),
        rows_(static_cast<int>(std::floor(bounds(floor).size().y() / cell + 1e-6))),
        free_(static_cast<std::size_t>(columns_) * rows_) {
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x) {
        const Footprint square(box_of(x, y, 1, 1).low + Vec2::Constant(cell / 2),
                               Vec2::Constant(cell), 0.0);
        free_[index(x, y)] =
            contains(floor, square) &&
            std::none_of(taken.begin(), taken.end(),
                         [&](const Footprint& footprint) { return overlaps(square, footprint); });
      }
  }

  /// The largest rectangle of free cells with sides of at least this many; empty if there is none.
  /// For each row the heights of free columns above it are a histogram, in which the largest
  /// rectangle is found with a stack.
  Bounds2 largest(int least) const {
    Bounds2 best;
    int best_area = 0;
    std::vector<int> heights(columns_ + 1, 0);
    for (int y = 0; y < rows_; ++y) {
      for (int x = 0; x < columns_; ++x) heights[x] = free_[index(x, y)] ? heights[x] + 1 : 0;
      std::vector<int> open;  // columns whose rectangles still grow, of growing heights
      for (int x = 0; x <= columns_; ++x) {
        while (!open.empty() && heights[open.back()] >= heights[x]) {
          const int height = heights[open.back()];
          open.pop_back();
          const int from = open.empty() ? 0 : open.back() + 1, width = x - from;
          if (std::min(width, height) < least || width * height <= best_area) continue;
          best_area = width * height;
          best = box_of(from, y - height + 1, width, height);
        }
        open.push_back(x);
      }
    }
    return best;
  }

  void take(const Bounds2& box) {
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x)
        if (box.overlaps(box_of(x, y, 1, 1), -1e-6)) free_[index(x, y)] = false;
  }

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * columns_ + x; }
  Bounds2 box_of(int x, int y, int width, int height) const {
    const Vec2 low = low_ + cell * Vec2(x, y);
    return {low, low + cell * Vec2(width, height)};
  }

  Vec2 low_;
  int columns_, rows_;
  std::vector<bool> free_;
};

}  // namespace

std::vector<Bounds2> free_rectangles(const Polygon& floor, std::span<const Footprint> taken,
                                     double least_side, std::size_t most) {
  FreeCells cells(floor, taken);
  const int least = std::max(1, static_cast<int>(std::ceil(least_side / cell - 1e-6)));
  std::vector<Bounds2> result;
  while (result.size() < most) {
    const Bounds2 box = cells.largest(least);
    if (box.low.x() > box.high.x()) break;
    result.push_back(box);
    cells.take(box);
  }
  return result;
}

}  // namespace roomgen
