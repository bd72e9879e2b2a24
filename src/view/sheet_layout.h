#pragma once

#include <vector>

#include "marks.h"
#include "roomgen/view/view.h"

namespace roomgen {

/// Where everything of a contact sheet goes: the things as objects of one scene, scaled and set
/// side by side across the camera's line of sight, and what is written over them.
struct SheetLayout {
  Camera camera;
  std::vector<Object> objects;  ///< of those with an extent, row by row
  Drawing drawing;
};

/// Fails with invalid_input for a sheet without rows, or one that is no sensible picture.
Result<SheetLayout> lay_out(const ContactSheet& sheet);

}  // namespace roomgen
