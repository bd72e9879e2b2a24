// Servers that answer with an error: what is tried again, and what is said.
#include "asking.h"
#include "catch.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

// What came of a question to a scenario, and how many requests it took.
struct Outcome {
  Asked asked;
  std::size_t requests;
};

Outcome outcome_of(const std::string& scenario) {
  const Environment environment;
  const Server server;
  Outcome outcome{ask(quick_options(server.url(scenario))), 0};
  outcome.requests = server.requests().size();
  return outcome;
}

}  // namespace

TEST_CASE("A wrong key is reported with the variable to set") {
  REQUIRE_PYTHON();
  const auto [asked, requests] = outcome_of("401");
  CHECK(contains_text(asked.error(), "unavailable: http://127.0.0.1"));
  CHECK(contains_text(asked.error(), "answered 401 (Incorrect API key provided: ***)"));
  CHECK(contains_text(asked.error(), "set OPENAI_API_KEY"));
  CHECK(requests == 1);
}

TEST_CASE("An unknown model is reported with the server's words") {
  REQUIRE_PYTHON();
  const auto [asked, requests] = outcome_of("404");
  CHECK(contains_text(asked.error(), "unavailable: "));
  CHECK(contains_text(asked.error(), "answered 404 (The model `tiny-1` does not exist)"));
  CHECK(contains_text(asked.error(), "check the model's name"));
  CHECK(requests == 1);
}

TEST_CASE("A question that is too large is not sent again") {
  REQUIRE_PYTHON();
  const auto [asked, requests] = outcome_of("413");
  CHECK(contains_text(asked.error(), "limit: "));
  CHECK(contains_text(asked.error(), "answered 413; the question is too large"));
  CHECK(requests == 1);
}

TEST_CASE("A storm of 429 is borne for as many attempts as allowed") {
  REQUIRE_PYTHON();
  const auto [asked, requests] = outcome_of("429");
  CHECK(contains_text(asked.error(), "io: "));
  CHECK(contains_text(asked.error(), "answered 429 (slow down)"));
  CHECK(contains_text(asked.error(), "gave up after 3 attempts"));
  CHECK(requests == 3);
  CHECK(asked.seconds < 1.0);
}

TEST_CASE("Retry-After is obeyed") {
  REQUIRE_PYTHON();
  const auto [asked, requests] = outcome_of("429-then-ok");
  CHECK(asked.text() == "hello");
  CHECK(requests == 2);
  CHECK(asked.seconds >= 1.0);
  CHECK(asked.seconds < 1.5);
  REQUIRE(asked.ok());
  CHECK(asked.reply->attempts == 2);
  CHECK(asked.reply->seconds >= 1.0);
}

TEST_CASE("A Retry-After beyond the limit ends the call at once") {
  REQUIRE_PYTHON();
  const auto [asked, requests] = outcome_of("429-long");
  CHECK(contains_text(asked.error(), "io: "));
  CHECK(contains_text(asked.error(), "it asks to wait 3600 s"));
  CHECK(requests == 1);
  CHECK(asked.seconds < 1.0);
}

TEST_CASE("An account without credit is not asked again") {
  REQUIRE_PYTHON();
  const auto [asked, requests] = outcome_of("quota");
  CHECK(contains_text(asked.error(), "unavailable: "));
  CHECK(requests == 1);
}

TEST_CASE("A server that fails twice is asked a third time") {
  REQUIRE_PYTHON();
  const auto [asked, requests] = outcome_of("500-twice");
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
  const auto [asked, requests] = outcome_of("500");
  CHECK(contains_text(asked.error(), "io: "));
  CHECK(contains_text(asked.error(), "answered 500 (out of order); the server failed"));
  CHECK(requests == 3);
}
