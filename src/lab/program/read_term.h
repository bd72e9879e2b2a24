#pragma once

#include "read_set.h"

namespace roomgen::lab {

ProgramTerm read_term(const JsonReader& json, ReadingBudget& budget, int depth = 0);

}  // namespace roomgen::lab
