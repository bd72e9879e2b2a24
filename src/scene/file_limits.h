#pragma once

namespace roomgen {

/// What a file may say, so that sums and squares of it stay exact enough: metres from the origin, and
/// seeds that a double holds exactly (JSON knows no other numbers).
inline constexpr double max_coordinate = 1000.0;
inline constexpr long long max_seed = 9007199254740991;

}  // namespace roomgen
