#include <cmath>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "catch.h"
#include "roomgen/base/json.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

Json random_value(Random& random, int depth) {
  switch (random.integer(0, depth > 0 ? 6 : 4)) {
    case 0: return nullptr;
    case 1: return random.chance(0.5);
    case 2: return random.integer(-1000, 1000);
    case 3: return random.uniform(-1.0, 1.0);
    case 4: return std::string("t\"e\\x\nt ") + std::to_string(random.integer(0, 99)) + " ä";
    case 5: {
      Json array = Json::array();
      for (int n = random.integer(0, 4); n > 0; --n) array.push_back(random_value(random, depth - 1));
      return array;
    }
    default: {
      Json object = Json::object();
      for (int n = random.integer(0, 4); n > 0; --n)
        object["key \"" + std::to_string(n)] = random_value(random, depth - 1);
      return object;
    }
  }
}

std::string nested(int depth) {
  return std::string(static_cast<std::size_t>(depth), '[') +
         std::string(static_cast<std::size_t>(depth), ']');
}

}  // namespace

TEST_CASE("What is dumped parses to the same value and dumps to the same bytes") {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Json value = random_value(random, 4);
    const std::string text = dump_json(value);
    INFO(text);
    const auto parsed = parse_json(text, "dump");
    REQUIRE(parsed);
    REQUIRE(*parsed == value);
    REQUIRE(dump_json(*parsed) == text);
    REQUIRE(text.back() == '\n');
  }
}

TEST_CASE("Short arrays stay on one line and objects do not") {
  const Json value = {{"polygon", {{0, 0}, {4.2, 0}}}, {"name", "a"}};
  CHECK(dump_json(value) == "{\n  \"polygon\": [[0,0],[4.2,0]],\n  \"name\": \"a\"\n}\n");
}

TEST_CASE("A syntax error is located by line and column") {
  const auto parsed = parse_json("{\n  \"a\": 1,\n  \"b\" 2\n}", "x.json");
  REQUIRE_FALSE(parsed);
  CHECK(parsed.error().kind == Error::Kind::invalid_input);
  CHECK(parsed.error().message == "x.json: not valid JSON at line 3, column 7");
}

TEST_CASE("Whatever is no JSON is refused in one line") {
  for (const char* text : {"", " ", "{", "[1,]", "{\"a\":1,}", "nul", "NaN", "\"\x80\"", "1 2", "'a'",
                           "{\"a\":1e999}", "[1] // comment", "\"\\u12\"", "\x00x"}) {
    INFO(text);
    const auto parsed = parse_json(text, "bad.json");
    REQUIRE_FALSE(parsed);
    CHECK(is_one_line(parsed.error().message));
    CHECK(contains_text(parsed.error().message, "bad.json: "));
  }
}

TEST_CASE("Sixty-four levels are read and sixty-five are not") {
  CHECK(parse_json(nested(64), "deep"));
  const auto too_deep = parse_json(nested(65), "deep");
  REQUIRE_FALSE(too_deep);
  CHECK(too_deep.error().kind == Error::Kind::limit);
}

TEST_CASE("A million open brackets are refused, not followed") {
  const auto parsed = parse_json(std::string(1000000, '['), "bomb");
  REQUIRE_FALSE(parsed);
  CHECK(parsed.error().kind == Error::Kind::limit);
}

TEST_CASE("Brackets in texts do not count as depth") {
  CHECK(parse_json("\"" + std::string(100, '[') + "\\\"" + std::string(100, '{') + "\"", "text"));
}

TEST_CASE("Rounded numbers are the nearest and never minus zero") {
  CHECK(rounded(1.23456789) == 1.2346);
  CHECK(rounded(-1.23456789, 2) == -1.23);
  CHECK_FALSE(std::signbit(rounded(-0.00001)));
}
