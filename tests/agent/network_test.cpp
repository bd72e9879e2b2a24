// Networks that fail: every call ends in time, with an error that says where and what to do.
#include <sys/resource.h>

#include "asking.h"
#include "catch.h"
#include "clock.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

// What an answer of 16 MB may cost, in MB; the thread sanitizer keeps books of each byte.
#ifdef __SANITIZE_THREAD__
constexpr double most_memory = 4.0 * 64.0;
#else
constexpr double most_memory = 64.0;
#endif

// The most memory the process has had, in MB.
double peak_memory() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// A port of this machine that nobody listens at: that of a server that is gone.
int closed_port() {
  return Server().port();
}

}  // namespace

TEST_CASE("A host that does not exist is not asked twice") {
  const Environment environment;
  FakeTime time;
  // No name server is asked: a label has at most 63 letters.
  const auto asked =
      ask(quick_options("https://" + std::string(64, 'x') + ".test/v1?token=t", time));
  CHECK(contains_text(asked.error(), "unavailable: https://xxx"));
  CHECK(contains_text(asked.error(), "no such host"));
  CHECK(contains_text(asked.error(), "check the base URL"));
  CHECK_FALSE(contains_text(asked.error(), "token"));
  CHECK(time.waits().empty());
}

TEST_CASE("A server that is not there is tried again, then reported") {
  REQUIRE_PYTHON();
  const Environment environment("");
  const std::string address = "http://127.0.0.1:" + std::to_string(closed_port());
  FakeTime time;
  const auto asked = ask(quick_options(address + "/v1", time));
  CHECK(contains_text(asked.error(),
                      "unavailable: " + address + "/v1/chat/completions: cannot connect"));
  CHECK(contains_text(asked.error(), "gave up after 3 attempts"));
  CHECK(time.waits().size() == 2);
}

TEST_CASE("A certificate that nobody vouches for ends the call before the key is sent") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server(Server::Security::self_signed);
  FakeTime time;
  const auto asked = ask(quick_options(server.url("ok"), time));
  CHECK(contains_text(asked.error(), "unavailable: https://127.0.0.1"));
  CHECK(contains_text(asked.error(), "no trusted TLS connection"));
  CHECK(server.requests().empty());
  CHECK(time.waits().empty());
}

TEST_CASE("A redirect is not followed, and says where it led") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server, other;
  const auto asked = ask(quick_options(server.url("redirect=" + std::to_string(other.port()))));
  CHECK(contains_text(asked.error(), "unavailable: "));
  CHECK(contains_text(asked.error(),
                      "answered 307, a redirect to 127.0.0.1:" + std::to_string(other.port())));
  CHECK_FALSE(contains_text(asked.error(), "token"));
  CHECK(server.requests().size() == 1);
  CHECK(other.requests().empty());
}

TEST_CASE("An answer of 200 MB is not read to its end") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  const double before = peak_memory();
  FakeTime time;
  const auto asked = ask(quick_options(server.url("huge"), time));
  CHECK(contains_text(asked.error(), "limit: "));
  CHECK(contains_text(asked.error(), "longer than 16777216 bytes"));
  CHECK(server.requests().size() == 1);
  CHECK(peak_memory() - before < most_memory);
}

TEST_CASE("Bytes that drip for ever end with the time for a call") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  FakeTime time(&server, FakeTime::Seconds(0.1));
  auto options = quick_options(server.url("drip"), time);
  options.retry.attempts = 2;
  options.limits.call = HttpLimits::Seconds(0.5);
  const auto asked = ask(options);
  CHECK(contains_text(asked.error(), "limit: "));
  CHECK(contains_text(asked.error(), "no whole answer within 0.5 s"));
  CHECK(contains_text(asked.error(), "gave up after 2 attempts"));
  CHECK(server.count() == 2);
}

TEST_CASE("All attempts together end with the total time") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  FakeTime time(&server, FakeTime::Seconds(0.1));
  auto options = quick_options(server.url("drip"), time);
  options.retry.attempts = 100;
  options.limits.call = HttpLimits::Seconds(0.4);
  options.retry.total = RetryPolicy::Seconds(1);
  const auto asked = ask(options);
  CHECK(contains_text(asked.error(), "out of time"));
  CHECK(server.count() <= 3);
}

TEST_CASE("Silence ends with the time without a byte, and is not asked again") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  FakeTime time(&server, FakeTime::Seconds(0.1));
  auto options = quick_options(server.url("silent"), time);
  options.limits.call = HttpLimits::Seconds(60);
  options.limits.idle = HttpLimits::Seconds(0.3);
  const auto asked = ask(options);
  CHECK(contains_text(asked.error(), "limit: "));
  CHECK(contains_text(asked.error(), "hardly a byte for 0.3 s"));
  CHECK(contains_text(asked.error(), "--idle-seconds"));
  CHECK(server.count() == 1);
}

TEST_CASE("A connection that is cut halfway is tried again, then reported") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  FakeTime time;
  const auto asked = ask(quick_options(server.url("cut"), time));
  CHECK(contains_text(asked.error(), "io: "));
  CHECK(contains_text(asked.error(), "the connection broke"));
  CHECK(server.count() == 3);
  CHECK(time.waits().size() == 2);
}

TEST_CASE("A call that is cancelled while the server is silent ends") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  auto options = quick_options(server.url("silent"));
  auto request = question();
  options.clock.now = [&] {
    if (server.count() == 1) request.cancel.cancel();
    return HttpClock::Seconds(0);
  };
  const auto asked = ask(options, request);
  CHECK(contains_text(asked.error(), "cancelled: "));
  CHECK(server.count() == 1);
}

TEST_CASE("A call that was cancelled before contacts nobody") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  auto request = question();
  request.cancel.cancel();
  CHECK(contains_text(ask(quick_options(server.url("ok")), request).error(), "cancelled: "));
  CHECK(server.requests().empty());
}

TEST_CASE("A wait before the next attempt can be cancelled") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  auto options = quick_options(server.url("500"));
  auto request = question();
  options.clock.pause = [&](HttpClock::Seconds, const CancelToken& cancel) {
    request.cancel.cancel();
    return completed({}).pause(std::chrono::hours(1), cancel);  // the machine's
  };
  CHECK(contains_text(ask(options, request).error(), "cancelled: "));
  CHECK(server.count() == 1);
}
