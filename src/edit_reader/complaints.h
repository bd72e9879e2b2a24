#pragma once

#include "clause.h"

namespace roomgen {

/// What is wrong with a thing, which says how it shall be: "the sofa is too close to the TV", "the table is too small
/// for us", "the lamp is in the way of the door". Nothing where nobody complains.
std::optional<ReadClause> complaint_at(const EditText& text, std::size_t at);

}  // namespace roomgen
