#pragma once

#include <optional>
#include <string_view>

#include "roomgen/geometry/vec.h"
#include "language/measure.h"

namespace roomgen {

/// A size in numbers: "160 cm wide", "2x3 m", "at most 2 m tall", "70 cm diameter", "85 inch".
struct StatedSize {
  enum class Bound { about, at_most, at_least };
  language::Measure measure;
  Bound bound = Bound::about;
};

/// None if the text says no length.
std::optional<StatedSize> read_stated_size(std::string_view text);

/// Does a box of this width, depth and height have it, to a tenth? Lengths are of the longer side of the
/// footprint, a length that is said of no side may be that of any, or the diagonal of the front (screens);
/// two sides are those of the footprint, or of the front of what is higher than deep.
bool has_size(const StatedSize& stated, const Vec3& size);

}  // namespace roomgen
