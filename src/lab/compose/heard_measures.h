#pragma once

#include <string_view>
#include <vector>

#include "roomgen/lab/compose.h"

namespace roomgen::lab::compose {

/// Puts into the ledger of a scene how much a prompt (or an option) says that the room shall hold ("seating for 12",
/// "half of the floor"): a requirement for each measure, judged by the error report. The words that say so are heard as
/// counts, and what the reader of rooms made of them ("occupancy" as a character of the room) goes.
void hear_measures(Scene& scene, std::string_view prompt, const std::vector<MeasureVerdict>& measures);

}  // namespace roomgen::lab::compose
