#pragma once

#include <string>

#include "brief.h"

namespace roomgen::brief {

/// Cuts what is longer or more than any thing's, so that a plan can be read again whatever the prompt says: sentences
/// without a blank or a verb are taken for one name, and numbers are multiplied.
void bound_mentions(Brief& brief);

/// The last words of what is longer than a name may be.
std::string bounded_name(std::string text);

}  // namespace roomgen::brief
