#pragma once

#include <set>
#include <string>
#include <vector>

#include "arrange.h"

namespace roomgen::composition {

inline constexpr std::size_t most_alternatives = 48;

/// The ways in which a group may stand, those that lose least first: as asked, mirrored, with other
/// values of its parameters ("try"), without what may be left out, and smaller down to its least
/// size. Values of `fixed` parameters stay: somebody asked for them. Fails as arrange() does where
/// the first way does.
Result<std::vector<Arranged>> alternatives(const Composition& composition, const Values& values,
                                           const std::set<std::string>& fixed,
                                           const Making& making);

}  // namespace roomgen::composition
