#include "language/amount.h"

#include <cmath>
#include <string>

#include "catch.h"

using namespace roomgen::language;

namespace {

std::optional<Amount> amount(const std::string& text) {
  const auto tokens = tokenize(text);
  return amount_at(tokens, 0);
}

struct Said {
  std::string text;
  double low, high;
  bool is_share = false, is_about = false;
};

constexpr double any = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("Amounts are read as people say them", "[language]") {
  const std::vector<Said> all = {
      {"seven chairs", 7, 7},
      {"8 to 12 seats", 8, 12},
      {"8-12 seats", 8, 12},
      {"between 8 and 12 seats", 8, 12},
      {"from six to eight stools", 6, 8},
      {"two or three plants", 2, 3},
      {"exactly 14 seats", 14, 14},
      {"about a dozen chairs", 12, 12, false, true},
      {"roughly 20 pieces", 20, 20, false, true},
      {"10 or so books", 10, 10, false, true},
      {"at least three shelves", 3, any},
      {"no fewer than six bookcases", 6, any},
      {"six or more shelves", 6, any},
      {"more than 20 objects", 21, any},
      {"over 20 objects", 21, any},
      {"no more than four", 0, 4},
      {"up to 4 lamps", 0, 4},
      {"fewer than 10 things", 0, 9},
      {"under 10 things", 0, 9},
      {"not more than 12 objects", 0, 12},
      {"45 % of the floor", 0.45, 0.45, true},
      {"45% of the floor", 0.45, 0.45, true},
      {"30 to 40 per cent", 0.3, 0.4, true},
      {"between 30 and 40 percent", 0.3, 0.4, true},
      {"25 to 35 %", 0.25, 0.35, true},
      {"half of the floor", 0.5, 0.5, true},
      {"a third of the floor", 1.0 / 3.0, 1.0 / 3.0, true},
      {"two thirds of the floor", 2.0 / 3.0, 2.0 / 3.0, true},
      {"a quarter of it", 0.25, 0.25, true},
      {"at least half of the floor", 0.5, any, true},
      {"above 50 %", 0.5, any, true},
      {"0.4 to 0.5", 0.4, 0.5},
  };
  for (const auto& said : all) {
    INFO(said.text);
    const auto read = amount(said.text);
    REQUIRE(read);
    CHECK(std::abs(read->low - said.low) < 1e-9);
    CHECK((std::isinf(said.high) ? std::isinf(read->high) : std::abs(read->high - said.high) < 1e-9));
    CHECK(read->is_share == said.is_share);
    CHECK(read->is_about == said.is_about);
  }
}

TEST_CASE("What is no amount is none", "[language]") {
  for (const std::string text : {"chairs", "a chair", "the third chair", "of 3", "between the beds", "from here", ""})
    CHECK_FALSE(amount(text));
}

TEST_CASE("An amount ends where its words end", "[language]") {
  CHECK(amount("8 to 12 seats")->length == 3);
  CHECK(amount("at least three shelves")->length == 3);
  CHECK(amount("six or more shelves")->length == 3);
  CHECK(amount("45 % of it")->length == 2);
  // Falling pairs are no range: "12 to 8" is twelve of something.
  CHECK(amount("12 to 8")->length == 1);
}
