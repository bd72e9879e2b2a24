#pragma once

#include "clause_parts.h"

namespace roomgen {

/// Words behind a noun that tell which of the things is meant: "nearest the door", "on the coffee table", "that isn't
/// at the bar", "we just put in", "on the left". Nothing where such words do not follow.
MayRead<Ids> told_by_tail(const EditText& text, const NamedThing& thing);

}  // namespace roomgen
