#pragma once

#include <string>
#include <vector>

#include "library/style_words.h"

namespace roomgen::plan {

/// The look of a room whose prompt names colours and stuffs without the things that have them: colours are worn by what
/// is soft or small, woods by furniture, metals by lamps (data/styles.json says by which kinds), brick, plaster and
/// stone by a wall.
StyleMeaning style_of_palette(const std::vector<std::string>& palette);

}  // namespace roomgen::plan
