#pragma once

#include "brief.h"

namespace roomgen::design {

/// Cuts names and looks that are longer than any thing's, so that a plan can be read again whatever the prompt says: sentences
/// without a blank or a verb are taken for one name.
void bound_names(Brief& brief);

}  // namespace roomgen::design
