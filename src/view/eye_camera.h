#pragma once

#include "camera.h"

namespace roomgen::detail {

/// Where a visitor stands to see most of the room, and which way they look (a unit vector).
struct Standpoint {
  Vec3 eye = Vec3::Zero();
  Vec2 towards = Vec2::UnitY();
};

Standpoint choose_standpoint(const Scene& scene);

/// The camera of the eye-level view; its picture's longer side is `pixels` long.
Camera eye_camera(const Scene& scene, int pixels);

}  // namespace roomgen::detail
