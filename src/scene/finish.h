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

/// What a description says of a finish, no more.
struct SaidFinish {
  const Surface* surface = nullptr;
  bool surface_is_of_stuff = false;  ///< "oak" says boards, too
  std::vector<Tone> names;           ///< of all words of colour
  std::vector<Tone> tones;           ///< "cobalt and yellow" are two, "blue grey" is one
  std::size_t grounds = 0;           ///< of the tones those before "with"
  std::vector<std::string>
      unknown;  ///< words that change nothing of what is drawn, though they should
};
SaidFinish said_finish(std::string_view description, const FinishWords& words = finish_words());

/// What a description becomes on a part of a room.
struct DrawnFinish {
  Surface surface;
  Tone tone, second;

  /// As viewers see it: both where the pattern has two tones of one rank.
  std::vector<Tone> tones() const;
};
DrawnFinish drawn_finish(std::string_view description, RoomPart part, std::string_view room_type,
                         const FinishWords& words = finish_words());

/// How far apart two tones look: the distance in CIELAB (CIE 1976; D65).
double tone_distance(const Tone& a, const Tone& b);

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
