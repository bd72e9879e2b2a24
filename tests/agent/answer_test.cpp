// Servers that answer 200 with something else than an answer.
#include <map>

#include "asking.h"
#include "catch.h"
#include "support/contains.h"

using namespace roomgen;

TEST_CASE("What is no answer is reported as what it is, and not asked for again") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  const std::map<std::string, std::pair<std::string, std::string>> expected = {
      {"html", {"io: ", "a web page came instead of an answer"}},
      {"truncated", {"io: ", "not valid JSON at line 1"}},
      {"not-utf8", {"io: ", "not valid UTF-8"}},
      {"deep", {"limit: ", "nested more than 64 deep"}},
      {"nothing", {"io: ", "the answer is empty"}},
      {"no-choices", {"io: ", "/choices: missing; expected at least one choice"}},
      {"wrong-types", {"io: ", "/content: expected a text"}},
      {"gateway", {"io: ", "the provider is down"}},
      {"empty", {"io: ", "the model answered with nothing"}},
      {"filtered", {"io: ", "the model declined to answer"}},
      {"long", {"io: ", "cut off after 3 tokens"}},
  };
  std::size_t requests = 0;
  for (const auto& [scenario, error] : expected) {
    FakeTime time;
    const auto asked = ask(quick_options(server.url(scenario), time));
    INFO(scenario << ": " << asked.error());
    CHECK(asked.error().rfind(error.first + server.url(scenario), 0) == 0);
    CHECK(contains_text(asked.error(), error.second));
    CHECK(asked.error().size() < 300);
    CHECK(time.waits().empty());
    CHECK(server.requests().size() == ++requests);
  }
}
