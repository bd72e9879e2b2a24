#pragma once

#include <string>
#include <vector>

#include "roomgen/geometry/model.h"

namespace roomgen::assets {

/// The English name of an sRGB colour (components 0 to 255): white, grey, black, brown, beige, red,
/// orange, yellow, green, blue, purple, pink.
std::string color_name(float red, float green, float blue);

/// The names of the colours that cover a fifth of the surface or more, largest area first.
std::vector<std::string> main_colors(const Model& model);

}  // namespace roomgen::assets
