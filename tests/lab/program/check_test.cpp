#include <algorithm>

#include "programs.h"

using namespace roomgen;
using namespace roomgen::lab;
using namespace test_programs;

namespace {

using Severity = ProgramFinding::Severity;

std::vector<ProgramFinding> findings_of(const std::string& parts, const std::string& room = R"({"type": "living room"})") {
  return check(sound(R"({"room": )" + room + ", " + parts + "}"), KindTable::built_in());
}

// Of a program whose constraints are these, about sofas, tables and chairs.
std::vector<ProgramFinding> findings_about(const std::string& truth) {
  return check(with_constraint(truth), KindTable::built_in());
}
std::vector<ProgramFinding> findings_about_score(const std::string& number) {
  return findings_of(R"("sets": {"chairs": {"factory": "chair"}}, "constraints": {"n": ["in", ["count", "chairs"], 1, 2]},
    "scores": {"it": )" + number + "}");
}

bool says(const std::vector<ProgramFinding>& findings, Severity severity, const std::string& at, const std::string& part) {
  return std::any_of(findings.begin(), findings.end(), [&](const auto& finding) {
    return finding.severity == severity && finding.at == at && finding.message.find(part) != std::string::npos;
  });
}

std::string listed(const std::vector<ProgramFinding>& findings) {
  std::string text;
  for (const auto& finding : findings)
    text += (finding.severity == Severity::error ? "error " : "warning ") + finding.at + ": " + finding.message + "\n";
  return text;
}

// Exactly one finding, this one.
void check_only(const std::vector<ProgramFinding>& findings, Severity severity, const std::string& at,
                const std::string& part) {
  INFO(listed(findings));
  CHECK(findings.size() == 1);
  CHECK(says(findings, severity, at, part));
}

}  // namespace

TEST_CASE("A sound program has no findings, those of the source only permits") {
  CHECK(listed(findings_about(R"(["in", ["count", "sofas"], 1, 3])")).empty());
  for (const auto* name : {"dining", "bathroom", "bedroom"}) {
    const auto findings = check(*read_program(example(name)), KindTable::built_in());
    INFO(listed(findings));
    CHECK(!findings.empty());
    for (const auto& finding : findings) {
      CHECK(finding.severity == Severity::warning);
      CHECK(finding.message.find("any number is permitted") != std::string::npos);
    }
  }
}

TEST_CASE("Words that nobody knows are found where they stand, with the nearest one") {
  const auto set = [](const std::string& text) {
    return findings_of(R"("sets": {"it": )" + text + R"(}, "constraints": {"n": ["in", ["count", "it"], 0, 1]})");
  };
  check_only(set(R"({"tags": ["storige"]})"), Severity::error, "/sets/it", "did you mean \"storage\"?");
  check_only(set(R"({"tags": ["-storige"]})"), Severity::error, "/sets/it", "did you mean \"storage\"?");
  check_only(set(R"({"tags": ["wardrobe"]})"), Severity::error, "/sets/it", "say {\"factory\": \"wardrobe\"}");
  check_only(set(R"({"factory": "dinning_table"})"), Severity::error, "/sets/it", "did you mean \"dining_table\"?");
  check_only(set(R"({"factory": "lounge-seating"})"), Severity::error, "/sets/it", "say {\"tags\": [\"lounge-seating\"]}");
  check_only(set(R"({"rel": [["on_flor", "room"]]})"), Severity::error, "/sets/it", "did you mean \"on_floor\"?");
  check_only(set(R"({"from": "its"})"), Severity::error, "/sets/it/from", "no set is called \"its\"");
  check_only(set(R"({"rel": [["on", "$t"]]})"), Severity::error, "/sets/it/rel/0/1", "no variable here");
  check_only(findings_about(R"(["in", ["count", "sofa"], 0, 1])"), Severity::error, "/constraints/it/1/1",
             "did you mean \"sofas\"?");
  check_only(findings_about(R"(["<", ["dist", "sofas", "tables"], "@q"])"), Severity::error, "/constraints/it/2",
             "no parameter is called \"q\"");
  check_only(findings_about(R"(["and", ["in", ["count", "chairs"], 0, 1], ["all", "t", "tables", ["in", ["count", {"rel": [["on", "$s"]]}], 0, 1]]])"),
             Severity::error, "/constraints/it/2/3/1/1/rel/0/1", "no variable here");
  // A relation of the program's own is known.
  CHECK(listed(findings_of(R"("relations": {"beside": {"type": "stable_against", "child": ["left"], "parent": ["right"]}},
    "sets": {"it": {"factory": "sofa", "rel": [["beside", "objects"]]}}, "constraints": {"n": ["in", ["count", "it"], 0, 1]})")).empty());
  check_only(findings_of(R"("relations": {"on": {"type": "coplanar", "child": ["left"], "parent": ["right"]}},
    "sets": {}, "constraints": {"n": ["in", ["count", "objects"], 0, 1]})"), Severity::error, "/relations/on", "built in");
}

TEST_CASE("A score is a number, a constraint a truth") {
  check_only(findings_about_score(R"(["minimize", 1, ["all", "c", "chairs", ["<", ["dist", "$c", "doors"], 1]]])"),
             Severity::error, "/scores/it/2", "say mean or sum");
  check_only(findings_about_score(R"(["all", "c", "chairs", ["<", ["dist", "$c", "doors"], 1]])"), Severity::error,
             "/scores/it", "say mean or sum");
  check_only(findings_about_score(R"(["minimize", 1, ["+", ["count", "chairs"], ["<", 1, 2]]])"), Severity::error,
             "/scores/it/2/2", "a number is needed");
  check_only(findings_about_score(R"(["dist", "chairs", "doors"])"), Severity::warning, "/scores/it", "small or large");
  CHECK(findings_about_score(R"(["+", ["minimize", 1, ["dist", "chairs", "doors"]], 3])").empty());
  check_only(findings_about("3"), Severity::error, "/constraints/it", "compare it");
  check_only(findings_about(R"("@p")"), Severity::error, "/constraints/it", "compare it");
  check_only(findings_about(R"(["count", "sofas"])"), Severity::error, "/constraints/it", "compare it");
  check_only(findings_about(R"(["and", ["in", ["count", "sofas"], 0, 1], ["count", "sofas"]])"), Severity::error,
             "/constraints/it/2", "compare it");
  check_only(findings_about(R"(["<", ["minimize", 2, ["count", "sofas"]], 2])"), Severity::error, "/constraints/it/1",
             "belongs in the scores");
}

TEST_CASE("Sets that name each other in a circle are found, once each circle") {
  const auto findings = findings_of(R"("sets": {"a": {"from": "b"}, "b": {"rel": [["on", {"union": ["c", "objects"]}]]},
    "c": "a", "d": {"from": "a"}}, "constraints": {"n": ["in", ["count", "d"], 0, 1]})");
  check_only(findings, Severity::error, "/sets/a", "a, b, c, a");
  check_only(findings_of(R"("sets": {"a": {"from": "a"}}, "constraints": {"n": ["in", ["count", "a"], 0, 1]})"),
             Severity::error, "/sets/a", "a, a");
}

TEST_CASE("Bounds that contradict each other are found") {
  check_only(findings_about(R"(["and", ["==", ["count", "sofas"], 2], [">=", ["count", "sofas"], 3]])"), Severity::error,
             "/constraints/it/2/1/1", "at least 3 and at most 2 of \"sofas\"");
  check_only(findings_about(R"(["in", ["count", "sofas"], 3, 2])"), Severity::error, "/constraints/it", "above");
  // Of all sofas there are at most two, so three of them cannot stand on the floor.
  check_only(findings_about(R"(["and", ["<=", ["count", "sofas"], 2],
    ["in", ["count", {"from": "sofas", "rel": [["on_floor", "room"]]}], 3, 4]])"), Severity::error,
             "/constraints/it/2/1/1", "at most 2 of \"sofas\"");
  check_only(findings_about(R"(["and", ["in", ["count", "tables"], 0, 2], ["all", "t", "tables", ["and",
    ["<=", ["count", {"factory": "chair", "rel": [["front_against", "$t"]]}], 2],
    ["in", ["count", {"factory": "chair", "rel": [["front_against", "$t"]]}], 3, 4]]]])"), Severity::error,
             "/constraints/it/2/3/2/1/1", "contradict");
  // Whatever an alternative says need not hold.
  CHECK(findings_about(R"(["and", ["==", ["count", "sofas"], 2], ["or", ["==", ["count", "sofas"], 3], ["==", ["count", "sofas"], 2]]])").empty());
  CHECK(says(findings_of(R"("sets": {}, "constraints": {"n": ["in", ["count", "objects"], 0, 1]})",
                         R"({"type": "x", "width": [4, 3], "depth": 3})"), Severity::error, "/room/width", "above"));
  CHECK(says(findings_of(R"("params": {"p": {"uniform": [2, 1]}}, "sets": {}, "constraints": {"n": ["in", ["count", "objects"], 0, 1]})"),
             Severity::error, "/params/p", "above"));
}

TEST_CASE("Counts without an upper bound only permit") {
  check_only(findings_about(R"([">=", ["count", "sofas"], 2])"), Severity::warning, "/constraints/it/1/1", "any number is permitted");
  CHECK(findings_about(R"(["and", [">=", ["count", "sofas"], 2], ["<", ["count", "sofas"], 4]])").empty());
  check_only(findings_of(R"("sets": {}, "constraints": {})"), Severity::warning, "/constraints", "stays empty");
}

TEST_CASE("More footprint than floor is found") {
  const auto beds = [](const std::string& count, const std::string& room) {
    return findings_of(R"("sets": {"beds": {"factory": "single bed"}, "wardrobes": {"factory": "wardrobe"}},
      "constraints": {"n": ["and", ["in", ["count", "beds"], )" + count + R"(, 20], ["in", ["count", "wardrobes"], 1, 2]]})", room);
  };
  // The smallest kind of single bed is the child's, 0.9 m by 1.8 m, of wardrobes the open one, 1.3 m by 0.5 m.
  check_only(beds("8", R"({"type": "bedroom", "width": 3, "depth": [3, 4]})"), Severity::warning, "/constraints/n/1/1/1",
             "cover at least 13.6 m2, and the room has 12 m2");
  CHECK(beds("7", R"({"type": "bedroom", "width": 3, "depth": [3, 4]})").empty());
  CHECK(beds("8", R"({"type": "bedroom", "area": [5, 14]})").empty());
  CHECK(beds("20", R"({"type": "bedroom"})").empty());
  // Chairs slide under tables, and rugs lie under everything: neither counts.
  CHECK(findings_of(R"("sets": {"chairs": {"factory": "dining chair"}, "rugs": {"factory": "rug"}},
    "constraints": {"n": ["and", ["in", ["count", "chairs"], 40, 40], ["in", ["count", "rugs"], 3, 3]]})",
                    R"({"type": "x", "area": 4})").empty());
  // For each of four tables.
  const auto shelves = findings_of(R"("sets": {"tables": {"factory": "dining table"}}, "constraints": {"n": ["and",
      ["in", ["count", "tables"], 4, 4], ["all", "t", "tables", ["in", ["count", {"factory": "bookshelf", "rel": [["side_by_side", "$t"]]}], 9, 9]]]})",
                                   R"({"type": "x", "area": 8})");
  INFO(listed(shelves));
  CHECK(says(shelves, Severity::warning, "/constraints/n/2/3/1/1", "the room has 8 m2"));
}

TEST_CASE("More things than a room holds are found") {
  check_only(findings_about(R"(["in", ["count", "sofas"], 1001, 2000])"), Severity::error, "/constraints/it/1/1", "1001 things");
  CHECK(says(findings_about(R"(["and", ["in", ["count", "tables"], 40, 50], ["all", "t", "tables", ["in", ["count", {"from": "chairs", "rel": [["front_against", "$t"]]}], 30, 30]]])"),
             Severity::error, "/constraints/it/2/3/1/1", "1240 things"));
}

TEST_CASE("Sets that nothing can be in are found") {
  check_only(findings_about(R"(["and", ["in", ["count", "sofas"], 0, 1], ["all", "s", {"tags": ["bed", "lighting"]}, ["<", ["dist", "$s", "doors"], 1]]])"),
             Severity::warning, "/constraints/it/2/2", "no kind of thing is \"bed lighting\"");
  check_only(findings_about(R"(["in", ["count", {"factory": "rug", "rel": [["hanging", "room"]]}], 1, 2])"),
             Severity::error, "/constraints/it/1/1", "no kind of thing is all of that");
  check_only(findings_about(R"(["in", ["count", {"from": "sofas", "tags": ["-seating"]}], 1, 2])"), Severity::error,
             "/constraints/it/1/1", "no kind of thing");
  // Rooms have doors.
  CHECK(findings_about(R"(["and", ["in", ["count", "sofas"], 0, 1], ["all", "d", "doors", [">", ["dist", "$d", "sofas"], 1]]])").empty());
}

TEST_CASE("Divisions by zero, faces that nothing has and variables twice are found") {
  check_only(findings_about_score(R"(["minimize", 1, ["safediv", ["count", "chairs"], 0]])"), Severity::error, "/scores/it/2", "division by zero");
  check_only(findings_about_score(R"(["minimize", 1, ["dist", "chairs", "room", "front"]])"), Severity::error, "/scores/it/2", "the room has no front");
  check_only(findings_about_score(R"(["minimize", 1, ["dist", "chairs", "chairs", "wall"]])"), Severity::error, "/scores/it/2", "has no wall");
  check_only(findings_about(R"(["all", "t", "tables", ["all", "t", "chairs", ["<", ["dist", "$t", "doors"], 1]]])"),
             Severity::error, "/constraints/it/3", "take another name");
}

TEST_CASE("What was built wrongly is found too") {
  using namespace roomgen::lab::programs;
  ConstraintProgram program;
  program.constraints = {{"none", term(ProgramOp::count, {})},
                         {"few", term(ProgramOp::equal, {}, {number(1)})},
                         {"empty", term(ProgramOp::all_of, {})},
                         {"bounds", term(ProgramOp::within, {}, {count(things())})}};
  ProgramTerm deep = number(1);
  for (int i = 0; i < 60; ++i) deep = term(ProgramOp::absolute, {}, {deep});
  ProgramSet nested = tagged("bed");
  for (int i = 0; i < 40; ++i) nested = with(things(), "on", nested);
  program.scores = {{"deep", minimize(1, deep)}, {"nested", minimize(1, count(nested))}};
  const auto findings = check(program, KindTable::built_in());
  INFO(listed(findings));
  for (const auto* name : {"none", "few", "empty", "bounds"})
    CHECK(says(findings, Severity::error, std::string("/constraints/") + name, "not the operands of"));
  CHECK(says(findings, Severity::error, "/scores/deep", "terms nested too deep"));
  CHECK(says(findings, Severity::error, "/scores/nested", "sets nested too deep"));
}

TEST_CASE("What is nested without end is refused where it stands, and what is not stays permitted") {
  // Eight times the same `all`, one in the other, over so many sofas.
  const auto nested = [](int depth, int sofas) {
    std::string truth = R"([">", ["dist", "$v0", "$v)" + std::to_string(depth - 1) + R"("], 0])";
    for (int i = depth; i-- > 0;) truth = R"(["all", "v)" + std::to_string(i) + R"(", "sofas", )" + truth + "]";
    return findings_about(R"(["and", ["in", ["count", "sofas"], 1, )" + std::to_string(sofas) + "], " + truth + "]");
  };
  check_only(nested(8, 10), Severity::error, "/constraints/it/2", "nest fewer of them");
  CHECK(nested(8, 4).empty());
  CHECK(nested(5, 10).empty());
  check_only(nested(6, 10), Severity::error, "/constraints/it/2", "a program may take 1000000");
  check_only(nested(9, 1), Severity::error, "/constraints/it/2/3/3/3/3/3/3/3/3", "more than 8 variables");
  // Pairs of what each of many brings.
  const auto cups = [](const std::string& each) {
    return findings_about(R"(["and", ["in", ["count", "tables"], 0, 20], ["all", "t", "tables",
      ["in", ["count", {"factory": "cup", "rel": [["on", "$t"]]}], 0, )" + each + R"(]],
      ["all", "a", {"factory": "cup"}, ["all", "b", {"factory": "cup"}, [">", ["dist", "$a", {"factory": "cup"}], 0]]]])");
  };
  CHECK(cups("4").empty());
  check_only(cups("6"), Severity::error, "/constraints/it/3", "nest fewer");
}

TEST_CASE("Any program is checked in bounded time, and its findings are few") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto program = Generator(seed).program();
    const auto findings = check(program, KindTable::built_in());
    CHECK(findings.size() <= 100);
    for (const auto& finding : findings) CHECK(finding.at.starts_with("/"));
  }
  // As many mistakes as a program has room for, and sets that stand for ever more sets.
  Json wide = Json::array({"and"});
  for (int i = 0; i < 900; ++i) wide.push_back(Json::array({"<", Json::array({"count", "nobody" + std::to_string(i)}), 1}));
  Json document = {{"room", {{"type", "x"}}}, {"constraints", {{"it", wide}}}};
  CHECK(check(*program_from_json(document, "wide"), KindTable::built_in()).size() == 100);
  Json sets = {{"s0", {{"factory", "sofa"}}}};
  for (int i = 1; i < 900; ++i) {
    const std::string before = "s" + std::to_string(i - 1);
    sets["s" + std::to_string(i)] = {{"union", {before, before}}};
  }
  document = {{"room", {{"type", "x"}}}, {"sets", sets},
              {"constraints", {{"it", Json::array({"in", Json::array({"count", "s899"}), 1, 2})}}}};
  CHECK(check(*program_from_json(document, "doubled"), KindTable::built_in()).empty());
  // Variables of sets of variables of sets.
  Json truth = Json::array({">", Json::array({"count", "$v7"}), 0});
  for (int i = 7; i > 0; --i) {
    const std::vector<std::string> wider(500, "$v" + std::to_string(i - 1));
    truth = Json::array({"all", "v" + std::to_string(i), {{"union", wider}}, truth});
  }
  truth = Json::array({"all", "v0", {{"factory", "sofa"}}, truth});
  document = {{"room", {{"type", "x"}}}, {"sets", Json::object()}, {"constraints", {{"it", truth}}}};
  for (const auto& finding : check(*program_from_json(document, "wide"), KindTable::built_in()))
    CHECK(finding.severity == Severity::warning);
}
