#pragma once

#include <string>

#include "roomgen/base/json.h"
#include "roomgen/lab/program.h"

namespace roomgen::lab {

/// A set in the middle of a sentence: in brackets where that would not end by itself.
std::string operand_text(const ProgramSet& set);

/// As a program's file has them: equal texts, equal sets and terms.
Json to_json(const ProgramSet& set);
Json to_json(const ProgramTerm& term);

}  // namespace roomgen::lab
