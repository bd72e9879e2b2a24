#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/QR>

#include "clauses.h"
#include "roomgen/geometry/vec.h"

namespace roomgen {

namespace {

constexpr double straight = 0.15, together = 2.5;  // metres
constexpr double off_circle = 0.25;                // metres
constexpr double pushed_together = 0.12;           // metres
constexpr double even_gap = 1.6, even_arc_gap = 2.0;  // times what equal gaps would be
constexpr double least_arc = 80.0, greatest_arc = 300.0;  // degrees

/// A thing's place along its row, and across the rows.
struct Spot {
  double along = 0.0, across = 0.0;
};
using Row = std::vector<Spot>;

std::vector<Row> rows_along(std::span<const Object* const> things, double angle) {
  const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
  std::vector<Spot> spots;
  for (const Object* thing : things) {
    const Vec2 center = thing->position.head<2>();
    spots.push_back({center.dot(along), center.dot(across)});
  }
  std::sort(spots.begin(), spots.end(), [](const Spot& a, const Spot& b) { return a.across < b.across; });
  std::vector<Row> rows;
  for (const Spot& spot : spots) {
    if (rows.empty() || spot.across - rows.back().front().across > straight) rows.emplace_back();
    rows.back().push_back(spot);
  }
  return rows;
}

bool hangs_together(Row row) {
  std::sort(row.begin(), row.end(), [](const Spot& a, const Spot& b) { return a.along < b.along; });
  return std::adjacent_find(row.begin(), row.end(), [](const Spot& a, const Spot& b) {
           return b.along - a.along > together;
         }) == row.end();
}

// As many in each, or fewer in one.
bool are_even(const std::vector<Row>& rows) {
  const auto size = std::max_element(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
                      return a.size() < b.size();
                    })->size();
  return size > 1 && std::count_if(rows.begin(), rows.end(),
                                   [&](const Row& row) { return row.size() < size; }) <= 1;
}

bool stand_in_rows(std::span<const Object* const> things, int wanted, double angle) {
  const auto rows = rows_along(things, angle);
  const bool as_many = wanted > 0 ? rows.size() == static_cast<std::size_t>(wanted) : rows.size() > 1;
  return as_many && are_even(rows) && std::all_of(rows.begin(), rows.end(), hangs_together);
}

/// The circle that is nearest to points.
struct Circle {
  Vec2 center = Vec2::Zero();
  double radius = 0.0;
};

// Least squares of the algebraic distance: Kasa, "A circle fitting procedure and its error analysis", 1976.
Circle circle_through(std::span<const Object* const> things) {
  Eigen::MatrixX3d rows(things.size(), 3);
  Eigen::VectorXd squares(things.size());
  for (std::size_t i = 0; i < things.size(); ++i) {
    const Vec2 at = things[i]->position.head<2>();
    rows.row(static_cast<Eigen::Index>(i)) << 2.0 * at.x(), 2.0 * at.y(), 1.0;
    squares[static_cast<Eigen::Index>(i)] = at.squaredNorm();
  }
  const Eigen::Vector3d fit = rows.colPivHouseholderQr().solve(squares);
  const Vec2 center = fit.head<2>();
  return {center, std::sqrt(std::max(0.0, fit.z() + center.squaredNorm()))};
}

bool lie_on(const Circle& circle, std::span<const Object* const> things) {
  return std::all_of(things.begin(), things.end(), [&](const Object* thing) {
    return std::abs((thing->position.head<2>() - circle.center).norm() - circle.radius) <= off_circle;
  });
}

// Angles between neighbours seen from the middle, all around, the widest last.
std::vector<double> gaps_around(const Vec2& center, std::span<const Object* const> things) {
  std::vector<double> angles, gaps;
  for (const Object* thing : things) {
    const Vec2 arm = thing->position.head<2>() - center;
    angles.push_back(std::atan2(arm.y(), arm.x()));
  }
  std::sort(angles.begin(), angles.end());
  for (std::size_t i = 0; i < angles.size(); ++i)
    gaps.push_back(i + 1 < angles.size() ? angles[i + 1] - angles[i]
                                         : angles.front() + 2.0 * std::numbers::pi - angles[i]);
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

}  // namespace

std::string circle_fault(std::span<const Object* const> things) {
  if (things.size() < 3) return "fewer than three make no circle";
  const Circle circle = circle_through(things);
  const auto gaps = gaps_around(circle.center, things);
  const double even = 2.0 * std::numbers::pi / static_cast<double>(things.size());
  return lie_on(circle, things) && gaps.back() <= even_gap * even ? "" : "they do not stand in a circle";
}

std::string arc_fault(std::span<const Object* const> things) {
  if (things.size() < 3) return "fewer than three make no arc";
  const Circle circle = circle_through(things);
  auto gaps = gaps_around(circle.center, things);
  const double span = 2.0 * std::numbers::pi - gaps.back();
  gaps.pop_back();
  const double even = span / static_cast<double>(gaps.size());
  const bool is_arc = degrees(span) >= least_arc && degrees(span) <= greatest_arc;
  return lie_on(circle, things) && is_arc && gaps.back() <= even_arc_gap * even ? "" : "they do not stand in an arc";
}

std::string islands_fault(std::span<const Object* const> things, int size) {
  std::vector<const Object*> left(things.begin(), things.end());
  int smaller = 0;
  while (!left.empty()) {
    std::vector<const Object*> island = {left.back()};
    left.pop_back();
    for (std::size_t i = 0; i < island.size(); ++i)
      std::erase_if(left, [&](const Object* other) {
        const bool touches = gap(footprint(*island[i]), footprint(*other)) <= pushed_together;
        if (touches) island.push_back(other);
        return touches;
      });
    if (static_cast<int>(island.size()) > size) return "more than " + std::to_string(size) + " stand together";
    smaller += static_cast<int>(island.size()) < size;
  }
  const int allowed = static_cast<int>(things.size()) % size == 0 ? 0 : 1;
  return smaller > allowed ? "they do not stand in islands of " + std::to_string(size) : "";
}

std::string rows_fault(std::span<const Object* const> things, int rows) {
  if (things.size() < 2) return "a single thing makes no row";
  const double yaw = things.front()->yaw;
  for (const double angle : {yaw, yaw + std::numbers::pi / 2.0})
    if (stand_in_rows(things, rows, angle)) return "";
  return rows == 1 ? "they do not stand in a row"
         : rows > 1 ? "they do not stand in " + std::to_string(rows) + " rows"
                    : "they do not stand in rows";
}

}  // namespace roomgen
