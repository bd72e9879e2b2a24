#pragma once

#include "roomgen/base/result.h"
#include "view/marks.h"

namespace roomgen::detail {

/// Draws lines and texts over a picture. Error::Kind::unavailable without OpenCV.
Status draw_overlay(Image& image, const Drawing& drawing);

}  // namespace roomgen::detail
