#pragma once

#include <limits>
#include <vector>

#include "roomgen/scene/scene.h"
#include "roomgen/lab/frames.h"

namespace roomgen::lab::detail {

/// When a tour's frames show an object. Frames by their place in the list.
struct Appearance {
  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
  std::size_t first_faint = never;  ///< anybody might notice it from here on
  std::size_t first_seen = never;   ///< everybody does
  std::size_t best = 0;             ///< shows most of it
  bool clear = false;               ///< well enough to ask about it

  bool is_faint() const { return first_faint != never; }
  bool is_seen() const { return first_seen != never; }
  /// Whoever is looking for either sees this one before the other.
  bool surely_before(const Appearance& other) const { return is_seen() && first_seen < other.first_faint; }
};

/// Shares of the picture (data/questions/forms.json).
struct SightLimits {
  double clear = 0.0, seen = 0.0, faint = 0.0;
};

/// Of the scene's objects, in their order.
std::vector<Appearance> appearances(const Scene& scene, const std::vector<FrameRecord>& frames,
                                    const SightLimits& limits);

}  // namespace roomgen::lab::detail
