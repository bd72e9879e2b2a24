#pragma once

#include <functional>

#include "roomgen/geometry/model.h"

namespace roomgen {

/// A small piece of a model's surface that can be seen.
struct VisiblePixel {
  std::size_t part = 0;    ///< index into Model::parts
  Vec2 uv = Vec2::Zero();  ///< zero where the part has none
  double area = 0.0;       ///< square metres across the line of sight
};

/// Calls `visit` for what is seen of a model from above, from the front and from both sides, in pixels of
/// equal size, 72 along the longest side of its box. What is not `opaque` there is looked
/// through.
void each_visible_pixel(const Model& model, const std::function<bool(const VisiblePixel&)>& opaque,
                        const std::function<void(const VisiblePixel&)>& visit);

}  // namespace roomgen
