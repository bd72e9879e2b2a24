#pragma once

#include <vector>

#include "roomgen/scene/scene.h"

namespace roomgen::detail {

/// A small light in the room, or a window that the sky shines through.
struct RoomLight {
  Vec3 place = Vec3::Zero();
  Eigen::Vector3f color = Eigen::Vector3f::Zero();  ///< of what faces it 1 m away
  Vec3 axis = -Vec3::UnitZ();
  bool is_window = false;  ///< shines as a plane does
  double cosine = -2.0;    ///< of a lamp: of the half angle of its cone about the axis
};

/// What the shader takes at most.
inline constexpr std::size_t most_room_lights = 12;

/// The windows, widest first, then the lamps, strongest first.
std::vector<RoomLight> room_lights(const Scene& scene);

}  // namespace roomgen::detail
