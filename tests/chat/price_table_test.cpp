#include "roomgen/chat/chat_model.h"

#include "catch.h"
#include "support/contains.h"

using namespace roomgen;

TEST_CASE("A model is priced by the longest name it is a version of") {
  const auto table = PriceTable::built_in();
  const auto input = [&](const char* model) {
    const auto price = table.find(model);
    return price ? price->input : -1.0;
  };
  CHECK(input("gpt-4o") == 2.5);
  CHECK(input("GPT-4o-2024-08-06") == 2.5);
  CHECK(input("openai/gpt-4o-mini") == 0.15);
  CHECK(input("claude-opus-4-1-20250805") == 15);
  CHECK(input("claude-opus-4-5-20251101") == 5);
  CHECK(input("claude-3-5-haiku-latest") == 0.8);
  CHECK(input("gpt-4o-audio-preview") == -1);
  CHECK(input("gpt-4o-") == -1);
  CHECK(input("llama-3") == -1);
  CHECK(input("") == -1);
}

TEST_CASE("Prices are for a million tokens") {
  CHECK(Price{2.5, 10}.of(1'000'000, 100'000) == Approx(3.5));
}

TEST_CASE("A price table of one's own is checked") {
  const auto error_of = [](const char* text) {
    const auto table = PriceTable::parse(text, "prices.json");
    return table ? "" : table.error().message;
  };
  CHECK(error_of(R"({"models": {"home-brew": {"input": 1, "output": 2}}})") == "");
  CHECK(contains_text(error_of("{"), "prices.json: not valid JSON"));
  CHECK(contains_text(error_of("{}"), "no \"models\""));
  CHECK(contains_text(error_of(R"({"models": {"a": {"input": -1, "output": 2}}})"),
                      "/models/a/input"));
  CHECK(contains_text(error_of(R"({"models": {"a": {"input": 1}}})"), "/models/a/output"));
  CHECK(contains_text(error_of(R"({"models": {}, "model": {}})"), "model"));
}
