#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "catch.h"
#include "roomgen/base/json.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

// What a reader says after `read` went through the document; empty if nothing.
template <typename Read>
std::string complaint(const char* text, Read read) {
  const auto json = parse_json(text, "d.json");
  REQUIRE(json);
  JsonReader::Problems problems("d.json");
  read(JsonReader(*json, problems));
  return problems.first() ? problems.first()->message : "";
}

}  // namespace

TEST_CASE("A sound document is read without a complaint") {
  CHECK(complaint(R"({"a": {"b": [1, 2.5]}, "t": "x", "yes": true})", [](const JsonReader& root) {
          CHECK(root["a"]["b"].numbers(2, 0, 10) == std::vector<double>{1, 2.5});
          CHECK(root["t"].text() == "x");
          CHECK(root["yes"].boolean_or(false));
          CHECK(root["missing"].number_or(7, 0, 10) == 7);
          CHECK(root["missing"].text_or("other") == "other");
          CHECK(root["missing"].elements_or_none().empty());
          CHECK_FALSE(root["missing"]["deeper"].exists());
        }).empty());
}

TEST_CASE("A complaint says where in the document, as a JSON pointer") {
  CHECK(contains_text(complaint(R"({"objects": [{"size": [1, 2, 3]}, {"size": [1, "x", 3]}]})",
                                [](const JsonReader& root) {
                                  for (const auto& object : root["objects"].elements())
                                    object["size"].numbers(3, 0, 10);
                                }),
                      "d.json: /objects/1/size/1: expected a number"));
}

TEST_CASE("Only the first complaint is kept") {
  CHECK(contains_text(complaint(R"({"a": "x", "b": "y"})",
                                [](const JsonReader& root) {
                                  root["b"].number(0, 1);
                                  root["a"].number(0, 1);
                                }),
                      "/b: "));
}

TEST_CASE("A value of the wrong kind is a complaint, and reads as the default") {
  const auto wrong = [](auto read) {
    return complaint(R"({"v": {"an": "object"}})", [&](const JsonReader& root) { read(root["v"]); });
  };
  CHECK(contains_text(wrong([](const JsonReader& v) { CHECK(v.number(1, 2) == 1); }), "number"));
  CHECK(contains_text(wrong([](const JsonReader& v) { CHECK(v.integer_or(5, 0, 9) == 5); }), "number"));
  CHECK(contains_text(wrong([](const JsonReader& v) { CHECK(v.boolean_or(true)); }), "true or false"));
  CHECK(contains_text(wrong([](const JsonReader& v) { CHECK(v.text().empty()); }), "text"));
  CHECK(contains_text(wrong([](const JsonReader& v) { CHECK(v.elements().empty()); }), "array"));
  CHECK(contains_text(wrong([](const JsonReader& v) { CHECK(v.numbers(2, 0, 1).size() == 2); }),
                      "array of 2"));
}

TEST_CASE("What must be there is missed") {
  const auto missing = [](auto read) {
    return complaint("{}", [&](const JsonReader& root) { read(root["v"]); });
  };
  CHECK(contains_text(missing([](const JsonReader& v) { v.number(0, 1); }), "/v: missing"));
  CHECK(contains_text(missing([](const JsonReader& v) { v.text(); }), "/v: missing"));
  CHECK(contains_text(missing([](const JsonReader& v) { v.elements(); }), "/v: missing"));
  CHECK(contains_text(missing([](const JsonReader& v) { v.numbers(2, 0, 1); }), "/v: expected"));
}

TEST_CASE("A member of something that is no object is a complaint") {
  CHECK(contains_text(complaint("[1]", [](const JsonReader& root) { root["a"]; }), "object"));
  CHECK(contains_text(complaint("[1]", [](const JsonReader& root) { root.allow_only({"a"}); }),
                      "object"));
  CHECK(contains_text(complaint("[1]", [](const JsonReader& root) { root.members(); }), "object"));
}

TEST_CASE("Null counts as absent") {
  CHECK(complaint(R"({"v": null})", [](const JsonReader& root) {
          CHECK_FALSE(root["v"].exists());
          CHECK(root["v"].text_or("x") == "x");
        }).empty());
}

TEST_CASE("Numbers out of range are refused with the range") {
  CHECK(complaint(R"({"v": 12.5})", [](const JsonReader& root) { root["v"].number(0, 10); }) ==
        "d.json: /v: 12.5 is out of range; expected a number from 0 to 10");
  CHECK(complaint(R"({"v": 10})", [](const JsonReader& root) { root["v"].number(0, 10); }).empty());
}

TEST_CASE("A whole number with a fraction is refused, and one written 2.0 is not") {
  CHECK(contains_text(
      complaint(R"({"v": 2.5})", [](const JsonReader& root) { root["v"].integer_or(0, 0, 9); }),
      "whole number"));
  CHECK(complaint(R"({"v": 2.0})", [](const JsonReader& root) {
          CHECK(root["v"].integer_or(0, 0, 9) == 2);
        }).empty());
}

TEST_CASE("Large whole numbers are read exactly") {
  CHECK(complaint(R"({"v": 9007199254740991})", [](const JsonReader& root) {
          CHECK(root["v"].integer_or(0, 0, 9007199254740991) == 9007199254740991);
        }).empty());
  CHECK(contains_text(complaint(R"({"v": 18446744073709551615})",
                                [](const JsonReader& root) {
                                  CHECK(root["v"].integer_or(3, 0, 9007199254740991) == 3);
                                }),
                      "out of range"));
}

TEST_CASE("Arrays and texts have a greatest length") {
  CHECK(contains_text(
      complaint("[1, 2, 3]", [](const JsonReader& root) { CHECK(root.elements(2).empty()); }),
      "more than 2"));
  CHECK(contains_text(
      complaint(R"(["abc"])", [](const JsonReader& root) { root.elements()[0].text(2); }),
      "/0: longer than 2"));
}

TEST_CASE("An array of the wrong length is refused") {
  for (const char* text : {"[]", "[1]", "[1, 2, 3]"})
    CHECK(contains_text(complaint(text, [](const JsonReader& root) { root.numbers(2, 0, 9); }),
                        "array of 2 numbers"));
}

TEST_CASE("A misspelt key is named together with the right one") {
  CHECK(complaint(R"({"hight": 2})", [](const JsonReader& root) {
          root.allow_only({"width", "height"});
        }) == "d.json: unknown key \"hight\"; did you mean \"height\"?");
}

TEST_CASE("A strange key is named together with all that are known") {
  CHECK(contains_text(
      complaint(R"({"colour": 2})",
                [](const JsonReader& root) { root.allow_only({"width", "height"}); }),
      "known are width, height"));
}

TEST_CASE("A complaint quotes no more than some lines of what a file says") {
  const std::string key(100000, 'k');
  const auto text = complaint(("{\"" + key + "\": {\"" + key + "\": 1}}").c_str(), [&](const JsonReader& root) { root[key].allow_only({"known"}); });
  CHECK(contains_text(text, "unknown key"));
  CHECK(text.size() < 5000);
}

TEST_CASE("A number that is out of range is told as the file has it") {
  const auto told = [](const char* text) {
    return complaint(text, [](const JsonReader& root) { root["a"].number(0.0001, 1000); });
  };
  CHECK(contains_text(told(R"({"a": 1e-30})"), "1e-30 is out of range; expected a number from 0.0001 to 1000"));
  CHECK(contains_text(told(R"({"a": -2e+80})"), "-2e+80 is out of range"));
  CHECK(contains_text(told(R"({"a": 1001})"), "1001 is out of range"));
}
