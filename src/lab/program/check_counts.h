#pragma once

#include "findings.h"
#include "set_kinds.h"

namespace roomgen::lab {

/// Bounds on counts that nothing can meet: contradictions, more things than there may be, more footprint than
/// floor; and counts without an upper bound. The program's names have been checked.
void check_counts(const ConstraintProgram& program, SetKinds& kinds, ProgramFindings& findings);

}  // namespace roomgen::lab
