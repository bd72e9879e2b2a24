#pragma once

#include <string>
#include <vector>

#include "edit_vocabulary.h"

namespace roomgen {

/// What a description says of another thing's size: "bigger", "much wider, in oak".
struct Comparison {
  std::vector<Growth> ways;  ///< none: nothing
  std::string description;   ///< without these words
  std::string words;         ///< these words
};
Comparison comparison_in(const std::string& description);

/// About so large is what is meant, for a thing of this size. A bigger sofa is as high as others are: `keeps_height`.
Vec3 compared_size(const Comparison& comparison, const Vec3& size, bool keeps_height);
/// Is the one size so in comparison with the other? "Bigger" is what has a larger face and takes more space.
bool holds(const Comparison& comparison, const Vec3& is, const Vec3& was);

}  // namespace roomgen
