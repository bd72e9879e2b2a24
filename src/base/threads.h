#pragma once

#include <cstddef>
#include <functional>

namespace roomgen {

/// Does the same work on so many threads at once, of which this is one, and returns when all have ended; on fewer where the
/// system has no more. What one of them throws is thrown here, the first of several.
void on_threads(std::size_t count, const std::function<void(std::size_t thread)>& work);

}  // namespace roomgen
