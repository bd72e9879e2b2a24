#pragma once

#include <chrono>
#include <future>

#include "roomgen/base/cancel.h"

namespace roomgen {

/// Waits for work on another thread until it is done, or a little longer than until it is cancelled: what
/// notices that soon may still end by itself. Whether it is done.
inline bool is_done(const std::future<void>& work, const CancelToken& cancel) {
  constexpr std::chrono::milliseconds glance(5), grace(30);
  while (!cancel.cancelled())
    if (work.wait_for(glance) == std::future_status::ready) return true;
  return work.wait_for(grace) == std::future_status::ready;
}

}  // namespace roomgen
