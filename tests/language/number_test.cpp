#include "language/number.h"

#include "catch.h"
#include "language/measure.h"

using namespace roomgen::language;
using Catch::Detail::Approx;

namespace {

const char* const units[] = {"zero",    "one",     "two",       "three",    "four",
                             "five",    "six",     "seven",     "eight",    "nine",
                             "ten",     "eleven",  "twelve",    "thirteen", "fourteen",
                             "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
const char* const tens[] = {"",      "",      "twenty",  "thirty", "forty",
                            "fifty", "sixty", "seventy", "eighty", "ninety"};

std::string in_words(int n) {
  if (n < 20) return units[n];
  if (n < 100) return std::string(tens[n / 10]) + (n % 10 ? std::string("-") + units[n % 10] : "");
  const int scale = n < 1000 ? 100 : 1000;
  const std::string rest = n % scale ? (n % scale < 100 ? " and " : " ") + in_words(n % scale) : "";
  return in_words(n / scale) + (scale == 100 ? " hundred" : " thousand") + rest;
}

double value(std::string_view text) {
  const auto tokens = tokenize(text);
  const auto number = number_at(tokens, 0);
  return number && number->length == tokens.size() ? number->value : -1.0;
}

// "length 1.8", "sides 2.5 3", "range 2 3 height"
std::string measured(std::string_view text) {
  const auto measure = measure_at(tokenize(text), 0);
  if (!measure) return "none";
  const char* const kinds[] = {"length", "sides", "area", "range"};
  const char* const sides[] = {"",        " length",    " width",    " depth",
                               " height", " thickness", " diameter", " distance"};
  std::string result = kinds[static_cast<int>(measure->kind)];
  for (int i = 0; i < measure->count; ++i) {
    char number[32];
    std::snprintf(number, sizeof number, " %.4g", measure->values[i]);
    result += number;
  }
  return result + sides[static_cast<int>(measure->side)] + (measure->has_unit ? "" : " no unit");
}

}  // namespace

TEST_CASE("Numbers survive being written in words") {
  for (int n = 0; n < 12'000; n = n < 1200 ? n + 1 : n + 37) {
    INFO(in_words(n));
    REQUIRE(value(in_words(n)) == n);
    REQUIRE(value(std::to_string(n)) == n);
  }
}

TEST_CASE("Dozens, halves and fractions are numbers") {
  CHECK(value("a dozen") == 12);
  CHECK(value("half a dozen") == 6);
  CHECK(value("a half dozen") == 6);
  CHECK(value("two dozen") == 24);
  CHECK(value("2 dozen") == 24);
  CHECK(value("a hundred") == 100);
  CHECK(value("half") == 0.5);
  CHECK(value("a quarter") == 0.25);
  CHECK(value("three quarters") == 0.75);
  CHECK(value("two and a half") == 2.5);
  CHECK(value("1 1/2") == 1.5);
  CHECK(value("1/4") == 0.25);
  CHECK(value("a") == -1);
  CHECK(value("first") == -1);
  CHECK(ordinal_at(tokenize("3rd"), 0) == 3);
  CHECK(ordinal_at(tokenize("second"), 0) == 2);
}

TEST_CASE("Numbers that only stand side by side are two") {
  CHECK(number_at(tokenize("two three"), 0)->length == 1);
  CHECK(number_at(tokenize("two and three"), 0)->length == 1);
  CHECK(number_at(tokenize("twenty and one"), 0)->length == 1);
}

TEST_CASE("Measures are read with their units and sides") {
  const std::pair<const char*, const char*> table[] = {{"1.8 m", "length 1.8"},
                                                       {"180cm wide", "length 1.8 width"},
                                                       {"750 mm", "length 0.75"},
                                                       {"two metres tall", "length 2 height"},
                                                       {"half a metre", "length 0.5"},
                                                       {"a metre and", "length 1"},
                                                       {"6'2\"", "length 1.88"},
                                                       {"5 feet 10 inches", "length 1.778"},
                                                       {"6 ft", "length 1.829"},
                                                       {"30 in deep", "length 0.762 depth"},
                                                       {"1 m 80 cm", "length 1.8"},
                                                       {"2.5 by 3 metres", "sides 2.5 3"},
                                                       {"4x5m", "sides 4 5"},
                                                       {"4 x 5", "sides 4 5 no unit"},
                                                       {"80 x 60 x 75 cm", "sides 0.8 0.6 0.75"},
                                                       {"12' x 15'", "sides 3.658 4.572"},
                                                       {"2-3 m", "range 2 3"},
                                                       {"2 to 3 metres long", "range 2 3 length"},
                                                       {"20 m\u00b2", "area 20"},
                                                       {"20 square metres", "area 20"},
                                                       {"25 qm", "area 25"},
                                                       {"200 sq ft", "area 18.58"},
                                                       {"fifteen sqm", "area 15"},
                                                       {"1.5 m in diameter", "length 1.5 diameter"},
                                                       {"2-metre-long", "length 2 length"},
                                                       {"two chairs", "none"},
                                                       {"3 in the corner", "none"},
                                                       {"3", "none"},
                                                       {"2-seater", "none"}};
  for (const auto& [text, expected] : table) {
    INFO(text);
    CHECK(measured(text) == expected);
  }
}

TEST_CASE("Words that bound a measure belong to it") {
  const auto bounded = [](std::string_view text) {
    const auto tokens = tokenize(text);
    const auto measure = bounded_measure_at(tokens, 0);
    if (!measure || measure->length != tokens.size()) return std::string("none");
    const char* const limits[] = {"exactly", "at least", "at most"};
    return std::string(limits[static_cast<int>(measure->limit)]) + " " +
           std::to_string(static_cast<int>(std::round(measure->values[0] * 100))) +
           (measure->side == Measure::Side::height ? " high" : "");
  };
  CHECK(bounded("2 m") == "exactly 200");
  CHECK(bounded("at least 80 cm") == "at least 80");
  CHECK(bounded("no taller than 2 m") == "at most 200 high");
  CHECK(bounded("taller than 2 m") == "at least 200 high");
  CHECK(bounded("no more than 1.5 m high") == "at most 150 high");
  CHECK(bounded("up to 90 cm") == "at most 90");
  CHECK(bounded("no taller than a man") == "none");
}
