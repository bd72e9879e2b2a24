#pragma once

#include "clause.h"

namespace roomgen {

/// "except the bed", behind a clause that is about several things: these are left as they are.
void leave_out_exceptions(const EditText& text, Clause& clause);

}  // namespace roomgen
