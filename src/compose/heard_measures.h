#pragma once

#include <string_view>
#include <vector>

#include "roomgen/scene/requirement.h"

namespace roomgen::compose {

/// What was heard of a prompt, with the words that say how much the room shall hold ("seating for 12", "half of the
/// floor") heard as counts where nobody else understood them. Whether they are reached says the error report.
std::vector<Heard> with_measures_heard(std::vector<Heard> heard, std::string_view prompt);

}  // namespace roomgen::compose
