// Every request that reaches the endpoint is counted, whatever came of it.
#include "asking.h"
#include "catch.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

// What a question to a scenario took, request by request: "12+3", "?" for what may have been worked
// for, "5 bytes" for an answer whose tokens nobody counted.
std::vector<std::string> uses_of(const std::string& url, int granted = 100) {
  FakeTime time;
  std::vector<std::string> uses;
  auto request = question_with_schema();
  request.meter.admit = [&]() -> Status {
    if (static_cast<int>(uses.size()) < granted) return {};
    return Error{Error::Kind::limit, "spent"};
  };
  request.meter.count = [&](const ChatUse& use) {
    if (use.answer_bytes)
      uses.push_back(std::to_string(*use.answer_bytes) + " bytes");
    else
      uses.push_back(use.input_tokens ? std::to_string(*use.input_tokens) + "+" +
                                            std::to_string(*use.output_tokens)
                                      : "?");
  };
  ask(quick_options(url, time), request);
  return uses;
}

}  // namespace

TEST_CASE("Requests are counted whose answers are of use, of none, or never come whole") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  using Uses = std::vector<std::string>;
  const auto [scenario, uses] = GENERATE(table<std::string, Uses>({
      {"ok", {"12+3"}},
      {"500-twice", {"0+0", "0+0", "12+3"}},
      {"429-inside", {"0+0", "0+0", "0+0"}},
      {"no-schema", {"0+0", "12+3"}},
      {"long", {"12+3"}},
      {"empty", {"12+3"}},
      {"401", {"0+0"}},
      {"gateway", {"0+0"}},
      {"nothing", {"0 bytes"}},
      {"truncated", {"41 bytes"}},
      {"cut", {"?", "?", "?"}},
      {"huge", {"?"}},
  }));
  CHECK(uses_of(server.url(scenario)) == uses);
  CHECK(server.count() == uses.size());
}

TEST_CASE("What reaches nobody is not counted") {
  REQUIRE_PYTHON();
  const Environment environment;
  const std::string gone = Server().url("ok");
  CHECK(uses_of(gone).empty());
}

TEST_CASE("A meter stops the next request, of a question that is repeated too") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  for (const char* scenario : {"500", "no-schema"}) {
    const std::size_t before = server.count();
    uses_of(server.url(scenario), 1);
    CHECK(server.count() - before == 1);
  }
}
