#pragma once

#include "workplace.h"

namespace roomgen {

/// Up to `count` places for an object as things stand: the one that try_all() would take first, then the
/// best of the rest.
Result<Proposal> propose_places(Work& work, const PlannedObject& planned, std::size_t count);

/// Puts the object of a proposal into the room. not_found if the place is taken by now.
Status take_place(Work& work, const Proposal& proposal, std::size_t choice, Step& step);

}  // namespace roomgen
