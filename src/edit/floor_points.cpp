#include <algorithm>

#include "placing.h"
#include "solve/trials.h"

namespace roomgen {

namespace {

constexpr double finest_pitch = 0.05;  // metres

// Of the room, or of what of it is near enough.
Bounds2 part_to_look_at(const Layout& layout, const Aim& aim) {
  Bounds2 box = bounds(layout.room().polygon);
  if (!aim.near_to) return box;
  box.low = box.low.cwiseMax(Vec2(aim.near_to->position.array() - aim.most_off));
  box.high = box.high.cwiseMin(Vec2(aim.near_to->position.array() + aim.most_off));
  return box;
}

std::vector<double> yaws_to_try(const Layout& layout, const Object& root, const Aim& aim) {
  if (aim.near_to && !aim.turns_freely) return {aim.near_to->yaw};
  const auto walls = layout.wall_yaws();
  if (root.traits.round && !root.traits.front) return {walls.front()};
  return thinned({walls.begin(), walls.end()});
}

}  // namespace

std::vector<Pose> floor_points(const Layout& layout, const Object& root, const Aim& aim, const Vec2& middle) {
  const Bounds2 box = part_to_look_at(layout, aim);
  const auto yaws = yaws_to_try(layout, root, aim);
  const double pitch = aim.near_to ? finest_pitch : pitch_within_limit(finest_pitch, layout.room().polygon, yaws.size());
  // What shall stay where it is finds its own place among the points.
  const Vec2 origin = aim.near_to ? aim.near_to->position : box.low;
  const Vec2 first = ((box.low - origin) / pitch).array().ceil(), last = ((box.high - origin) / pitch).array().floor();
  const auto candidate = layout.candidate(root);
  const FootprintAt footprint_at(root);
  std::vector<Pose> poses;
  for (double i = first.x(); i <= last.x(); ++i)
    for (double j = first.y(); j <= last.y(); ++j)
      for (const double yaw : yaws) {
        const Pose pose{origin + pitch * Vec2(i, j), 0.0, yaw};
        if (layout.fits(candidate, footprint_at(pose), pose.bottom)) poses.push_back(pose);
      }
  const auto off = [&](const Pose& pose) { return (pose.position - middle).squaredNorm(); };
  std::stable_sort(poses.begin(), poses.end(), [&](const Pose& a, const Pose& b) { return off(a) < off(b); });
  return poses;
}

}  // namespace roomgen
