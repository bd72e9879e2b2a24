#include "motion.h"

#include <algorithm>
#include <cmath>

namespace roomgen::lab::detail {

namespace {

constexpr double nothing = 1e-9;  // seconds of a movement that is none

}  // namespace

Motion::Motion(const TourOptions& options, const CameraPose& start)
    : speed_(options.speed),
      turn_rate_(options.turn_rate),
      pause_(options.pause),
      rate_(options.keyframes_per_second),
      keyframes_{{0.0, start}} {}

// In equal parts, so that what lies between two keyframes is a straight line of the movement.
template <typename PoseAt>
void Motion::move(double seconds, const PoseAt& pose_at) {
  if (seconds < nothing) return;
  const TourKeyframe start = last();
  const int parts = std::max(1, static_cast<int>(std::ceil(seconds * rate_ - nothing)));
  for (int k = 1; k <= parts; ++k) {
    const double part = static_cast<double>(k) / parts;
    keyframes_.push_back({start.time + part * seconds, pose_at(start.pose, part)});
  }
}

void Motion::walk(const std::vector<Vec2>& way) {
  for (std::size_t k = 1; k < way.size(); ++k) {
    const Vec2 ahead = way[k] - last().pose.eye.head<2>();
    if (ahead.norm() < nothing) continue;
    turn_to(yaw_facing(ahead), 0.0);
    walk_to(way[k]);
  }
}

void Motion::walk_to(const Vec2& place) {
  const Vec3 there(place.x(), place.y(), last().pose.eye.z());
  const double metres = (there - last().pose.eye).norm();
  move(metres / speed_, [&](CameraPose pose, double part) {
    pose.eye = part == 1.0 ? there : Vec3(pose.eye + part * (there - pose.eye));
    return pose;
  });
}

// The shorter way round.
void Motion::turn_to(double yaw, double pitch) {
  const double around = wrap_angle(yaw - last().pose.yaw), up = pitch - last().pose.pitch;
  move(std::max(std::abs(around), std::abs(up)) / turn_rate_, [&](CameraPose pose, double part) {
    pose.yaw = part == 1.0 ? wrap_angle(yaw) : wrap_angle(pose.yaw + part * around);
    pose.pitch = part == 1.0 ? pitch : pose.pitch + part * up;
    return pose;
  });
}

void Motion::pause() {
  move(pause_, [](const CameraPose& pose, double) { return pose; });
}

}  // namespace roomgen::lab::detail
