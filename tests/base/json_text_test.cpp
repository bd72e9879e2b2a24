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

namespace {

// Writes objects whose keys come again now and then.
std::string text_with_repeats(Random& random, int depth) {
  if (depth == 0 || random.chance(0.3)) return std::to_string(random.integer(-9, 9));
  const bool is_object = random.chance(0.7);
  const int most = random.chance(0.1) ? 90 : 6;
  std::string text(1, is_object ? '{' : '[');
  for (int i = 0, n = random.integer(0, most); i < n; ++i) {
    if (i > 0) text += ", ";
    if (is_object) text += "\"k" + std::to_string(random.integer(0, most)) + "\": ";
    text += text_with_repeats(random, most > 6 ? 0 : depth - 1);
  }
  return text + (is_object ? '}' : ']');
}

}  // namespace

TEST_CASE("Text is read as nlohmann's own parser reads it, keys that come twice included") {
  Random random(11);
  for (int i = 0; i < 400; ++i) {
    const std::string text = text_with_repeats(random, 5);
    const auto read = parse_json(text, "text");
    REQUIRE(read);
    REQUIRE(read->dump() == Json::parse(text).dump());
    // Broken off anywhere, both say so.
    const auto part = text.substr(0, static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()))));
    const auto own = parse_json(part, "text");
    REQUIRE(static_cast<bool>(own) == Json::accept(part));
  }
}

TEST_CASE("A document of four million values is read, one more is too many") {
  const auto zeros = [](std::size_t count) {
    std::string text(2 * count + 1, '0');
    for (std::size_t i = 0; i < text.size(); i += 2) text[i] = ',';
    text.front() = '[', text.back() = ']';
    return text;
  };
  // The array is one of them.
  const auto most = parse_json(zeros(3'999'999), "text");
  REQUIRE(most);
  CHECK(most->size() == 3'999'999);
  const auto more = parse_json(zeros(4'000'000), "text");
  REQUIRE_FALSE(more);
  CHECK(more.error().kind == Error::Kind::limit);
  CHECK(more.error().message == "text: JSON of more than 4000000 values");
}

TEST_CASE("An object of a hundred thousand members is read") {
  std::string text = "{";
  for (int i = 0; i < 100000; ++i) text += (i > 0 ? ",\"" : "\"") + std::to_string(i) + "\":" + std::to_string(i);
  const auto read = parse_json(text + "}", "text");
  REQUIRE(read);
  CHECK(read->size() == 100000);
  CHECK(read->back() == 99999);
}
