#pragma once

#include <string>
#include <vector>

#include "base/random.h"
#include "kinds.h"
#include "roomgen/create/maker.h"

namespace roomgen::create {

/// How recipes name the parameters of their size.
inline constexpr const char* axes[] = {"width", "depth", "height"};

/// Metres: what a created object may measure.
inline constexpr double least_side = 0.01, greatest_side = 5.0;

struct Sizing {
  Vec3 size;  ///< width, depth, height, metres
  std::vector<std::string> notes;
};

/// The kind's usual size, a little varied, larger for more doors or people, then as the scale words
/// say within what the kind's range allows. Lengths that were said count as they are. `values` are
/// the parameters chosen so far, whose numbers the kind's growth looks at.
Sizing choose_size(const Description& description, const ShapeKind& kind,
                   const std::vector<shape::Parameter>& parameters, const shape::Values& values,
                   Random random);

}  // namespace roomgen::create
