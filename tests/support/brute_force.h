#pragma once

// A second judge of finished rooms that shares nothing with the solver: points, winding numbers and a
// walk over cells. It is lenient by a few millimetres (cells: centimetres), so what it finds is wrong.

#include <deque>
#include <string>
#include <vector>

#include "collision/usability.h"
#include "roomgen/kinds/kind_table.h"
#include "support/rooms.h"
#include "support/shapes.h"

namespace brute_force {

using namespace roomgen;

/// Signed for boxes and ellipses alike: how far a point is outside of what the object covers, roughly
/// for ellipses; negative inside.
inline double outside_by(const Object& o, const Vec2& p) {
  const double c = std::cos(o.yaw), s = std::sin(o.yaw);
  const Vec2 d = p - o.position.head<2>();
  const Vec2 local(c * d.x() + s * d.y(), c * d.y() - s * d.x());
  const Vec2 half = 0.5 * o.size.head<2>();
  if (o.traits.round) {
    const double scale = local.cwiseQuotient(half).norm();
    return scale < 1e-9 ? -half.minCoeff() : local.norm() * (1.0 - 1.0 / scale);
  }
  const Vec2 beyond = local.cwiseAbs() - half;
  return beyond.maxCoeff() > 0 ? beyond.cwiseMax(0.0).norm() : beyond.maxCoeff();
}

inline double outside_by(const Footprint& f, const Vec2& p) {
  Object o = rooms::thing("", "", {2 * f.half().x(), 2 * f.half().y(), 1}, f.center());
  o.yaw = f.yaw();
  return outside_by(o, p);
}

inline std::vector<Vec2> points_of(const Object& o, double shrink = 0.0) {
  const Vec2 size = (o.size.head<2>().array() - 2 * shrink).max(1e-3).matrix();
  return shapes::sample(Footprint(o.position.head<2>(), size, o.yaw, o.traits.round), 6, 64);
}

inline bool heights_overlap(const Object& o, double low, double high) {
  return o.position.z() < high - 1e-3 && o.position.z() + o.size.z() > low + 1e-3;
}

/// The rectangle before an opening, `depth` deep, in coordinates along and into the room.
struct Strip {
  Vec2 start, along, into;
  double width, depth;
  bool holds(const Vec2& p, double margin) const {
    const double x = (p - start).dot(along), y = (p - start).dot(into);
    return x > margin && x < width - margin && y > margin && y < depth - margin;
  }
};

inline Strip strip(const Room& room, const Opening& opening) {
  const Vec2 a = room.polygon.points[opening.wall];
  const Vec2 b = room.polygon.points[(opening.wall + 1) % room.polygon.size()];
  const Vec2 along = (b - a).normalized();
  const bool swings = opening.type == OpeningType::door && opening.swing == DoorSwing::in;
  const double depth = opening.type == OpeningType::window ? 0.5 : swings ? 0.9 : 0.6;
  return {a + opening.from * along, along, {-along.y(), along.x()}, opening.to - opening.from, depth};
}

inline void check_openings(const Scene& scene, std::vector<std::string>& faults) {
  for (const auto& opening : scene.room.openings) {
    const Strip area = strip(scene.room, opening);
    const bool window = opening.type == OpeningType::window;
    for (const auto& o : scene.objects) {
      if (o.traits.flat || !heights_overlap(o, window ? opening.sill + 0.1 : 0.0, opening.head)) continue;
      bool inside = false;
      for (const auto& p : points_of(o, 0.002)) inside = inside || area.holds(p, 0.002);
      for (int i = 1; i < 30 && !inside; ++i)
        for (int j = 1; j < 30 && !inside; ++j)
          inside = outside_by(o, area.start + area.width * i / 30 * area.along +
                                     area.depth * j / 30 * area.into) < -0.003;
      if (inside) faults.push_back(o.id + " stands before " + opening.id);
    }
  }
}

inline void check_solids(const Scene& scene, std::vector<std::string>& faults) {
  for (const auto& a : scene.objects)
    for (const auto& b : scene.objects) {
      if (&a == &b || a.traits.flat || b.traits.flat ||
          !heights_overlap(a, b.position.z(), b.position.z() + b.size.z()))
        continue;
      for (const auto& p : points_of(a, 0.002))
        if (outside_by(b, p) < -0.003) {
          faults.push_back(a.id + " and " + b.id + " share space");
          break;
        }
    }
}

inline void check_inside(const Scene& scene, std::vector<std::string>& faults) {
  for (const auto& o : scene.objects) {
    bool inside = o.position.z() >= -1e-3 && o.position.z() + o.size.z() <= scene.room.height + 2e-3;
    for (const auto& p : points_of(o, 0.0015))
      inside = inside && shapes::winds_around(scene.room.polygon.points, p);
    for (const auto& corner : scene.room.polygon.points) inside = inside && outside_by(o, corner) > -0.003;
    if (!inside) faults.push_back(o.id + " is not inside the room");
  }
}

/// Where a person, thinner than the specification's by 2 cm, can walk to from the first door.
class Walk {
 public:
  explicit Walk(const Scene& scene) : scene_(scene) {
    for (const auto& p : scene.room.polygon.points) low_ = low_.cwiseMin(p), high_ = high_.cwiseMax(p);
    columns_ = static_cast<int>((high_.x() - low_.x()) / step) + 1;
    rows_ = static_cast<int>((high_.y() - low_.y()) / step) + 1;
    reached_.assign(static_cast<std::size_t>(columns_ * rows_), false);
    for (const auto& opening : scene.room.openings)
      if (opening.type != OpeningType::window) doors_.push_back(strip(scene.room, opening));
    walk();
  }

  bool touches(const Footprint& zone) const {
    for (int i = 0; i < columns_ * rows_; ++i)
      if (reached_[static_cast<std::size_t>(i)] && outside_by(zone, at(i)) < 0.27) return true;
    return false;
  }
  bool touches(const Strip& door) const {
    for (int i = 0; i < columns_ * rows_; ++i)
      if (reached_[static_cast<std::size_t>(i)] && door.holds(at(i), -0.03)) return true;
    return false;
  }
  const std::vector<Strip>& doors() const { return doors_; }

 private:
  static constexpr double step = 0.04;

  Vec2 at(int i) const { return low_ + step * Vec2(i % columns_ + 0.5, i / columns_ + 0.5); }
  bool may_stand(const Vec2& p) const {
    const auto& points = scene_.room.polygon.points;
    if (!shapes::winds_around(points, p)) return false;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vec2 a = points[k], along = points[(k + 1) % points.size()] - a;
      const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      if ((a + t * along - p).norm() < 0.23) return false;
    }
    for (const auto& o : scene_.objects)
      if (!o.traits.flat && o.position.z() < 1.9 && outside_by(o, p) < (o.traits.round ? 0.19 : 0.23))
        return false;
    return true;
  }
  void walk() {
    std::vector<bool> open(reached_.size());
    std::deque<int> queue;
    for (int i = 0; i < columns_ * rows_; ++i) {
      open[static_cast<std::size_t>(i)] = may_stand(at(i));
      const bool start = doors_.empty() || doors_.front().holds(at(i), -0.03);
      if (open[static_cast<std::size_t>(i)] && start) queue.push_back(i);
    }
    while (!queue.empty()) {
      const int i = queue.front();
      queue.pop_front();
      if (reached_[static_cast<std::size_t>(i)]) continue;
      reached_[static_cast<std::size_t>(i)] = true;
      for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di) {
          const int column = i % columns_ + di, row = i / columns_ + dj;
          if (column < 0 || row < 0 || column >= columns_ || row >= rows_) continue;
          const int next = row * columns_ + column;
          if (open[static_cast<std::size_t>(next)]) queue.push_back(next);
        }
    }
  }

  const Scene& scene_;
  Vec2 low_ = Vec2::Constant(1e9), high_ = Vec2::Constant(-1e9);
  int columns_ = 0, rows_ = 0;
  std::vector<bool> reached_;
  std::vector<Strip> doors_;
};

inline bool zone_is_free(const Scene& scene, const Object& owner, const Footprint& zone,
                         const UseZone& rule) {
  const auto& categories = KindTable::built_in();
  const Footprint core(zone.center(), (2 * zone.half()).array().max(0.05).matrix() - Vec2(0.045, 0.045),
                       zone.yaw());
  for (const auto& p : shapes::sample(core, 5, 48)) {
    if (!shapes::winds_around(scene.room.polygon.points, p)) return false;
    for (const auto& other : scene.objects)
      if (&other != &owner && !other.traits.flat && other.position.z() < 1.9 &&
          outside_by(other, p) < -0.005 && !categories.is_any_of(other.category, rule.partners))
        return false;
  }
  return true;
}

inline void check_use(const Scene& scene, std::vector<std::string>& faults) {
  const Walk walk(scene);
  for (const auto& door : walk.doors())
    if (!walk.touches(door)) faults.push_back("a door cannot be reached");
  for (const auto& o : scene.objects) {
    const auto& zones = KindTable::built_in().get(o.category).zones;
    bool usable = zones.empty() || o.traits.flat || o.mount != Mount::floor;
    for (const auto& rule : zones) {
      const Footprint zone = zone_footprint(footprint(o), rule);
      usable = usable || (zone_is_free(scene, o, zone, rule) && walk.touches(zone));
    }
    if (!usable) faults.push_back(o.id + " cannot be used");
  }
}

/// What is wrong with a scene of boxes, in words; empty if nothing is.
inline std::vector<std::string> faults(const Scene& scene) {
  std::vector<std::string> found;
  check_inside(scene, found);
  check_solids(scene, found);
  check_openings(scene, found);
  check_use(scene, found);
  return found;
}

}  // namespace brute_force
