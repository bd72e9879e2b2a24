#include "retry.h"

#include <thread>

#include "catch.h"

using namespace roomgen;
using Seconds = RetryPolicy::Seconds;

TEST_CASE("Retry-After is seconds or a date") {
  using namespace std::chrono;
  const auto now = sys_days(1994y / November / 6) + 8h + 49min + 7s;
  CHECK(parse_retry_after("120", now) == Seconds(120));
  CHECK(parse_retry_after(" 0 ", now) == Seconds(0));
  CHECK(parse_retry_after("Sun, 06 Nov 1994 08:49:37 GMT", now) == Seconds(30));
  CHECK(parse_retry_after("Sat, 05 Nov 1994 08:49:37 GMT", now) == Seconds(0));
  for (const char* text : {"", "-1", "1e9", "99999999999", "soon", "Sun, 06 Nov",
                           "Sun, 99 Nov 1994 08:49:37 GMT", "Sun, 06 Foo 1994 08:49:37 GMT"})
    CHECK_FALSE(parse_retry_after(text, now));
}

TEST_CASE("Waits double up to the longest, and differ by up to a half") {
  RetryPolicy policy;
  policy.first_wait = Seconds(1);
  policy.longest_wait = Seconds(10);
  Random random(3);
  for (int failures : {1, 2, 3, 4, 5, 1000}) {
    const double full = failures > 4 ? 10.0 : static_cast<double>(1 << (failures - 1));
    const double wait = backoff(policy, failures, random).count();
    CHECK(wait >= full / 2);
    CHECK(wait <= full);
  }
  Random a(7), b(7);
  CHECK(backoff(policy, 3, a) == backoff(policy, 3, b));
}

TEST_CASE("What may pass is tried again, what will not is not") {
  const auto status = [](int code) {
    HttpAnswer answer;
    answer.status = code;
    return is_transient(answer);
  };
  for (int code : {408, 409, 429, 500, 502, 503, 504, 529}) CHECK(status(code));
  for (int code : {200, 301, 400, 401, 403, 404, 413, 422}) CHECK_FALSE(status(code));
  using Kind = HttpFailure::Kind;
  for (Kind kind : {Kind::refused, Kind::timed_out, Kind::broken})
    CHECK(is_transient(HttpFailure{kind, ""}));
  for (Kind kind : {Kind::no_such_host, Kind::tls, Kind::silent, Kind::too_long, Kind::cancelled})
    CHECK_FALSE(is_transient(HttpFailure{kind, ""}));
}
