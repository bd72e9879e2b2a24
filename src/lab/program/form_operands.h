#pragma once

#include <cstddef>
#include <string>

#include "roomgen/lab/program.h"

namespace roomgen::lab {

/// How many operands a form takes, options included.
struct OperandCount {
  std::size_t least = 0;
  std::size_t most = 0;
};
OperandCount operand_count(const ProgramOpForm& form);

/// What stands in the form's place `index`: one of S N B L v s a.
char operand_at(const ProgramOpForm& form, std::size_t index);

/// How it is written: ["dist", SET, SET, FACE?].
std::string usage(const ProgramOpForm& form);

inline bool is_weighted(ProgramOp op) { return op == ProgramOp::minimize || op == ProgramOp::maximize; }

}  // namespace roomgen::lab
