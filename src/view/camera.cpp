#include "camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "eye_camera.h"
#include "scene/dwelling.h"

namespace roomgen {

namespace {

// Above the horizon; steeper than a true isometric view so that more of the floor shows.
const double iso_elevation = radians(38.0);
constexpr double top_margin = 0.15, iso_margin = 0.18;
// Marks need room for coordinates beside the walls, in parts of the longer side.
constexpr double marks_margin = 0.08;
constexpr double part_margin = 0.16;  // of what is shown of a room
constexpr double least_part = 0.2;    // metres, of that

Vec3 horizontal(const Vec2& direction, double z = 0.0) {
  return {direction.x(), direction.y(), z};
}

// How well the room shows when the viewer looks from `to_viewer`: objects should show their fronts,
// and tall things should not stand in front of the rest.
double corner_score(const Scene& scene, const Vec2& to_viewer) {
  Bounds2 extent;
  for (const auto& room : rooms_of(scene))
    for (const auto& p : room.polygon.points) extent.add(p);
  const Vec2 middle = 0.5 * (extent.low + extent.high);
  const double radius = std::max(0.5 * extent.size().norm(), 1e-6);
  double score = 0.0;
  for (const auto& object : scene.objects) {
    const double weight = object.size.x() * std::min(object.size.z(), 2.0);
    if (object.traits.front && !object.traits.flat)
      score += weight * front_direction(object.yaw).dot(to_viewer);
    const double nearness = (object.position.head<2>() - middle).dot(to_viewer) / radius;
    if (nearness > 0) score -= 1.5 * nearness * weight * std::max(0.0, top(object) - 0.6);
  }
  for (const auto& room : rooms_of(scene))
    for (const auto& opening : room.openings)
      score += 0.15 * opening.width() * inward(room, opening).dot(to_viewer);
  return score;
}

Vec2 longest_wall_direction(const Room& room) {
  std::size_t longest = 0;
  for (std::size_t k = 1; k < room.polygon.size(); ++k)
    if (room.polygon.edge(k).length() > room.polygon.edge(longest).length() + 1e-9) longest = k;
  return room.polygon.edge(longest).direction();
}

// One of the four diagonals of the room; the horizontal direction towards the viewer.
Vec2 choose_corner(const Scene& scene) {
  const Vec2 along = longest_wall_direction(rooms_of(scene)[0]);
  Vec2 best = rotated(along, 0.25 * pi);
  double best_score = -std::numeric_limits<double>::max();
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Vec2 candidate = rotated(along, 0.25 * pi + 0.5 * pi * quarter);
    // Without reasons look from the front, as on a plan lying on a table.
    const double score = corner_score(scene, candidate) - 1e-3 * candidate.y();
    if (score > best_score + 1e-9) {
      best = candidate;
      best_score = score;
    }
  }
  return best;
}

// A visitor of a dwelling stands in its largest room.
Scene largest_part(const Scene& scene) {
  const auto parts = parts_of(scene);
  return *std::max_element(parts.begin(), parts.end(), [](const Scene& a, const Scene& b) {
    return area(a.room.polygon) < area(b.room.polygon);
  });
}

void aim(Camera& camera, const Scene& scene, const View& view) {
  if (view.kind == View::Kind::top) return;
  const Vec2 to_viewer = choose_corner(scene);
  camera.backward = horizontal(std::cos(iso_elevation) * to_viewer, std::sin(iso_elevation));
  camera.right = horizontal(left_of(to_viewer));
  camera.up = camera.backward.cross(camera.right);
}

std::vector<Vec3> points_to_show(const Scene& scene, const Camera& camera, const View& view) {
  std::vector<Vec3> points;
  const auto rooms = rooms_of(scene);
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const auto outline = offset_outward(rooms[i].polygon, wall_thickness);
    const auto heights = wall_heights(rooms, i, view, camera);
    const std::size_t n = outline.size();
    for (std::size_t k = 0; k < n; ++k) {
      points.push_back(horizontal(outline[k], -0.1));
      points.push_back(horizontal(outline[k], heights[k]));
      points.push_back(horizontal(outline[(k + 1) % n], heights[k]));
    }
  }
  for (const auto& object : scene.objects)
    for (const auto& corner : box_corners(object)) points.push_back(corner);
  return points;
}

void fit(Camera& camera, const std::vector<Vec3>& points, const View& view) {
  Bounds2 extent;
  camera.far = std::numeric_limits<double>::max();
  camera.near = std::numeric_limits<double>::lowest();
  for (const auto& p : points) {
    extent.add({camera.right.dot(p), camera.up.dot(p)});
    camera.far = std::min(camera.far, camera.depth(p) - 0.5);
    camera.near = std::max(camera.near, camera.depth(p) + 0.5);
  }
  const bool plan = view.kind == View::Kind::top;
  double margin = plan ? top_margin : iso_margin;
  if (plan && view.marks) margin = std::max(margin, marks_margin * extent.size().maxCoeff());
  const Vec2 size = extent.size() + Vec2::Constant(2.0 * margin);
  camera.center = 0.5 * (extent.low + extent.high);
  camera.pixels_per_metre = view.pixels / size.maxCoeff();
  const auto side = [&](double metres) {
    const int pixels = static_cast<int>(std::lround(metres * camera.pixels_per_metre));
    return std::clamp(pixels, std::min(min_picture_pixels, view.pixels), view.pixels);
  };
  camera.width = side(size.x());
  camera.height = side(size.y());
}

// With room for coordinates around it.
void aim_at_part(Camera& camera, const View& view) {
  const Vec2 shown = view.part->size().cwiseMax(least_part);
  const Vec2 size =
      shown + Vec2::Constant(2.0 * (wall_thickness + part_margin * shown.maxCoeff()));
  camera.center = 0.5 * (view.part->low + view.part->high);
  camera.pixels_per_metre = view.pixels / size.maxCoeff();
  camera.width = std::max(min_picture_pixels, static_cast<int>(size.x() * camera.pixels_per_metre));
  camera.height = std::max(min_picture_pixels, static_cast<int>(size.y() * camera.pixels_per_metre));
}

// Would a wall of full height hide floor behind it? Only in rooms that are not convex, and in
// dwellings.
bool hides_floor(std::span<const Room> rooms, std::size_t index, std::size_t wall,
                 const Camera& camera) {
  const Room& room = rooms[index];
  const Vec2 away = -camera.backward.head<2>().normalized();
  const double shadow = room.height / std::tan(iso_elevation);
  const Segment edge = room.polygon.edge(wall);
  for (const double along : {0.1, 0.3, 0.5, 0.7, 0.9})
    for (double d = 0.3; d < shadow; d += 0.2) {
      const Vec2 behind = edge.a + along * (edge.b - edge.a) + d * away;
      for (const auto& other : rooms)
        if (contains(other.polygon, behind)) return true;
    }
  return false;
}

bool is_shared(const std::vector<SharedStretch>& stretches, std::size_t wall) {
  return std::any_of(stretches.begin(), stretches.end(),
                     [&](const SharedStretch& stretch) { return stretch.wall == wall; });
}

}  // namespace

std::vector<Vec3> box_corners(const Object& object) {
  std::vector<Vec3> corners;
  const Footprint rectangle(object.position.head<2>(), object.size.head<2>(), object.yaw);
  for (const auto& corner : rectangle.outline()) {
    corners.push_back(horizontal(corner, bottom(object)));
    corners.push_back(horizontal(corner, top(object)));
  }
  return corners;
}

std::vector<double> wall_heights(std::span<const Room> rooms, std::size_t index, const View& view,
                                 const Camera& camera) {
  const Room& room = rooms[index];
  const auto shared = shared_stretches(rooms, index);
  std::vector<double> heights(room.polygon.size(), room.height);
  if (view.kind == View::Kind::eye) return heights;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (view.kind == View::Kind::top) {
      heights[k] = std::min(room.height, plan_cut_height);
      continue;
    }
    const bool faces_viewer = room.polygon.inward(k).dot(camera.backward.head<2>()) > 0.05;
    if (is_shared(shared, k))
      heights[k] = std::min(room.height, inner_wall_height);
    else if (!faces_viewer || hides_floor(rooms, index, k, camera))
      heights[k] = std::min(room.height, hidden_wall_height);
  }
  return heights;
}

bool hangs_on_lowered_wall(const Room& room, const Object& object,
                           const std::vector<double>& heights) {
  if (object.mount != Mount::wall) return false;
  constexpr double at_wall = 0.1;
  const Footprint box = footprint(object);
  const Vec2 back = box.to_world({0.0, box.half().y()});
  for (std::size_t k = 0; k < heights.size(); ++k)
    if (heights[k] < std::min(top(object), room.height) - 1e-3 &&
        distance(room.polygon.edge(k), back) < at_wall)
      return true;
  return false;
}

Result<Camera> make_camera(const Scene& scene, const View& view) {
  if (auto status = check_picture_side(view.pixels); !status) return status.error();
  if (rooms_of(scene)[0].polygon.size() < 3)
    return Error{Error::Kind::invalid_input, "the room has no floor to look at"};
  if (view.kind == View::Kind::elevation)
    return Error{Error::Kind::invalid_input, "an elevation is a drawing that no camera sees"};
  if (view.kind == View::Kind::eye) return detail::eye_camera(largest_part(scene), view.pixels);
  Camera camera;
  aim(camera, scene, view);
  fit(camera, points_to_show(scene, camera, view), view);
  if (view.part && view.kind == View::Kind::top) aim_at_part(camera, view);
  return camera;
}

}  // namespace roomgen
