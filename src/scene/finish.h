#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "finish_words.h"
#include "roomgen/geometry/model.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// What a floor or a wall is covered with. A textured one maps `extent` metres to one image.
struct Finish {
  Material material;
  double extent = 1.0;
  std::array<float, 4> plain = {1, 1, 1, 1};  ///< the material's colour without its pattern
};

/// From words ("dark walnut planks", "black and white checkerboard", "sage green") and, where they leave
/// it open, from what such a part of such a room usually has (a bathroom is tiled, a bedroom has boards).
/// Words that nobody knows change nothing; data/materials.json has the others.
Finish make_finish(std::string_view description, RoomPart part, std::string_view room_type,
                   const FinishWords& words = finish_words());

/// make_finish() of the room's own words.
Finish floor_finish(const Room& room);
Finish ceiling_finish(const Room& room);

/// What one wall is covered with: all of it, or what is above `height` and what is below.
struct WallCoat {
  Finish upper;
  std::optional<Finish> lower;
  double height = 0.0;  ///< metres, of the lower part
};
/// As cover_of() says.
WallCoat wall_coat(const Room& room, std::size_t wall);

/// Does a word say a colour, a stuff or a pattern? Colours are also "#rrggbb" and those of CSS.
bool says_finish(std::string_view description, const FinishWords& words = finish_words());

/// A Material colour (linear, opaque unless `alpha` says otherwise) from sRGB, 0 to 255.
std::array<float, 4> material_color(const Eigen::Vector3f& srgb, float alpha = 1.0f);

}  // namespace roomgen
