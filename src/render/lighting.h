#pragma once

#include "view/camera.h"

namespace roomgen::detail {

/// Unit vector towards the sun of a room that is looked at from above, where there is no ceiling:
/// behind the viewer's left shoulder, so that the faces that show are lit and shadows fall to the
/// lower right.
Vec3 sun_direction(const Camera& camera, View::Kind kind);

/// A box of sunlight around the scene.
struct Sun {
  Vec3 direction;  ///< towards it
  Eigen::Matrix4d clip_from_room;
  double extent = 1.0;  ///< metres across the shadow map
  double depth = 1.0;   ///< metres along the direction
};
Sun make_sun(const Vec3& direction, const std::vector<Vec3>& points);

/// Distances before the eye between which the camera draws.
struct Planes {
  double near, far;
};
Planes planes(const Camera& camera);

/// Clip coordinates with row 0 of the picture at the bottom of the framebuffer, where OpenGL
/// starts.
Eigen::Matrix4d clip_from_room(const Camera& camera);

}  // namespace roomgen::detail
