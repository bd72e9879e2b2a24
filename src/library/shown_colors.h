#pragma once

#include <array>
#include <string>
#include <vector>

#include "roomgen/geometry/model.h"

namespace roomgen {

/// The English name of an sRGB colour (components 0 to 255): white, grey, black, brown, beige, red,
/// orange, yellow, green, blue, purple, pink.
std::string color_name(float red, float green, float blue);

/// Square metres of all faces, seen or not.
double surface_area(const Mesh& mesh);

/// A colour that a model shows to who walks around it.
struct ShownColor {
  std::string name;             ///< as color_name() has it
  double share = 0.0;           ///< of what is seen from above, the front and the sides
  std::array<float, 3> mean{};  ///< sRGB, 0 to 255
};
/// All of them, largest area first. Textures are looked at in pieces, so that stripes are two colours and
/// the grain of wood is one.
std::vector<ShownColor> shown_colors(const Model& model);

/// How light a colour looks, from 0 (black) to 1 (white): luma of ITU-R BT.601.
double lightness(const std::array<float, 3>& srgb);

/// The names of the colours that cover a fifth of what is seen or more, largest area first.
std::vector<std::string> main_colors(const Model& model);

}  // namespace roomgen
