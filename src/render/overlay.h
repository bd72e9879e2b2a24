#pragma once

#include "roomgen/view/marks.h"

namespace roomgen::detail {

/// Draws lines and texts over a picture.
void draw_overlay(Image& image, const Drawing& drawing);

}  // namespace roomgen::detail
