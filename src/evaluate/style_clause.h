#pragma once

#include "evaluate/finding.h"
#include "evaluate/ledger.h"

namespace roomgen {

/// The attributes of requirements of Kind::room about how a room looks as a whole; their category is the style, or the
/// colours and stuffs.
inline constexpr std::string_view style_of_room = "style", palette_of_room = "palette";

/// Is at least half of the furniture of a style (docs/finishes.md)? What stands on other things does not count, nor what
/// nothing is known of.
Finding judge_style(const Requirement& requirement, const Scene& scene, const AttributeJudge& has_attribute);

/// Is each word of a palette that of the floor, the walls, the ceiling or of some thing?
Finding judge_palette(const Requirement& requirement, const Scene& scene, const AttributeJudge& has_attribute);

}  // namespace roomgen
