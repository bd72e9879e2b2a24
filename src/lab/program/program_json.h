#pragma once

#include "roomgen/base/json.h"
#include "roomgen/lab/program.h"

namespace roomgen::lab {

/// As a program's file has them: equal texts, equal sets and terms.
Json to_json(const ProgramSet& set);
Json to_json(const ProgramTerm& term);

}  // namespace roomgen::lab
