#pragma once

#include "findings.h"
#include "set_kinds.h"

namespace roomgen::lab {

/// What is said of every member of a set that can have none, faces that members do not have, and scores of which
/// nobody knows whether they are wanted small or large. The program's names have been checked.
void check_members(const ConstraintProgram& program, SetKinds& kinds, ProgramFindings& findings);

}  // namespace roomgen::lab
