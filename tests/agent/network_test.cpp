// Networks that fail: every call ends in time, with an error that says where and what to do.
#include <sys/resource.h>

#include <thread>

#include "asking.h"
#include "catch.h"
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
  // No name server is asked: a label has at most 63 letters.
  const auto asked = ask(quick_options("https://" + std::string(64, 'x') + ".test/v1?token=t"));
  CHECK(contains_text(asked.error(), "unavailable: https://xxx"));
  CHECK(contains_text(asked.error(), "no such host"));
  CHECK(contains_text(asked.error(), "check the base URL"));
  CHECK_FALSE(contains_text(asked.error(), "token"));
  CHECK(asked.seconds < 1.5);
}

TEST_CASE("A server that is not there is tried again, then reported") {
  REQUIRE_PYTHON();
  const Environment environment("");
  const std::string address = "http://127.0.0.1:" + std::to_string(closed_port());
  const auto asked = ask(quick_options(address + "/v1"));
  CHECK(contains_text(asked.error(),
                      "unavailable: " + address + "/v1/chat/completions: cannot connect"));
  CHECK(contains_text(asked.error(), "gave up after 3 attempts"));
  CHECK(asked.seconds < 1.0);
}

TEST_CASE("A certificate that nobody vouches for ends the call before the key is sent") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server(Server::Security::self_signed);
  const auto asked = ask(quick_options(server.url("ok")));
  CHECK(contains_text(asked.error(), "unavailable: https://127.0.0.1"));
  CHECK(contains_text(asked.error(), "no trusted TLS connection"));
  CHECK(server.requests().empty());
  CHECK(asked.seconds < 1.0);
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
  const auto asked = ask(quick_options(server.url("huge")));
  CHECK(contains_text(asked.error(), "limit: "));
  CHECK(contains_text(asked.error(), "longer than 16777216 bytes"));
  CHECK(server.requests().size() == 1);
  CHECK(peak_memory() - before < most_memory);
  CHECK(asked.seconds < 1.5);
}

TEST_CASE("Bytes that drip for ever end with the time for a call") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  auto options = quick_options(server.url("drip"));
  options.retry.attempts = 2;
  options.limits.call = HttpLimits::Seconds(0.5);
  const auto asked = ask(options);
  CHECK(contains_text(asked.error(), "limit: "));
  CHECK(contains_text(asked.error(), "no whole answer within 0.5 s"));
  CHECK(contains_text(asked.error(), "gave up after 2 attempts"));
  CHECK(server.requests().size() == 2);
  CHECK(asked.seconds < 1.7);
}

TEST_CASE("All attempts together end with the total time") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  auto options = quick_options(server.url("drip"));
  options.retry.attempts = 100;
  options.limits.call = HttpLimits::Seconds(0.4);
  options.retry.total = RetryPolicy::Seconds(1);
  const auto asked = ask(options);
  CHECK(contains_text(asked.error(), "out of time"));
  CHECK(asked.seconds < 1.3);
}

TEST_CASE("Silence ends with the time without a byte") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  auto options = quick_options(server.url("slow"));
  options.retry.attempts = 1;
  options.limits.call = HttpLimits::Seconds(60);
  options.limits.idle = HttpLimits::Seconds(0.3);
  const auto asked = ask(options);
  CHECK(contains_text(asked.error(), "limit: "));
  CHECK(contains_text(asked.error(), "hardly a byte for 0.3 s"));
  CHECK(asked.seconds < 1.0);
}

TEST_CASE("A byte now and then is silence, too") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  auto options = quick_options(server.url("drip"));
  options.limits.call = HttpLimits::Seconds(60);
  options.limits.idle = HttpLimits::Seconds(0.5);
  options.limits.least_speed = 200;  // the server sends 20
  const auto asked = ask(options);
  CHECK(contains_text(asked.error(), "limit: "));
  CHECK(contains_text(asked.error(), "hardly a byte for 0.5 s"));
  CHECK(server.requests().size() == 1);
  CHECK(asked.seconds < 1.5);
}

TEST_CASE("An answer that takes its time to begin and comes at once is no silence") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  auto options = quick_options(server.url("late"));
  options.limits.call = HttpLimits::Seconds(60);
  options.limits.idle = HttpLimits::Seconds(1.5);
  options.limits.least_speed = 1000;
  CHECK(ask(options).text() == "hello");
}

TEST_CASE("A connection that is cut halfway is tried again, then reported") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  const auto asked = ask(quick_options(server.url("cut")));
  CHECK(contains_text(asked.error(), "io: "));
  CHECK(contains_text(asked.error(), "the connection broke"));
  CHECK(server.requests().size() == 3);
  CHECK(asked.seconds < 1.5);
}

// What comes of a question that is called off after 0.3 s.
Asked ask_and_cancel(const HttpModelOptions& options) {
  const auto model = make_http_model(options);
  REQUIRE(model);
  auto request = question();
  std::thread canceller([cancel = request.cancel]() mutable {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    cancel.cancel();
  });
  auto asked = ask(**model, request);
  canceller.join();
  return asked;
}

TEST_CASE("A cancelled call ends at once") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  auto options = quick_options(server.url("slow"));
  options.limits.call = options.limits.idle = HttpLimits::Seconds(60);
  const auto asked = ask_and_cancel(options);
  CHECK(contains_text(asked.error(), "cancelled: "));
  CHECK(asked.seconds > 0.29);
  CHECK(asked.seconds < 0.6);
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
  options.retry.first_wait = options.retry.longest_wait = RetryPolicy::Seconds(60);
  options.retry.total = RetryPolicy::Seconds(600);
  const auto asked = ask_and_cancel(options);
  CHECK(contains_text(asked.error(), "cancelled: "));
  CHECK(asked.seconds < 0.6);
}
