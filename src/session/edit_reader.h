#pragma once

#include "read_so_far.h"
#include "roomgen/session/session.h"

namespace roomgen {

/// What the words of the text ask for behind what was read before.
Result<ReadSoFar> read_on(ReadSoFar so_far);

/// What a text asks for, clause by clause; what each speaks of is known to those behind it.
Result<Understanding> read_clauses(EditText text);

}  // namespace roomgen
