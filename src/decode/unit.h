#pragma once

#include <algorithm>
#include <cmath>

namespace roomgen::decode {

/// A share of a surface's look as a file gives it, within [0, 1]; the middle for what is no number.
inline float unit(float value) {
  return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 0.5f;
}

}  // namespace roomgen::decode
