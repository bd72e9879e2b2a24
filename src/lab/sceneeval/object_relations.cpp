#include "object_relations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace roomgen::lab::sceneeval {

namespace {

constexpr double epsilon = 1e-6;
constexpr double max_deviation = 30.0;  // degrees
constexpr double side_margin = 0.25;
constexpr double middle_deviation = 0.25;
constexpr double distance_deviation = 0.25;

// The share of the target's box for which the test holds.
template <typename Test>
double share(const Thing& target, Test test) {
  const auto points = target.box().points();
  const auto held = std::count_if(points.begin(), points.end(), test);
  return static_cast<double>(held) / static_cast<double>(points.size());
}

double ranged(const Thing& target, const Thing& anchor, double low, double high) {
  return distance_score(distance_between(target, anchor), low, high, distance_deviation);
}

// For each direction the angle to the nearest other one counter-clockwise; where none is (all lie
// within half a turn clockwise) to the nearest clockwise.
std::vector<double> neighbour_angles(const std::vector<Vec3>& directions) {
  std::vector<double> result;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    double ahead = std::numeric_limits<double>::infinity();
    double behind = ahead;
    for (std::size_t j = 0; j < directions.size(); ++j) {
      if (i == j) continue;
      const double angle = std::acos(std::clamp(directions[i].dot(directions[j]), -1.0, 1.0));
      const bool is_behind = directions[i].cross(directions[j]).z() < 0.0;
      if (angle > 0.0 && !is_behind) ahead = std::min(ahead, angle);
      if (angle > 0.0 && is_behind) behind = std::min(behind, angle);
    }
    result.push_back(std::isfinite(ahead) ? ahead : std::isfinite(behind) ? behind : 0.0);
  }
  return result;
}

}  // namespace

double distance_score(double distance, double low, double high, double deviation) {
  if (low < distance && distance < high) return 1.0;
  const double excess = std::min(std::abs(distance - low), std::abs(distance - high));
  return std::exp(-excess * excess / (2.0 * deviation * deviation));
}

double distance_between(const Thing& a, const Thing& b) {
  return a.box().volume() < b.box().volume() ? b.distance_from(a.box()) : a.distance_from(b.box());
}

double inside_of(const Thing& target, const Thing& anchor) {
  return share(target, [&](const Vec3& p) { return anchor.box().contains(p); });
}

double outside_of(const Thing& target, const Thing& anchor) {
  return 1.0 - inside_of(target, anchor);
}

double face_to(const Thing& target, const Thing& anchor) {
  const Vec3 front = target.box().front();
  Vec3 mean = Vec3::Zero();
  int hits = 0;
  for (const auto& point : target.box().points()) {
    const auto distance = anchor.ray(point, front);
    if (!distance) continue;
    mean += point + *distance * front;
    ++hits;
  }
  if (hits == 0) return 0.0;
  const Vec2 towards = (mean / hits - target.box().center).head<2>();
  const double cosine = front.head<2>().dot(towards) / (towards.norm() + epsilon);
  const double deviation = degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
  return std::clamp(1.0 - deviation / max_deviation, 0.0, 1.0);
}

double side_of(const Thing& target, const Thing& anchor, BoxSide side) {
  return share(target,
               [&](const Vec3& p) { return anchor.box().at_side(p, side, true, side_margin); });
}

double side_region(const Thing& target, const Thing& anchor, BoxSide side) {
  return share(target, [&](const Vec3& p) {
    return anchor.box().contains(p) && anchor.box().at_side(p, side, false, exact_margin);
  });
}

double long_short_side_of(const Thing& target, const Thing& anchor, bool long_side) {
  const Vec3& half = anchor.box().half;
  // As numpy.allclose compares the full lengths.
  if (std::abs(half.x() - half.y()) <= 0.5e-8 + 1e-5 * half.y()) return 0.0;
  const bool left_and_right = (half.x() < half.y()) == long_side;
  const auto at = [&](BoxSide side) {
    return share(target, [&](const Vec3& p) {
      return anchor.box().at_side(p, side, false, exact_margin);
    });
  };
  return left_and_right ? std::max(at(BoxSide::left), at(BoxSide::right))
                        : std::max(at(BoxSide::front), at(BoxSide::back));
}

double on_top(const Thing& target, const Thing& anchor) {
  return share(target, [&](const Vec3& p) {
    return anchor.box().at_side(p, BoxSide::top, false, exact_margin);
  });
}

double middle_of(const Thing& target, const Thing& anchor) {
  const double distance = (target.box().center - anchor.box().center).head<2>().norm();
  return std::exp(-distance * distance / (2.0 * middle_deviation * middle_deviation));
}

double surround(std::span<const Thing> targets, const Thing& anchor) {
  const std::size_t count = targets.size();
  if (count < 3) return 0.0;
  std::vector<double> distances;
  std::vector<Vec3> directions;
  for (const auto& target : targets) {
    const Vec3 offset = target.box().center - anchor.box().center;
    distances.push_back(std::max(offset.norm(), epsilon));
    directions.push_back(offset / distances.back());
  }
  auto sorted = distances;
  std::sort(sorted.begin(), sorted.end());
  const double usual = 0.5 * (sorted[(count - 1) / 2] + sorted[count / 2]);
  const double even = 2.0 * pi / static_cast<double>(count);
  const auto angles = neighbour_angles(directions);
  double score = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double far_off = std::clamp(std::abs(distances[i] - usual) / usual, 0.0, 1.0);
    const double turned_off = std::clamp(std::abs(angles[i] - even) / even, 0.0, 1.0);
    score += 0.5 * (1 - far_off) * (1 - far_off) + 0.5 * (1 - turned_off) * (1 - turned_off);
  }
  return score / static_cast<double>(count);
}

double next_to(const Thing& target, const Thing& anchor) { return ranged(target, anchor, 0, 0.5); }
double near(const Thing& target, const Thing& anchor) { return ranged(target, anchor, 0.5, 1.5); }
double across_from(const Thing& target, const Thing& anchor) {
  return ranged(target, anchor, 1.5, 4.0);
}
double far(const Thing& target, const Thing& anchor) {
  return ranged(target, anchor, 4.0, std::numeric_limits<double>::infinity());
}

}  // namespace roomgen::lab::sceneeval
