#pragma once

#include <vector>

#include "search.h"

namespace roomgen::create::detail {

/// Links that are to be closed in a state: the open ones, lowest first, and one for each piece that
/// is joined to nothing, chosen by the map or by nearness.
std::vector<Link> links_to_close(const State& state, const std::vector<Link>& links);

/// Tries to close one of the links by moving or stretching either side, alone, with its copies'
/// links or with all that hangs on it.
void try_closing(Trials& trials, const std::vector<Link>& to_close, std::size_t which);

}  // namespace roomgen::create::detail
