#include <fstream>
#include <sstream>

#include "programs.h"

using namespace roomgen;
using namespace roomgen::lab;
using namespace test_programs;

namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string text_of(const std::string& truth) { return to_text(with_constraint(truth).constraints[0].second); }

}  // namespace

TEST_CASE("Programs are printed as sentences") {
  CHECK(text_of(R"(["in", ["count", "sofas"], 1, 3])") == "the number of sofas is from 1 to 3");
  CHECK(text_of(R"(["all", "t", "tables", ["==", ["count", {"from": "chairs", "rel": [["front_against", "$t"]]}], 4]])") ==
        "for every t in tables: the number of (chairs front_against t) = 4");
  CHECK(text_of(R"([">=", ["dist", "sofas", "room", "wall"], 0.5])") ==
        "the distance from sofas to the wall of the room >= 0.5");
  CHECK(text_of(R"(["<", ["access", "sofas", {"union": ["tables", "chairs"]}, {"dir": "sides", "depth": 2}], 0.1])") ==
        "how deep (tables or chairs) reach into the 2 m beside sofas < 0.1");
  CHECK(text_of(R"(["<", ["count", {"tags": ["seating", "-bed"]}], "@p"])") == "the number of non-bed seating < p");
}

TEST_CASE("Brackets keep what belongs together") {
  const std::string one = R"(["==", ["count", "sofas"], 1])", two = R"(["==", ["count", "chairs"], 2])";
  const std::string said_one = "the number of sofas = 1", said_two = "the number of chairs = 2";
  CHECK(text_of("[\"and\", " + one + ", [\"or\", " + one + ", " + two + "]]") ==
        said_one + " and (" + said_one + " or " + said_two + ")");
  CHECK(text_of("[\"not\", " + one + "]") == "not (" + said_one + ")");
  CHECK(text_of("[\"and\", [\"all\", \"t\", \"tables\", " + one + "], " + two + "]") ==
        "(for every t in tables: " + said_one + ") and " + said_two);
  CHECK(text_of("[\"and\", " + one + "]") == said_one);
  CHECK(text_of(R"(["<", ["*", ["+", 1, 2], ["pow", 3, ["-", 1, 2]]], 4])") == "(1 + 2) * 3 ^ (1 - 2) < 4");
  CHECK(text_of(R"(["<", ["-", 1, ["-", 2, 3]], ["min", 4, ["abs", 5]]])") == "1 - (2 - 3) < min(4, |5|)");
}

TEST_CASE("The source's examples read well") {
  for (const std::string name : {"dining", "bathroom", "bedroom"}) {
    const auto program = read_program(example(name));
    REQUIRE(program.ok());
    auto golden = example(name);
    golden.replace_extension(".txt");
    INFO(name << "\n" << to_text(*program));
    CHECK(to_text(*program) == content(golden));
  }
}

TEST_CASE("Whatever a program says can be printed") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto program = Generator(seed).program();
    const auto text = to_text(program);
    // No placeholder stays, and nothing is said to be missing.
    CHECK(text.find('%') == std::string::npos);
    CHECK(text.find('?') == std::string::npos);
  }
}
