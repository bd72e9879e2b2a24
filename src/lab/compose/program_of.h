#pragma once

#include <string>
#include <vector>

#include "inventory.h"
#include "roomgen/lab/compose.h"
#include "solve/arrangement.h"

namespace roomgen::lab::compose {

/// The inventory as a program: a set and a bound for each stand, for each of what carries or gathers things by itself
/// where the numbers divide; how things of the kind stand to each other as scores; what is asked of the whole as
/// constraints. Notes say which wishes programs have no words for.
ConstraintProgram program_of(const std::vector<Stand>& stands, const Complexity& asked, const Plan& plan,
                             const KindTable& kinds, const Arrangements& arrangements, std::vector<std::string>& notes);

}  // namespace roomgen::lab::compose
