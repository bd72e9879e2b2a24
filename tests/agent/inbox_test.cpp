// What counts as silence while an answer arrives, in a time that only the test moves.
#include "inbox.h"

#include "catch.h"

using namespace roomgen;
using Seconds = HttpClock::Seconds;

namespace {

HttpLimits limits_of(double idle, double least_speed) {
  HttpLimits limits;
  limits.idle = Seconds(idle);
  limits.least_speed = least_speed;
  return limits;
}

}  // namespace

TEST_CASE("A byte now and then is silence, too") {
  for (const double speed : {20.0, 400.0}) {
    Inbox inbox(limits_of(0.5, 200), Seconds(0));
    double now = 0.0;
    for (int tick = 1; tick <= 20; ++tick) {
      now = 0.05 * tick;
      inbox.moved(0, static_cast<long long>(speed * now), Seconds(now));
    }
    CHECK(inbox.is_silent(Seconds(now)) == (speed < 200));
  }
}

TEST_CASE("An answer that takes its time to begin and comes at once is no silence") {
  Inbox inbox(limits_of(1.5, 1000), Seconds(0));
  inbox.moved(100, 0, Seconds(0));
  CHECK_FALSE(inbox.is_silent(Seconds(1.4)));
  inbox.moved(100, 1, Seconds(1));
  CHECK_FALSE(inbox.is_silent(Seconds(2)));
  inbox.moved(100, 5000, Seconds(2));
  CHECK_FALSE(inbox.is_silent(Seconds(3.4)));
  CHECK(inbox.is_silent(Seconds(3.6)));
}
