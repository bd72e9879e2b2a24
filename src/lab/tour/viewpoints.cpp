#include "viewpoints.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/random.h"
#include "camera_pose.h"
#include "geometry/convex_hull.h"
#include "view/camera.h"

namespace roomgen::lab::detail {

namespace {

constexpr double front_weight = 0.1, way_weight = 0.05;
constexpr int angle_decimals = 3;  // of degrees, as in files
constexpr double nearest_corner = 0.06;  // metres before the eye, beyond what is not drawn

double rounded_angle(double angle) { return wrap_angle(radians(rounded(degrees(angle), angle_decimals))); }

struct Aim {
  double yaw = 0.0, pitch = 0.0;
};

// At the middle of what the corners span, seen from the eye.
Aim aim_at(const std::vector<Vec3>& corners, const Vec3& eye, const Vec2& center) {
  const double ahead = yaw_facing(center - eye.head<2>());
  Bounds2 span;
  for (const auto& corner : corners) {
    const Vec2 way = corner.head<2>() - eye.head<2>();
    span.add({wrap_angle(yaw_facing(way) - ahead), std::atan2(corner.z() - eye.z(), way.norm())});
  }
  const Vec2 middle = 0.5 * (span.low + span.high);
  return {ahead + middle.x(), middle.y()};
}

// Pixels that the hull of the corners covers; nothing if it is not wholly in the picture.
std::optional<double> area_in_picture(const Camera& camera, const std::vector<Vec3>& corners) {
  std::vector<Vec2> pixels;
  for (const auto& corner : corners) {
    if (camera.distance(corner) < nearest_corner) return std::nullopt;
    const Vec2 pixel = camera.pixel(corner);
    if (!(pixel.minCoeff() >= 0 && pixel.x() <= camera.width && pixel.y() <= camera.height)) return std::nullopt;
    pixels.push_back(pixel);
  }
  return signed_area(convex_hull(std::move(pixels)));
}

bool in_range(const TourOptions& options, double distance) {
  return distance >= options.least_distance && distance <= options.greatest_distance;
}

std::vector<GridNode> places_around(const TourSite& site, const Footprint& target, const ShortestWays& ways) {
  std::vector<GridNode> nodes;
  for (GridNode node = 0; node < site.grid.size(); ++node)
    if (ways.reach(node) && in_range(site.options, gap(target, site.grid.place(node)))) nodes.push_back(node);
  return nodes;
}

class Drawer {
 public:
  Drawer(const TourSite& site, const Object& target, const ShortestWays& ways)
      : site_(site),
        target_(target),
        ways_(ways),
        footprint_(footprint(target)),
        corners_(box_corners(target)),
        random_(Random(site.options.seed).fork(target.id)) {}

  DrawnViewpoints draw() {
    DrawnViewpoints drawn;
    auto nodes = places_around(site_, footprint_, ways_);
    drawn.any_place = !nodes.empty();
    random_.shuffle(nodes);
    for (const GridNode node : nodes) {
      if (drawn.points.size() >= static_cast<std::size_t>(site_.options.samples)) break;
      if (const auto point = viewpoint_near(node)) drawn.points.push_back(*point);
    }
    std::stable_sort(drawn.points.begin(), drawn.points.end(),
                     [](const Viewpoint& a, const Viewpoint& b) { return a.most_score > b.most_score; });
    return drawn;
  }

 private:
  // Within the node's cell, if one may step and stand there.
  Vec2 place_near(GridNode node) {
    const Vec2 middle = site_.grid.place(node);
    const double x = random_.uniform(-0.5, 0.5), y = random_.uniform(-0.5, 0.5);
    const Vec2 place(rounded(middle.x() + site_.grid.pitch() * x), rounded(middle.y() + site_.grid.pitch() * y));
    return in_range(site_.options, gap(footprint_, place)) && site_.space.is_free({middle, place}) ? place : middle;
  }

  std::optional<Viewpoint> viewpoint_near(GridNode node) {
    const Vec2 place = place_near(node);
    const Vec3 eye(place.x(), place.y(), site_.options.eye_height);
    const Aim middle = aim_at(corners_, eye, footprint_.center());
    const double stray = site_.options.stray;
    const double yaw = random_.uniform(-stray, stray), pitch = random_.uniform(-stray, stray);
    if (auto point = viewpoint(node, eye, {middle.yaw + yaw, middle.pitch + pitch})) return point;
    return viewpoint(node, eye, middle);
  }

  std::optional<Viewpoint> viewpoint(GridNode node, const Vec3& eye, const Aim& aim) const {
    const double steepest = site_.options.steepest_pitch;
    const CameraPose pose{eye, rounded_angle(aim.yaw), rounded_angle(std::clamp(aim.pitch, -steepest, steepest))};
    const auto camera = tour_camera(pose, site_.intrinsics());
    const auto area = camera ? area_in_picture(*camera, corners_) : std::nullopt;
    if (!area) return std::nullopt;
    const double fixed = front_weight * frontality(eye) - way_weight * ways_.metres[node];
    const double most_pixels = (1.0 - site_.options.least_hidden) * *area;
    return Viewpoint{node, pose, fixed, view_score(site_.options, most_pixels, fixed)};
  }

  double frontality(const Vec3& eye) const {
    if (!target_.traits.front) return 0.0;
    return front_direction(target_.yaw).dot((eye.head<2>() - footprint_.center()).normalized());
  }

  const TourSite& site_;
  const Object& target_;
  const ShortestWays& ways_;
  Footprint footprint_;
  std::vector<Vec3> corners_;
  Random random_;
};

}  // namespace

double view_score(const TourOptions& options, double pixels, double fixed_score) {
  return std::sqrt(pixels / (static_cast<double>(options.width) * options.height)) + fixed_score;
}

double pixels_that_score(const TourOptions& options, double score, double fixed_score) {
  const double root = std::max(0.0, score - fixed_score);
  return root * root * options.width * options.height;
}

DrawnViewpoints draw_viewpoints(const TourSite& site, const Object& target, const ShortestWays& ways) {
  return Drawer(site, target, ways).draw();
}

}  // namespace roomgen::lab::detail
