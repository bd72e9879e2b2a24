#pragma once

#include <string>

#include "roomgen/lab/program.h"

namespace roomgen::lab {

/// A set in the middle of a sentence: in brackets where that would not end by itself.
std::string operand_text(const ProgramSet& set);

}  // namespace roomgen::lab
