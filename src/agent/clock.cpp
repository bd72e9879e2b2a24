#include "clock.h"

#include <algorithm>
#include <thread>

namespace roomgen {

namespace {

using Seconds = HttpClock::Seconds;

Seconds machine_now() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

bool machine_pause(Seconds duration, const CancelToken& cancel) {
  constexpr Seconds look_up{0.02};
  const Seconds end = machine_now() + duration;
  while (!cancel.cancelled()) {
    const Seconds left = end - machine_now();
    if (left <= Seconds::zero()) return true;
    std::this_thread::sleep_for(std::min(left, look_up));
  }
  return false;
}

}  // namespace

HttpClock completed(HttpClock clock) {
  if (!clock.now) clock.now = machine_now;
  if (!clock.pause) clock.pause = machine_pause;
  return clock;
}

}  // namespace roomgen
