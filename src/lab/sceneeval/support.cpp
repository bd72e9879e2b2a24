#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/random.h"
#include "geometry/convex_hull.h"
#include "physics.h"

namespace roomgen::lab::sceneeval {

namespace {

constexpr double lift = 0.005;
constexpr double reach = 0.01;  // of a contact, and how near to the foremost point rays start
constexpr double facing = 0.9;
constexpr double points_per_square_metre = 256.0;
constexpr std::size_t least_points_a_face = 32;
constexpr std::size_t most_points = 100000;
constexpr std::size_t least_contacts = 4;
constexpr double no_area = 1e-12;  // of contacts in one line, m2

struct Pull {
  Vec3 direction = -Vec3::UnitZ();
  bool hangs = false;  ///< one contact is enough
};

Pull pull_of(const Thing& thing, Mount mount) {
  if (mount == Mount::wall) return {-thing.box().front(), true};
  if (mount == Mount::ceiling) return {Vec3::UnitZ(), true};
  return {};
}

// The vertices next to the foremost one, and points on the faces between them that look along the pull.
std::vector<Vec3> ray_origins(const Mesh& mesh, const Vec3& direction) {
  double foremost = -1e300;
  for (const auto& p : mesh.positions)
    foremost = std::max(foremost, direction.dot(p.cast<double>()));
  std::vector<bool> near(mesh.positions.size());
  std::vector<Vec3> origins;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Vec3 p = mesh.positions[i].cast<double>();
    near[i] = direction.dot(p) >= foremost - reach;
    if (near[i]) origins.push_back(p);
  }
  struct Face {
    Vec3 corner, u, v;
  };
  std::vector<Face> faces;
  double largest = 0.0;
  for (const auto& t : mesh.triangles) {
    if (!near[t[0]] || !near[t[1]] || !near[t[2]]) continue;
    const Vec3 a = mesh.positions[t[0]].cast<double>();
    const Vec3 u = mesh.positions[t[1]].cast<double>() - a;
    const Vec3 v = mesh.positions[t[2]].cast<double>() - a;
    const Vec3 normal = u.cross(v);
    if (std::abs(normal.dot(direction)) <= facing * normal.norm()) continue;
    largest = std::max(largest, 0.5 * normal.norm());
    faces.push_back({a, u, v});
  }
  if (faces.empty()) return origins;
  std::size_t each = std::max(least_points_a_face,
                              static_cast<std::size_t>(largest * points_per_square_metre));
  each = std::max<std::size_t>(1, std::min(each, most_points / faces.size()));
  Random random(0);
  for (const auto& face : faces)
    for (std::size_t i = 0; i < each; ++i) {
      double s = random.uniform(), t = random.uniform();
      if (s + t > 1.0) s = 1.0 - s, t = 1.0 - t;
      origins.push_back(face.corner + s * face.u + t * face.v);
    }
  return origins;
}

// Where a ray along the pull meets the floor or the ceiling.
std::optional<double> meets_room(const Vec3& origin, const Vec3& direction, const Room& room) {
  if (std::abs(direction.z()) < 0.5) return std::nullopt;
  const double distance = direction.z() < 0.0 ? origin.z() : room.height - origin.z();
  const Vec2 place = origin.head<2>();
  if (distance < 0.0 || distance >= reach) return std::nullopt;
  if (!is_over_floor(place, room)) return std::nullopt;
  return distance;
}

class Contacts {
 public:
  Contacts(const Vec3& direction, const std::vector<Vec3>& origins)
      : direction_(direction), origins_(origins) {
    for (const auto& origin : origins_) {
      reached_.add(origin);
      reached_.add(origin + reach * direction_);
    }
  }

  void with(const Thing& thing) {
    if ((thing.bounds().low.array() > reached_.high.array()).any() ||
        (reached_.low.array() > thing.bounds().high.array()).any())
      return;
    for (const auto& origin : origins_)
      if (const auto hit = thing.ray(origin, direction_); hit && *hit < reach)
        points_.push_back(origin + *hit * direction_);
  }
  void with(const Room& room) {
    for (const auto& origin : origins_)
      if (const auto hit = meets_room(origin, direction_, room))
        points_.push_back(origin + *hit * direction_);
  }
  const std::vector<Vec3>& points() const { return points_; }

 private:
  Vec3 direction_;
  const std::vector<Vec3>& origins_;
  Bounds3 reached_;
  std::vector<Vec3> points_;
};

bool is_supported(std::size_t index, std::span<const Thing> things, const Pull& pull,
                  const Room& room, const RoomThings& parts) {
  const Thing& thing = things[index];
  auto origins = ray_origins(thing.mesh(), pull.direction);
  for (auto& origin : origins) origin -= lift * pull.direction;
  Contacts contacts(pull.direction, origins);
  for (std::size_t i = 0; i < things.size(); ++i)
    if (i != index) contacts.with(things[i]);
  for (const auto* kind : {&parts.walls, &parts.doors, &parts.windows})
    for (const auto& part : *kind) contacts.with(part);
  contacts.with(room);
  if (pull.hangs) return !contacts.points().empty();
  if (contacts.points().size() < least_contacts) return false;
  std::vector<Vec2> places;
  for (const auto& point : contacts.points()) places.push_back(point.head<2>());
  const auto hull = convex_hull(std::move(places));
  return signed_area(hull) > no_area && depth_in(hull, thing.centroid().head<2>()) >= 0.0;
}

}  // namespace

std::vector<bool> supported(std::span<const Thing> things, std::span<const Mount> mounts,
                            const Room& room, const RoomThings& parts) {
  std::vector<bool> result;
  for (std::size_t i = 0; i < things.size(); ++i)
    result.push_back(is_supported(i, things, pull_of(things[i], mounts[i]), room, parts));
  return result;
}

}  // namespace roomgen::lab::sceneeval
