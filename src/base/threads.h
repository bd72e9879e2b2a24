#pragma once

#include <cstddef>
#include <functional>

namespace roomgen {

/// Does the same work on so many threads at once, of which this is one, and returns when all have ended; on fewer where the
/// system has no more. What one of them throws is thrown here, the first of several.
void on_threads(std::size_t count, const std::function<void(std::size_t thread)>& work);

/// Does the work for 0, 1, ... `tasks` - 1, on so many threads: who is free takes the next one.
void share_out(std::size_t tasks, std::size_t threads,
               const std::function<void(std::size_t thread, std::size_t task)>& work);

}  // namespace roomgen
