#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>

#include "chain.h"
#include "checks.h"
#include "geometry/triangulate.h"
#include "rounds.h"

namespace roomgen::shape {

namespace {

constexpr std::size_t most_points = 4096;
constexpr int most_steps = 256;

// Blender's ratio of a chord to the handle at its ends; four points on a circle give a circle.
constexpr double chord_per_handle = 2.5614;

template <typename Point>
double angle_between(const Point& a, const Point& b) {
  const double scale = a.norm() * b.norm();
  return scale > 0 ? std::acos(std::clamp(a.dot(b) / scale, -1.0, 1.0)) : 0.0;
}

template <typename Point>
using Piece = std::array<Point, 4>;

template <typename Point>
Point at(const Piece<Point>& b, double t) {
  const double s = 1.0 - t;
  return s * s * s * b[0] + 3 * s * s * t * b[1] + 3 * s * t * t * b[2] + t * t * t * b[3];
}

// Three quarters of how far the handles end aside of the chord bound how far the piece does, as
// long as they end beside it.
template <typename Point>
bool is_near_chord(const Piece<Point>& b, double tolerance) {
  const Point chord = b[3] - b[0];
  const double length = chord.norm();
  for (int k : {1, 2}) {
    const double along = (b[k] - b[0]).dot(chord) / length;
    const double aside = (b[k] - b[0] - along / length * chord).norm();
    if (along < 0 || along > length || 0.75 * aside > tolerance) return false;
  }
  return true;
}

// So many chords that none is further than the tolerance from the piece (from the bound on its
// second derivative) nor turns too much.
template <typename Point>
int steps(const Piece<Point>& b, double tolerance, double max_turn) {
  const double turn = angle_between<Point>(b[1] - b[0], b[2] - b[1]) +
                      angle_between<Point>(b[2] - b[1], b[3] - b[2]);
  if (turn < 1e-6) return 1;
  const double bend = std::max((b[0] - 2 * b[1] + b[2]).norm(), (b[1] - 2 * b[2] + b[3]).norm());
  const double by_distance = is_near_chord(b, tolerance) ? 1.0 : std::sqrt(0.75 * bend / tolerance);
  return std::clamp(static_cast<int>(std::ceil(std::max(by_distance, turn / max_turn) - 0.01)), 1,
                    most_steps);
}

// The curve's points with equal neighbours taken out.
template <typename Point>
struct Knots {
  std::vector<Point> points;
  std::vector<bool> corner;
  bool closed = false;

  const Point& point(std::ptrdiff_t i) const {
    const auto n = static_cast<std::ptrdiff_t>(points.size());
    return points[static_cast<std::size_t>((i % n + n) % n)];
  }
  bool is_end(std::size_t i) const { return !closed && (i == 0 || i + 1 == points.size()); }

  // The unit tangent of a smooth point: the mean direction of the chords that meet there.
  Point tangent(std::size_t i) const {
    const auto k = static_cast<std::ptrdiff_t>(i);
    if (is_end(i)) {
      const std::ptrdiff_t other = i == 0 ? 1 : k - 1;
      return (i == 0 ? Point(point(other) - points[i]) : Point(points[i] - point(other)))
          .normalized();
    }
    const Point in = (points[i] - point(k - 1)).normalized();
    const Point out = (point(k + 1) - points[i]).normalized();
    const Point sum = in + out;
    return sum.norm() > 1e-6 ? Point(sum.normalized()) : Point(Point::Zero());
  }

  Piece<Point> piece(std::size_t i) const {
    const std::size_t j = (i + 1) % points.size();
    const Point chord = points[j] - points[i];
    const double handle = chord.norm() / chord_per_handle;
    const auto reach = [&](std::size_t k, double sign) -> Point {
      if (corner[k]) return sign * chord / 3.0;
      return sign * handle * tangent(k);
    };
    return {points[i], Point(points[i] + reach(i, 1.0)), Point(points[j] + reach(j, -1.0)),
            points[j]};
  }

  double turn(std::size_t i) const {
    const auto k = static_cast<std::ptrdiff_t>(i);
    return angle_between<Point>(points[i] - point(k - 1), point(k + 1) - points[i]);
  }
};

template <typename Point>
Result<Knots<Point>> knots(const Curve<Point>& curve) {
  if (curve.points.size() > most_points) return input_error("a curve has more than 4096 points");
  std::vector<bool> corner(curve.points.size(), false);
  for (auto index : curve.corners) {
    if (index >= corner.size()) return input_error("a corner of a curve is not one of its points");
    corner[index] = true;
  }
  Knots<Point> result;
  result.closed = curve.closed;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Point& p = curve.points[i];
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > greatest_size)
      return input_error("a point of a curve is not a number of at most 1000 m");
    if (!result.points.empty() && (p - result.points.back()).norm() < 1e-6) {
      if (corner[i]) result.corner.back() = true;
      continue;
    }
    result.points.push_back(p);
    result.corner.push_back(corner[i]);
  }
  while (curve.closed && result.points.size() > 1 &&
         (result.points.front() - result.points.back()).norm() < 1e-6) {
    if (result.corner.back()) result.corner.front() = true;
    result.points.pop_back();
    result.corner.pop_back();
  }
  if (result.points.size() < (curve.closed ? 3u : 2u))
    return input_error(curve.closed ? "a closed curve needs three points that differ"
                                    : "a curve needs two points that differ");
  return result;
}

template <typename Point>
Result<Chain<Point>> sampled(const Curve<Point>& curve, double tolerance, double max_turn) {
  if (auto status = check_tolerance(tolerance); !status) return status.error();
  const auto points = knots(curve);
  if (!points) return points.error();
  Chain<Point> chain;
  chain.closed = curve.closed;
  const std::size_t count = points->points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const bool crease = points->corner[i] && !points->is_end(i) && points->turn(i) > crease_angle;
    chain.add(points->points[i], crease);
    if (!curve.closed && i + 1 == count) break;
    const auto piece = points->piece(i);
    const int n = steps(piece, tolerance, max_turn);
    for (int k = 1; k < n; ++k) chain.add(at(piece, static_cast<double>(k) / n), false);
  }
  return chain;
}

template <typename Point>
std::vector<Point> points_of(const Curve<Point>& curve, double tolerance) {
  auto chain = sampled(curve, tolerance, pi / 4);
  return chain ? chain->points : std::vector<Point>();
}

template <typename Point>
Curve<Point> all_corners(std::vector<Point> points, bool closed) {
  Curve<Point> curve{std::move(points), {}, closed};
  curve.corners.resize(curve.points.size());
  std::iota(curve.corners.begin(), curve.corners.end(), std::size_t{0});
  return curve;
}

}  // namespace

Result<Chain2> sample(const Curve<Vec2>& curve, double tolerance, double max_turn) {
  return sampled(curve, tolerance, max_turn);
}
Result<Chain3> sample(const Curve<Vec3>& curve, double tolerance, double max_turn) {
  return sampled(curve, tolerance, max_turn);
}

Result<Chain2> sample_outline(const Curve<Vec2>& outline, double tolerance,
                              const std::string& what) {
  Curve<Vec2> closed = outline;
  closed.closed = true;
  auto chain = sample(closed, tolerance);
  if (!chain) return with_context(chain.error(), what);
  if (!is_simple(chain->points)) return input_error(what + ": the outline crosses itself");
  const double area = signed_area(chain->points);
  if (std::abs(area) < 1e-9) return input_error(what + ": the outline encloses no area");
  if (area < 0) reverse(*chain);
  return chain;
}

void reverse(Chain2& chain) {
  std::reverse(chain.points.begin(), chain.points.end());
  std::reverse(chain.crease.begin(), chain.crease.end());
}

std::vector<Vec3> polyline(const Curve<Vec3>& curve, double tolerance) {
  return points_of(curve, tolerance);
}
std::vector<Vec2> polyline(const Curve<Vec2>& curve, double tolerance) {
  return points_of(curve, tolerance);
}

Curve<Vec2> straight(std::vector<Vec2> points, bool closed) {
  return all_corners(std::move(points), closed);
}
Curve<Vec3> straight(std::vector<Vec3> points, bool closed) {
  return all_corners(std::move(points), closed);
}

}  // namespace roomgen::shape
