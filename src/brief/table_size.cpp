#include "table_size.h"

#include <algorithm>

#include "roomgen/kinds/kind_table.h"

namespace roomgen::brief {

namespace {

constexpr double end_depth = 0.25;  ///< more length when people sit at the ends as well
constexpr double longest_table = 4.0;

}  // namespace

Vec3 table_for(const Vec3& usual, bool round, int seats) {
  Vec3 size = usual;
  if (round) {
    const double diameter = std::min(2.2, seats * seat_width / pi + 0.25);
    size.x() = std::max(size.x(), diameter);
    size.y() = std::max(size.y(), diameter);
    return size;
  }
  // Up to four sit at the long sides, then two at the ends, then more at the sides.
  const int a_side = seats <= 4 ? (seats + 1) / 2 : (seats - 1) / 2;
  const double length = seat_width * a_side + 0.2 + (seats > 4 ? end_depth : 0.0);
  size.x() = std::min(longest_table, std::max(size.x(), length));
  return size;
}

}  // namespace roomgen::brief
