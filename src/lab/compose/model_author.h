#pragma once

#include <string>

#include "roomgen/base/json.h"
#include "roomgen/lab/compose.h"

namespace roomgen::lab::compose {

/// What a model answered: a program, and what it says of it.
struct ProgramAnswer {
  ConstraintProgram program;
  std::string reasoning;
  std::vector<std::string> repairs;  ///< what was not as it should be
};

/// Reads {"program": {...}} or, of a program that it knows, {"patch": [...]} (RFC 6902). Errors are for the model: what
/// does not parse, what the checker finds.
Result<ProgramAnswer> read_program_answer(const std::string& text, const Json& before, const KindTable& kinds);

}  // namespace roomgen::lab::compose
