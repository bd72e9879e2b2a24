#include <cmath>
#include <limits>

#include "programs.h"

using namespace roomgen;
using namespace roomgen::lab;
using namespace test_programs;

namespace {

constexpr double none = std::numeric_limits<double>::infinity();

struct Found {
  std::string set;
  double low, high;
  std::vector<std::string> variables = {};
  bool operator==(const Found&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Found& found) {
  return out << found.set << " " << found.low << " " << found.high << " " << found.variables.size();
}

std::vector<Found> bounds_of(const std::string& truth) {
  const auto program = with_constraint(truth);
  std::vector<Found> found;
  for (const auto& bound : count_bounds(program)) {
    found.push_back({bound.set->name, bound.low, bound.high});
    for (const auto& [name, set] : bound.variables) found.back().variables.push_back(name + " " + set->name);
  }
  return found;
}

}  // namespace

TEST_CASE("Comparisons of counts with numbers are bounds, whichever side they stand on") {
  using Bounds = std::vector<Found>;
  CHECK(bounds_of(R"(["in", ["count", "sofas"], 1, 3])") == Bounds{{"sofas", 1, 3}});
  CHECK(bounds_of(R"(["==", ["count", "sofas"], 2])") == Bounds{{"sofas", 2, 2}});
  CHECK(bounds_of(R"(["==", 2, ["count", "sofas"]])") == Bounds{{"sofas", 2, 2}});
  CHECK(bounds_of(R"([">=", ["count", "sofas"], 2])") == Bounds{{"sofas", 2, none}});
  CHECK(bounds_of(R"([">", ["count", "sofas"], 2])") == Bounds{{"sofas", 3, none}});
  CHECK(bounds_of(R"(["<=", ["count", "sofas"], 2])") == Bounds{{"sofas", 0, 2}});
  CHECK(bounds_of(R"(["<", ["count", "sofas"], 2])") == Bounds{{"sofas", 0, 1}});
  CHECK(bounds_of(R"(["<", 2, ["count", "sofas"]])") == Bounds{{"sofas", 3, none}});
  CHECK(bounds_of(R"([">=", 2, ["count", "sofas"]])") == Bounds{{"sofas", 0, 2}});
  // Things come whole.
  CHECK(bounds_of(R"(["in", ["count", "sofas"], 0.5, 2.5])") == Bounds{{"sofas", 1, 2}});
  CHECK(bounds_of(R"([">", ["count", "sofas"], 2.5])") == Bounds{{"sofas", 3, none}});
  CHECK(bounds_of(R"(["<", ["count", "sofas"], 2.5])") == Bounds{{"sofas", 0, 2}});
  CHECK(bounds_of(R"([">=", ["count", "sofas"], -1])") == Bounds{{"sofas", 0, none}});
}

TEST_CASE("Bounds come from what must hold altogether") {
  using Bounds = std::vector<Found>;
  CHECK(bounds_of(R"(["and", ["==", ["count", "sofas"], 1], ["and", ["<=", ["count", "chairs"], 4]]])") ==
        Bounds{{"sofas", 1, 1}, {"chairs", 0, 4}});
  CHECK(bounds_of(R"(["all", "t", "tables", ["all", "s", "sofas", ["in", ["count", "chairs"], 3, 6]]])") ==
        Bounds{{"chairs", 3, 6, {"t tables", "s sofas"}}});
  for (const auto* none_at_all :
       {R"(["or", ["==", ["count", "sofas"], 1], ["==", ["count", "chairs"], 1]])", R"(["not", ["==", ["count", "sofas"], 1]])",
        R"(["!=", ["count", "sofas"], 1])", R"(["==", ["count", "sofas"], ["count", "chairs"]])",
        R"(["==", ["count", "sofas"], "@p"])", R"(["in", ["+", ["count", "sofas"], ["count", "chairs"]], 1, 2])",
        R"(["<=", ["dist", "sofas", "chairs"], 1])"})
    CHECK(bounds_of(none_at_all).empty());
}

TEST_CASE("The source's examples bound what they are about") {
  const auto bedroom = read_program(example("bedroom"));
  REQUIRE(bedroom.ok());
  const auto bounds = count_bounds(*bedroom);
  REQUIRE(bounds.size() == 10);
  CHECK(bounds[0].set->name == "bed");
  CHECK(bounds[4].low == 2);
  CHECK(bounds[4].high == 5);
  // Whatever stands on a storage unit: permitted.
  CHECK(bounds[6].set->tags == std::vector<std::string>{"office-shelf-item"});
  CHECK(bounds[6].high == none);
  REQUIRE(bounds[8].variables.size() == 1);
  CHECK(bounds[8].variables[0].first == "d");
  CHECK(bounds[8].set->factory == "monitor");
}
