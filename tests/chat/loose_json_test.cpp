#include "chat/loose_json.h"

#include <chrono>

#include "catch.h"

using namespace roomgen;

namespace {

struct Case {
  const char* answer;
  const char* json;
  bool repaired;
};

const WantedKeys keys = {{"constraints", "location"}, {}};

double seconds_to_read(const std::string& text) {
  const auto begin = std::chrono::steady_clock::now();
  (void)find_json(text, keys);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string times(const std::string& text, std::size_t count) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

}  // namespace

TEST_CASE("The object is found and repaired") {
  const Case cases[] = {
      {R"({"location": [1, 2.5]})", R"({"location":[1,2.5]})", false},
      {"Sure!\n```json\n{\"location\": [1, 2]}\n```\nHope it helps {smile}.",
       R"({"location":[1,2]})", false},
      {R"({"location": [1, 2,], })", R"({"location":[1,2]})", true},
      {"{\"location\": [1, 2] // metres\n, /* why */ \"a\": 1}", R"({"location":[1,2],"a":1})",
       true},
      {R"({'location': [1, 2], 'reasoning': 'it\'s fine'})",
       R"({"location":[1,2],"reasoning":"it's fine"})", true},
      {R"({'location': [1, 2], 'reasoning': 'it's fine'})",
       R"({"location":[1,2],"reasoning":"it's fine"})", true},
      {R"({location: [1, 2], constraints: "edge"})", R"({"location":[1,2],"constraints":"edge"})",
       true},
      {R"({"location": None, "a": True, "b": False, "c": NaN})",
       R"({"location":null,"a":true,"b":false,"c":null})", true},
      {"{\u201clocation\u201d: [1, 2]}", R"({"location":[1,2]})", true},
      {R"({"location": [1, 2], "constraints": ["edge")",
       R"({"location":[1,2],"constraints":["edge"]})", true},
      {R"({"location": [1, 2], "constraints": "edge | nea)", R"({"location":[1,2]})", true},
      {R"({"location": [1, 2], "constr)", R"({"location":[1,2]})", true},
      {R"(<think>Maybe {"location": [9, 9]}?</think>{"location": [1, 2]})", R"({"location":[1,2]})",
       false},
      {R"(or {"location": [9, 9]}</think>{"location": [1, 2]})", R"({"location":[1,2]})", false},
      {R"(<think>so {"location": [1, 2]}</think> That is my answer.)", R"({"location":[1,2]})",
       true},
      {R"(<think>so {"location": [1, 2]})", R"({"location":[1,2]})", false},
      {R"({"location": [9, 9]} No, better: {"location": [1, 2]} {"note": "done"})",
       R"({"location":[1,2]})", false},
      {R"({"location": [1, 2]} and {"location": [3)", R"({"location":[1,2]})", false},
      {R"({"answer": {"location": [1, 2]}})", R"({"location":[1,2]})", false},
      {R"([{"location": [1, 2]}])", R"({"location":[1,2]})", false},
      {R"({"a": 1} {"b": [1, 2, 3]})", R"({"b":[1,2,3]})", false},
      {R"({"location": (1.5 m, 2 m)})", R"({"location":["1.5 m","2 m"]})", true},
      {"{\"location\": [1, 2]\n \"reasoning\": \"x\"}", R"({"location":[1,2],"reasoning":"x"})",
       false},
      {R"({"reasoning": "the "best" spot", "location": [1, 2]})",
       R"({"reasoning":"the \"best\" spot","location":[1,2]})", true},
      {R"({"location": [1, 2}, "a": 3})", R"({"location":[1,2]})", true},
      {R"({"reasoning": "\u00e9\ud83d\ude00", "location": []})",
       "{\"reasoning\":\"\u00e9\U0001F600\",\"location\":[]}", false},
      {"{\"location\": [1, 2], \"reasoning\": \"caf\xE9\"}",
       "{\"location\":[1,2],\"reasoning\":\"caf\uFFFD\"}", true},
      {R"({"location": [1e999, +2, .5]})", R"({"location":[null,2,0.5]})", true},
  };
  for (const auto& one : cases) {
    INFO(one.answer);
    const auto found = find_json(one.answer, keys);
    REQUIRE(found);
    CHECK(found->json.dump() == one.json);
    CHECK(!found->repairs.empty() == one.repaired);
  }
}

TEST_CASE("What holds no object is an error") {
  for (const char* text :
       {"", "I cannot help with that.", "[1, 2, 3]", "{", "{}", "}{", "\xff\xfe"}) {
    INFO(text);
    CHECK(!find_json(text, keys));
  }
}

TEST_CASE("Hostile answers end soon") {
  const std::size_t most = max_reply_bytes;
  CHECK(!find_json(std::string(10'000'000, '['), keys));
  for (const std::string text :
       {"[",        "{",  "{\"a\":", "{a:[", "\"",  "'",           "{\"a\":1,", "<think>",
        "</think>", "/*", "{/*",     "\\",   "{\"", "{\"a\" ",     "{'a':'",    "{\"a\":\"\\u",
        ",",        "{,", "(",       "{a:(", "```", "{\"a\":\" \""}) {
    INFO(text);
    CHECK(seconds_to_read(times(text, most / text.size())) < 2.0);
    CHECK(seconds_to_read("{\"location\":" + times(text, (most - 20) / text.size())) < 2.0);
  }
  std::string many = "{";
  for (int i = 0; i < 100'000; ++i) many += "k" + std::to_string(i) + ":1,";
  CHECK(seconds_to_read(many + "}") < 2.0);
}
