#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace roomgen {

/// The phrases that a pattern stands for: "(could|can) you (please|)" gives "could you please", "could you",
/// "can you please", "can you". Brackets do not nest.
std::vector<std::string> phrases_of(std::string_view pattern);

}  // namespace roomgen
