#pragma once

#include "inventory.h"
#include "roomgen/lab/compose.h"
#include "solve/arrangement.h"

namespace roomgen::lab::compose {

/// Puts into the ledger of a scene how much a prompt (or an option) says that the room shall hold ("seating for 12",
/// "half of the floor"): a requirement for each measure, judged by the error report. The words that say so are heard as
/// counts, and what the reader of rooms made of them ("occupancy" as a character of the room) goes.
void hear_measures(Scene& scene, std::string_view prompt, const std::vector<MeasureVerdict>& measures);

/// The inventory as a program: a set and a bound for each stand, for each of what carries or gathers things by itself
/// where the numbers divide; how things of the kind stand to each other as scores; what is asked of the whole as
/// constraints. Notes say which wishes programs have no words for.
ConstraintProgram program_of(const std::vector<Stand>& stands, const Complexity& asked, const Plan& plan,
                             const KindTable& kinds, const Arrangements& arrangements, std::vector<std::string>& notes);

}  // namespace roomgen::lab::compose
