#pragma once

#include "findings.h"
#include "set_kinds.h"

namespace roomgen::lab {

/// Finds programs of which one look at a room may take too many steps: what all, mean and sum run over multiplies
/// where they are nested, and what pairs of things are asked for goes by the square. Sizes are those of the fullest
/// room that the program's bounds let come about. The program's names have been checked.
void check_work(const ConstraintProgram& program, SetKinds& kinds, ProgramFindings& findings);

}  // namespace roomgen::lab
