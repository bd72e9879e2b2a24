#pragma once

#include "findings.h"
#include "set_kinds.h"

namespace roomgen::lab {

/// What is said of every member of a set that can have none, faces that members do not have, and scores of which
/// nobody knows whether they are wanted small or large. The program's names have been checked.
void check_members(const ConstraintProgram& program, SetKinds& kinds, ProgramFindings& findings);

/// Bounds on counts that nothing can meet: contradictions, more things than there may be, more footprint than
/// floor; and counts without an upper bound. The program's names have been checked.
void check_counts(const ConstraintProgram& program, SetKinds& kinds, ProgramFindings& findings);

/// Finds programs of which one look at a room may take too many steps: what all, mean and sum run over multiplies
/// where they are nested, and what pairs of things are asked for goes by the square. Sizes are those of the fullest
/// room that the program's bounds let come about. The program's names have been checked.
void check_work(const ConstraintProgram& program, SetKinds& kinds, ProgramFindings& findings);

}  // namespace roomgen::lab
