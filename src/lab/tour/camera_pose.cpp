#include "camera_pose.h"

#include <cmath>

namespace roomgen::lab {

Vec3 detail::look_direction(double yaw, double pitch) {
  const Vec2 ahead = std::cos(pitch) * front_direction(yaw);
  return {ahead.x(), ahead.y(), std::sin(pitch)};
}

Result<Camera> tour_camera(const CameraPose& pose, const TourIntrinsics& intrinsics) {
  const Vec3 target = pose.eye + detail::look_direction(pose.yaw, pose.pitch);
  return pinhole_camera(pose.eye, target, intrinsics.field_of_view, intrinsics.width, intrinsics.height);
}

}  // namespace roomgen::lab
