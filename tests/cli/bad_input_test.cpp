#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "support/contains.h"

namespace {

// Runs `solve` on a problem with this text; the scene would go beside it.
struct Tried {
  Ended ended;
  bool wrote_something = false;
};

Tried solve_text(const std::string& text) {
  const TemporaryFolder folder;
  REQUIRE(roomgen::write_file(folder / "problem.json", text));
  Tried tried;
  tried.ended = run({"solve", folder / "problem.json", "-o", folder / "scene.json"});
  tried.wrote_something = names_in(folder.path()) != std::vector<std::string>{"problem.json"};
  INFO(tried.ended.err);
  CHECK(failed_in_one_line(tried.ended, 1));
  CHECK_FALSE(tried.wrote_something);
  return tried;
}

std::string problem(const std::string& polygon, const std::string& objects) {
  return "{\"name\": \"x\", \"room\": " + polygon + ", \"objects\": [" + objects + "]}";
}

const std::string square = "[[0,0],[4,0],[4,4],[0,4]]";

}  // namespace

TEST_CASE("Wrong usage exits with 2 and one line") {
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"--no-such-option"},
      {"no-such-command"},
      {"solve"},
      {"solve", "a.json", "--no-such-option"},
      {"solve", "a.json", "b.json"},
      {"solve", "a.json", "--seed", "many"},
      {"solve", "a.json", "--pitch", "wide"},
      {"check"}};
  for (const auto& arguments : wrong) {
    const auto ended = run(arguments);
    INFO(ended.err);
    CHECK(failed_in_one_line(ended, 2));
  }
}

TEST_CASE("Help and version are no errors") {
  for (const char* option : {"--help", "--version"}) {
    const auto ended = run({option});
    CHECK(ended.code == 0);
    CHECK(ended.err.empty());
    CHECK(contains_text(ended.out, "roomgen"));
  }
  CHECK(contains_text(run({"solve", "--help"}).out, "--output"));
}

TEST_CASE("A missing file exits with 1 and names the file") {
  for (const char* command : {"solve", "check"}) {
    const auto ended = run({command, "no/such/file.json"});
    CHECK(failed_in_one_line(ended, 1));
    CHECK(contains_text(ended.err, "no/such/file.json: no such file"));
  }
}

TEST_CASE("A folder in place of a file exits with 1") {
  const TemporaryFolder folder;
  CHECK(failed_in_one_line(run({"solve", folder.path()}), 1));
}

TEST_CASE("Text that is no JSON exits with 1 and the place in the text") {
  CHECK(contains_text(solve_text("{\n\"name\": }").ended.err, "line 2, column 9"));
  CHECK(contains_text(solve_text("").ended.err, "problem.json"));
  solve_text("[1, 2]");
  solve_text("null");
}

TEST_CASE("A polygon that crosses itself exits with 1") {
  CHECK(contains_text(solve_text(problem("[[0,0],[4,0],[0,4],[5,6]]", "")).ended.err, "/room: polygon"));
}

TEST_CASE("An unknown target exits with 1 and suggests the right one") {
  const auto text = problem(square, R"({"name": "bed-0", "size": [1.6, 2]},
                                       {"name": "desk-0", "size": [1, 0.6], "constraints": "near, bad-0"})");
  const auto tried = solve_text(text);
  CHECK(contains_text(tried.ended.err, "\"bad-0\""));
  CHECK(contains_text(tried.ended.err, "did you mean \"bed-0\"?"));
}

TEST_CASE("Constraints in a circle exit with 1 and name the objects") {
  const auto text =
      problem(square, R"({"name": "a-0", "size": [1, 1], "constraints": "near, b-0"},
                         {"name": "b-0", "size": [1, 1], "constraints": "near, a-0"})");
  CHECK(contains_text(solve_text(text).ended.err, "\"a-0\", \"b-0\""));
}

TEST_CASE("A constraint with its own object as target exits with 1") {
  CHECK(contains_text(
      solve_text(problem(square, R"({"name": "a-0", "size": [1, 1], "constraints": "near, a-0"})"))
          .ended.err,
      "a-0"));
}

TEST_CASE("An unknown constraint exits with 1 and where it stands") {
  const auto text = problem(square, R"({"name": "a-0", "size": [1, 1], "constraints": "edge | neer, a-0"})");
  const auto tried = solve_text(text);
  CHECK(contains_text(tried.ended.err, "/objects/0/constraints"));
  CHECK(contains_text(tried.ended.err, "did you mean \"near\"?"));
}

TEST_CASE("Options out of range exit with 1 or 2, in one line") {
  const TemporaryFolder folder;
  REQUIRE(roomgen::write_file(folder / "problem.json", problem(square, "")));
  for (const std::vector<std::string>& option :
       {std::vector<std::string>{"--pitch", "0"}, {"--pitch", "-1"}, {"--seed", "-1"},
        {"--seed", "99999999999999999999"}}) {
    std::vector<std::string> arguments = {"solve", folder / "problem.json", "-o", folder / "s.json"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const auto ended = run(arguments);
    INFO(option[0] << " " << option[1] << ": " << ended.err);
    CHECK((failed_in_one_line(ended, 1) || failed_in_one_line(ended, 2)));
  }
  CHECK(names_in(folder.path()) == std::vector<std::string>{"problem.json"});
}

TEST_CASE("An output that cannot be written exits with 1 and leaves nothing") {
  const TemporaryFolder folder;
  REQUIRE(roomgen::write_file(folder / "problem.json", problem(square, "")));
  const std::string missing = (folder / "missing") / "scene.json";
  const auto no_folder = run({"solve", folder / "problem.json", "-o", missing});
  CHECK(failed_in_one_line(no_folder, 1));
  CHECK(contains_text(no_folder.err, missing));
  // A file where a folder should be.
  const auto no_way = run({"solve", folder / "problem.json", "-o", (folder / "problem.json") / "s.json"});
  CHECK(failed_in_one_line(no_way, 1));
  CHECK(failed_in_one_line(run({"solve", folder / "problem.json", "-o", folder.path()}), 1));
  CHECK(names_in(folder.path()) == std::vector<std::string>{"problem.json"});
}
