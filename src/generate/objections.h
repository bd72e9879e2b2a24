#pragma once

#include <string>
#include <vector>

#include "roomgen/design/designer.h"
#include "workplace.h"

namespace roomgen {

/// A yaw this far from the suggested one still follows it.
inline constexpr double facing_tolerance = pi / 12;

/// What of an answer is not so where its object stands: words that were not understood, constraints that do not
/// hold, a place more than 1 m away, a facing overridden. Nothing of habits, which nobody said.
std::vector<std::string> objections_to(const Workplace& place, const PlaceAdvice& answer,
                                       const Object& standing);

/// Could another answer mend any of that? Not where the thing stands just where it was said and
/// that place itself breaks the constraints.
bool is_worth_asking(const Workplace& place, const PlaceAdvice& answer, const Object& standing);

}  // namespace roomgen
