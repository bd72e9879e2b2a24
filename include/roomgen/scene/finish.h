#pragma once

#include <Eigen/Core>
#include <array>

#include "roomgen/geometry/model.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// What a floor or a wall is covered with. A textured one maps `extent` metres to one image.
struct Finish {
  Material material;
  double extent = 1.0;
};

/// From the words of RoomMaterials ("dark walnut planks", "white tiles", "sage green"); what they
/// leave open follows from the room's type (a bathroom is tiled, a bedroom has boards).
Finish floor_finish(const Room& room);
Finish wall_finish(const Room& room);

/// A Material colour (linear, opaque unless `alpha` says otherwise) from sRGB, 0 to 255.
std::array<float, 4> material_color(const Eigen::Vector3f& srgb, float alpha = 1.0f);

}  // namespace roomgen
