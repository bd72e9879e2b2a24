#pragma once

#include <vector>

#include "search.h"

namespace roomgen::create::detail {

/// The height that most of the parts which should reach the floor do reach; of the lowest point
/// when none should.
double floor_level(const Assembly& assembly, const std::vector<Link>& links);
/// All components up or down, so that this height becomes 0.
void shift_level(Assembly& assembly, double height);
/// Lifts or shortens what is below the floor.
void try_lifting(Trials& trials);

}  // namespace roomgen::create::detail
