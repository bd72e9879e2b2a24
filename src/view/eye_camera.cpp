#include "eye_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace roomgen::detail {

namespace {

constexpr double aspect = 0.75;           // height of the picture by its width
constexpr double lowest_head_room = 0.3;  // of the eye under the ceiling
constexpr double head = 0.3;              // above and below the eye, what a thing must leave free
constexpr double grid = 0.25;             // of places to stand, where doors and corners will not do
// The horizon lies above the middle of the picture: furniture stands on the floor. The lens is
// shifted rather than the camera tilted, so that walls stay upright.
constexpr double shift = 0.14;  // of the picture's width
constexpr int rays = 48;        // across the picture, to measure what is seen
constexpr int eye_directions = 48;
constexpr double comfortable = 1.6;  // metres of air before the eye
constexpr double nearest = 0.05;     // metres before the eye that are drawn

double eye_height(const Room& room) {
  return std::min(eye_level, std::max(0.5 * room.height, room.height - lowest_head_room));
}

// Things at the height of the eye: they block the view and the viewer.
std::vector<Footprint> obstacles(const Scene& scene, double height) {
  std::vector<Footprint> result;
  for (const auto& object : scene.objects)
    if (top(object) > height - head && bottom(object) < height + head)
      result.push_back(footprint(object));
  return result;
}

std::vector<Footprint> low_things(const Scene& scene, double height) {
  std::vector<Footprint> result;
  for (const auto& object : scene.objects)
    if (top(object) > 0.3 && bottom(object) < height) result.push_back(footprint(object));
  return result;
}

// What the room is about: what takes most floor together with what stands to it.
const Object* main_thing(const Scene& scene) {
  std::map<std::string_view, double> worth;
  std::map<std::string_view, std::string_view> leaders;  // the first of each group
  for (const auto& object : scene.objects) {
    if (object.traits.flat || object.mount == Mount::surface) continue;
    const double area = footprint(object).area();
    worth[object.id] += area;
    if (!object.group.empty())
      worth[leaders.try_emplace(object.group, object.id).first->second] += 0.5 * area;
    for (const auto& relation : object.relations)
      if (relation.kind != RelationKind::far) worth[relation.target] += 0.25 * area;
  }
  const Object* best = nullptr;
  for (const auto& object : scene.objects)
    if (worth.count(object.id) && (!best || worth[object.id] > worth[best->id])) best = &object;
  return best;
}

class Watcher {
 public:
  explicit Watcher(const Scene& scene)
      : scene_(scene),
        height_(eye_height(scene.room)),
        obstacles_(obstacles(scene, height_)),
        low_things_(low_things(scene, height_)),
        main_(main_thing(scene)),
        reach_(bounds(scene.room.polygon).size().norm() + 1.0) {}

  Standpoint best() const {
    Standpoint standpoint;
    double most = -1.0;
    for (const Vec2& place : places()) {
      // Doors and corners first; any later one must be clearly better.
      const Sighted sighted = look_around(place);
      if (sighted.worth <= most * 1.02) continue;
      most = sighted.worth;
      standpoint = {Vec3(place.x(), place.y(), height_), sighted.towards};
    }
    return standpoint;
  }

 private:
  struct Sighted {
    Vec2 towards = Vec2::UnitY();
    double worth = 0.0;
  };

  // How far everything is from the eye at this place; negative outside the room.
  double clearance(const Vec2& place) const {
    const Polygon& polygon = scene_.room.polygon;
    if (!contains(polygon, place)) return -1.0;
    double free = distance_to_boundary(polygon, place);
    for (const auto& obstacle : obstacles_) free = std::min(free, gap(obstacle, place));
    return free;
  }

  std::vector<Vec2> places() const {
    std::vector<Vec2> all;
    for (const auto& opening : scene_.room.openings) {
      if (!opening.is_entrance()) continue;
      const Vec2 in = inward(scene_.room, opening);
      add_first_free(all, segment(scene_.room, opening).middle(), in);
    }
    const Polygon& polygon = scene_.room.polygon;
    const std::size_t n = polygon.size();
    for (std::size_t k = 0; k < n; ++k) {
      if (!polygon.is_convex_corner(k)) continue;
      const Vec2 middle = polygon.inward(k) + polygon.inward((k + n - 1) % n);
      if (middle.norm() > 1e-6) add_first_free(all, polygon.points[k], middle.normalized());
    }
    return all.empty() ? freest_places() : all;
  }

  // The first place on the way from the door or the corner into the room that is free.
  void add_first_free(std::vector<Vec2>& all, const Vec2& from, const Vec2& way) const {
    for (const double step : {0.3, 0.4, 0.5, 0.6, 0.75, 0.9}) {
      const Vec2 place = from + step * way;
      if (clearance(place) < eye_clearance) continue;
      all.push_back(place);
      return;
    }
  }

  // In a crowded room: the place with the most air around it.
  std::vector<Vec2> freest_places() const {
    const Bounds2 extent = bounds(scene_.room.polygon);
    Vec2 freest = scene_.room.polygon.points.front();
    double most = -2.0;
    const Vec2 size = extent.size();
    const int columns = steps(size.x()), rows = steps(size.y());
    for (int i = 1; i < columns; ++i)
      for (int j = 1; j < rows; ++j) {
        const Vec2 place = extent.low + Vec2(size.x() * i / columns, size.y() * j / rows);
        const double free = clearance(place);
        if (free > most + 1e-9) {
          most = free;
          freest = place;
        }
      }
    return {freest};
  }

  static int steps(double length) {
    return std::clamp(static_cast<int>(std::ceil(length / grid)), 4, 200);
  }

  double sight(const Vec2& from, const Vec2& direction) const {
    double distance = reach_;
    for (std::size_t k = 0; k < scene_.room.polygon.size(); ++k) {
      const Segment wall = scene_.room.polygon.edge(k);
      const Vec2 along = wall.b - wall.a;
      const double turn = cross(direction, along);
      if (std::abs(turn) < 1e-12) continue;
      const double d = cross(wall.a - from, along) / turn,
                   at = cross(wall.a - from, direction) / turn;
      if (d > 0 && at >= 0 && at <= 1) distance = std::min(distance, d);
    }
    for (const auto& obstacle : obstacles_)
      if (const double d = ray_hit(obstacle, from, direction); d >= 0)
        distance = std::min(distance, d);
    return distance;
  }

  // The direction in which most floor and most fronts of things are seen.
  Sighted look_around(const Vec2& place) const {
    Sighted best;
    for (int i = 0; i < eye_directions; ++i) {
      const Vec2 towards = rotated(Vec2::UnitY(), 2.0 * pi * i / eye_directions);
      const double worth = (seen_floor(place, towards) + 1.5 * seen_things(place, towards)) *
                           airiness(place, towards) * (0.5 + attention(place, towards));
      if (worth > best.worth + 1e-9) best = {towards, worth};
    }
    return best;
  }

  double seen_floor(const Vec2& place, const Vec2& towards) const {
    double area = 0.0;
    for (int i = 0; i < rays; ++i) {
      const double angle = eye_view_angle * ((i + 0.5) / rays - 0.5);
      const double distance = sight(place, rotated(towards, angle));
      area += 0.5 * distance * distance * eye_view_angle / rays;
    }
    return area;
  }

  // A bed or a table right before the eye fills the picture and hides the rest.
  double airiness(const Vec2& place, const Vec2& towards) const {
    double sum = 0.0;
    constexpr int few_rays = 12;
    for (int i = 0; i < few_rays; ++i) {
      const Vec2 ray = rotated(towards, eye_view_angle * ((i + 0.5) / few_rays - 0.5));
      double distance = sight(place, ray);
      for (const auto& thing : low_things_)
        if (const double d = ray_hit(thing, place, ray); d >= 0) distance = std::min(distance, d);
      sum += std::min(1.0, distance / comfortable);
    }
    return 0.3 + 0.7 * sum / few_rays;
  }

  // How well a thing is seen within so much of the picture: 0 not at all, 1 from its front.
  double seen(const Object& object, const Vec2& place, const Vec2& towards, double share) const {
    const Vec2 way = object.position.head<2>() - place;
    const double distance = way.norm();
    if (distance < 0.3 || std::acos(std::clamp(way.dot(towards) / distance, -1.0, 1.0)) >
                              0.5 * share * eye_view_angle)
      return 0.0;
    if (sight(place, way / distance) < distance - 0.5 * object.size.head<2>().norm()) return 0.0;
    const double front =
        object.traits.front ? -front_direction(object.yaw).dot(way / distance) : 0.5;
    return 0.5 + 0.5 * std::max(0.0, front);
  }

  // By their size, and more if they show their fronts.
  double seen_things(const Vec2& place, const Vec2& towards) const {
    double sum = 0.0;
    for (const auto& object : scene_.objects)
      if (!object.traits.flat)
        sum += object.size.x() * std::min(object.size.z(), 2.0) * seen(object, place, towards, 0.84);
    return sum;
  }

  // What the room is about is in the midst of the picture, whole, and seen from where people use it.
  double attention(const Vec2& place, const Vec2& towards) const {
    constexpr double whole = 1.2;  // of its length, from which it does not fill the picture
    if (!main_) return 0.0;
    const double distance = (main_->position.head<2>() - place).norm();
    const double is_whole = std::min(1.0, distance / (whole * main_->size.head<2>().maxCoeff()));
    return is_whole * seen(*main_, place, towards, 0.6);
  }

  const Scene& scene_;
  double height_;
  std::vector<Footprint> obstacles_, low_things_;
  const Object* main_;
  double reach_;
};

}  // namespace

Standpoint choose_standpoint(const Scene& scene) {
  return Watcher(scene).best();
}

Camera eye_camera(const Scene& scene, int pixels) {
  const Standpoint standpoint = choose_standpoint(scene);
  Camera camera;
  camera.eye = standpoint.eye;
  camera.backward << -standpoint.towards, 0.0;
  camera.right << -left_of(standpoint.towards), 0.0;
  camera.up = Vec3::UnitZ();
  camera.width = pixels;
  camera.height = static_cast<int>(std::lround(aspect * pixels));
  const double half_width = std::tan(0.5 * eye_view_angle);
  camera.pixels_per_metre = 0.5 * pixels / half_width;
  camera.center = {0.0, -2.0 * shift * half_width};
  const double eye_depth = camera.depth(*camera.eye);
  camera.near = eye_depth - nearest;
  const Bounds2 extent = bounds(scene.room.polygon);
  camera.far = eye_depth - (extent.size().norm() + 2.0);
  return camera;
}

}  // namespace roomgen::detail
