#pragma once

#include "roomgen/base/result.h"
#include "solve/layout.h"

namespace roomgen {

/// May the object stand where it is, as docs/constraints.md has it ("Valid")? not_found with what is wrong
/// or in the way.
Status fits_as_it_is(Layout& layout, const Object& object, bool even_useless = false);

}  // namespace roomgen
