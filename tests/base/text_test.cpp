#include "roomgen/base/text.h"

#include <cmath>
#include <limits>

#include "base/random.h"
#include "catch.h"

using namespace roomgen;

namespace {

std::string random_word(Random& random, int max_length) {
  std::string word;
  for (int n = random.integer(0, max_length); n > 0; --n)
    word += static_cast<char>('a' + random.integer(0, 3));
  return word;
}

// The definition, without a table.
std::size_t distance_by_recursion(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::string rest_a = a.substr(1), rest_b = b.substr(1);
  if (a[0] == b[0]) return distance_by_recursion(rest_a, rest_b);
  std::size_t best = std::min({distance_by_recursion(rest_a, b), distance_by_recursion(a, rest_b),
                               distance_by_recursion(rest_a, rest_b)});
  if (a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0])
    best = std::min(best, distance_by_recursion(a.substr(2), b.substr(2)));
  return 1 + best;
}

}  // namespace

TEST_CASE("Lower case changes ASCII letters only") {
  CHECK(lower("Desk-0 ÄÉ") == "desk-0 ÄÉ");
}

TEST_CASE("Trimming takes white space off both ends") {
  CHECK(trim(" \t a b\r\n") == "a b");
  CHECK(trim(" \n ") == "");
}

TEST_CASE("Splitting trims the pieces and keeps the empty ones") {
  CHECK(split(" a |b|| c", '|') == std::vector<std::string>{"a", "b", "", "c"});
  CHECK(split("", '|') == std::vector<std::string>{""});
}

TEST_CASE("Joining undoes splitting") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    std::vector<std::string> pieces;
    for (int n = random.integer(1, 5); n > 0; --n) pieces.push_back(random_word(random, 4));
    REQUIRE(split(join(pieces, "|"), '|') == pieces);
  }
  CHECK(join({}, ", ").empty());
}

TEST_CASE("Equal pieces are joined like different ones") {
  CHECK(join({"a", "a", "", "a"}, "-") == "a-a--a");
}

TEST_CASE("Words are letters and digits in lower case, other languages' letters included") {
  CHECK(words("Coffee-Table 2") == std::vector<std::string>{"coffee", "table", "2"});
  CHECK(words("  --  ").empty());
  CHECK(words("fauteuil à oreilles") == std::vector<std::string>{"fauteuil", "à", "oreilles"});
}

TEST_CASE("Numbers are written as short as they can be") {
  CHECK(format_number(1.5) == "1.5");
  CHECK(format_number(2.0) == "2");
  CHECK(format_number(-0.25) == "-0.25");
  CHECK(format_number(-0.0001) == "0");
  CHECK(format_number(0.05, 2) == "0.05");
  CHECK(format_number(9.9996) == "10");
  CHECK(format_number(12345678.0) == "12345678");
  CHECK(format_number(std::numeric_limits<double>::infinity()) == "?");
  CHECK(format_number(std::nan("")) == "?");
}

TEST_CASE("A written number is the nearest with that many places") {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const double value = random.uniform(-1000.0, 1000.0);
    const int decimals = random.integer(0, 6);
    REQUIRE(std::abs(std::stod(format_number(value, decimals)) - value) <=
            0.5 * std::pow(10.0, -decimals) + 1e-9);
  }
}

TEST_CASE("The edit distance is the least number of changed, added, dropped and swapped letters") {
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("wadrrobe", "wardrobe") == 1);
  CHECK(edit_distance("dekss", "desks") == 1);
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const auto a = random_word(random, 5), b = random_word(random, 5);
    INFO(a << " and " << b);
    REQUIRE(edit_distance(a, b) == distance_by_recursion(a, b));
    REQUIRE(edit_distance(a, b) == edit_distance(b, a));
  }
}

TEST_CASE("A misspelt name finds its neighbour and a strange one finds none") {
  const std::vector<std::string> names = {"sofa-0", "desk-0", "wardrobe-0"};
  CHECK(closest_name("desk-1", names) == "desk-0");
  CHECK(closest_name("wardobe-0", names) == "wardrobe-0");
  CHECK(closest_name("dsek-0", names) == "desk-0");
  CHECK(closest_name("piano-0", names).empty());
  CHECK(closest_name("desk-0", {}).empty());
  // What is longer than any name is no misspelling.
  const std::string longest(60, 'a'), longer(61, 'a');
  CHECK(closest_name(longest, {longest + 'b'}) == longest + 'b');
  CHECK(closest_name(longer, {longer}).empty());
}
