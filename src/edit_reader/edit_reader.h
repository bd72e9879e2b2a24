#pragma once

#include "edit_text.h"
#include "roomgen/edit_reader/understand.h"
#include "roomgen/edit/session.h"

namespace roomgen {

/// What a text asks for, clause by clause; what each speaks of is known to those behind it.
Result<Understanding> read_clauses(EditText text);

}  // namespace roomgen
