// Servers that answer with an error: what is tried again, and what is said.
#include "asking.h"
#include "catch.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

// What came of a question to a scenario, how many requests it took, and the waits between them.
struct Outcome {
  Asked asked;
  std::size_t requests;
  std::vector<double> waits;
};

Outcome outcome_of(const std::string& scenario) {
  const Environment environment;
  const Server server;
  FakeTime time;
  const auto asked = ask(quick_options(server.url(scenario), time));
  return {asked, server.count(), time.waits()};
}

}  // namespace

TEST_CASE("A wrong key is reported with the variable to set") {
  REQUIRE_PYTHON();
  const auto [asked, requests, waits] = outcome_of("401");
  CHECK(contains_text(asked.error(), "unavailable: http://127.0.0.1"));
  CHECK(contains_text(asked.error(), "answered 401 (Incorrect API key provided: ***)"));
  CHECK(contains_text(asked.error(), "set OPENAI_API_KEY"));
  CHECK(requests == 1);
}

TEST_CASE("An unknown model is reported with the server's words") {
  REQUIRE_PYTHON();
  const auto [asked, requests, waits] = outcome_of("404");
  CHECK(contains_text(asked.error(), "unavailable: "));
  CHECK(contains_text(asked.error(), "answered 404 (The model `tiny-1` does not exist)"));
  CHECK(contains_text(asked.error(), "check the model's name"));
  CHECK(requests == 1);
}

TEST_CASE("A question that is too large is not sent again") {
  REQUIRE_PYTHON();
  const auto [asked, requests, waits] = outcome_of("413");
  CHECK(contains_text(asked.error(), "limit: "));
  CHECK(contains_text(asked.error(), "answered 413; the question is too large"));
  CHECK(requests == 1);
}

TEST_CASE("A storm of 429 is borne for as many attempts as allowed") {
  REQUIRE_PYTHON();
  const auto [asked, requests, waits] = outcome_of("429");
  CHECK(contains_text(asked.error(), "io: "));
  CHECK(contains_text(asked.error(), "answered 429 (slow down)"));
  CHECK(contains_text(asked.error(), "gave up after 3 attempts"));
  CHECK(requests == 3);
  CHECK(waits.size() == 2);
}

TEST_CASE("Retry-After is obeyed") {
  REQUIRE_PYTHON();
  const auto [asked, requests, waits] = outcome_of("429-then-ok");
  CHECK(asked.text() == "hello");
  CHECK(requests == 2);
  CHECK(waits == std::vector<double>{1.0});
  REQUIRE(asked.ok());
  CHECK(asked.reply->attempts == 2);
  CHECK(asked.reply->seconds == 1.0);
}

TEST_CASE("A Retry-After beyond the limit ends the call at once") {
  REQUIRE_PYTHON();
  const auto [asked, requests, waits] = outcome_of("429-long");
  CHECK(contains_text(asked.error(), "io: "));
  CHECK(contains_text(asked.error(), "it asks to wait 3600 s"));
  CHECK(requests == 1);
  CHECK(waits.empty());
}

TEST_CASE("An account without credit is not asked again") {
  REQUIRE_PYTHON();
  const auto [asked, requests, waits] = outcome_of("quota");
  CHECK(contains_text(asked.error(), "unavailable: "));
  CHECK(requests == 1);
}

TEST_CASE("A server that fails twice is asked a third time") {
  REQUIRE_PYTHON();
  const auto [asked, requests, waits] = outcome_of("500-twice");
  CHECK(asked.text() == "hello");
  CHECK(requests == 3);
  REQUIRE(asked.ok());
  CHECK(asked.reply->attempts == 3);
  CHECK(asked.reply->input_tokens == 12);
  CHECK(asked.reply->output_tokens == 3);
  CHECK(asked.reply->model == "tiny-1");
}

TEST_CASE("A server that keeps failing is given up") {
  REQUIRE_PYTHON();
  const auto [asked, requests, waits] = outcome_of("500");
  CHECK(contains_text(asked.error(), "io: "));
  CHECK(contains_text(asked.error(), "answered 500 (out of order); the server failed"));
  CHECK(requests == 3);
}

TEST_CASE("A server that loads its model is waited for beyond the attempts") {
  REQUIRE_PYTHON();
  const auto [asked, requests, waits] = outcome_of("loading");
  CHECK(asked.text() == "hello");
  CHECK(requests == 7);
  CHECK(waits.size() == 6);
}

TEST_CASE("A failure that comes with status 200 is taken for what it is") {
  REQUIRE_PYTHON();
  const auto [asked, requests, waits] = outcome_of("429-inside");
  CHECK(contains_text(asked.error(), "answered 429 (slow down)"));
  CHECK(requests == 3);
}
