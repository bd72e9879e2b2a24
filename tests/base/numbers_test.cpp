#include "base/numbers.h"

#include "catch.h"

using namespace roomgen;

TEST_CASE("Numbers are taken one by one from the front") {
  std::string_view text = " -1.5e1,+.5\n2-3x";
  std::vector<double> taken;
  for (skip_separators(text); const auto number = take_number(text); skip_separators(text))
    taken.push_back(*number);
  CHECK(taken == std::vector<double>{-15, 0.5, 2, -3});
  CHECK(text == "x");
}

TEST_CASE("What is no finite number stays") {
  for (const std::string_view whole : {"", "x1", "nan", "inf", "1e999", "+"}) {
    std::string_view text = whole;
    CHECK_FALSE(take_number(text));
    CHECK(text == whole);
  }
}
