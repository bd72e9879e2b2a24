#include <fstream>

#include "programs.h"
#include "roomgen/base/file.h"

using namespace roomgen;
using namespace roomgen::lab;
using namespace test_programs;

namespace {

std::string dumped(const ConstraintProgram& program) { return dump_json(to_json(program)); }

// What is said of a program with that constraint.
std::string complaint(const std::string& term) {
  return error_of(read(with_parts(R"("sets": {"chairs": {"factory": "chair"}}, "constraints": {"it": )" + term + "}")));
}
std::string complaint_of_set(const std::string& set) {
  return error_of(read(with_parts(R"("sets": {"it": )" + set + "}")));
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("The source's examples are read") {
  const auto dining = read_program(example("dining"));
  REQUIRE(dining.ok());
  CHECK(dining->room.type == "dining room");
  REQUIRE(dining->sets.size() == 4);
  CHECK(dining->sets[1].first == "storage");
  const ProgramSet& storage = dining->sets[1].second;
  CHECK(storage.from == std::vector{programs::set("furn")});
  CHECK(storage.tags == std::vector<std::string>{"storage"});
  REQUIRE(dining->constraints.size() == 3);
  // In the file's order, and each with where it stands.
  CHECK(dining->constraints[0].first == "diningroom");
  CHECK(dining->constraints[1].second.operands[0].at == "/constraints/dining_chairs/3");
  const ProgramTerm expected = programs::for_all(
      "t", programs::set("table"),
      programs::within(programs::count(programs::with(programs::among(programs::set("chair"), {}), "front_against",
                                                      programs::variable("t"))),
                       3, 6));
  CHECK(dining->constraints[1].second == expected);

  const auto bathroom = read_program(example("bathroom"));
  REQUIRE(bathroom.ok());
  // Access 2 m deep, and downwards: the source's axes are its own.
  const auto& toilet = bathroom->scores[0].second.operands[3].operands[0];
  CHECK(toilet.op == ProgramOp::access);
  CHECK(toilet.depth == 2.0);
  CHECK(toilet.direction == "front");
  CHECK(bathroom->scores[2].second.operands[1].operands[0].direction == "down");

  const auto bedroom = read_program(example("bedroom"));
  INFO(error_of(bedroom));
  REQUIRE(bedroom.ok());
  CHECK(bedroom->parameters.at("full").uniform == Range{0.6, 0.9});
  CHECK(bedroom->scores[0].second.number == 15.0);
  CHECK(bedroom->scores[4].second.operands[0].operands[0].direction == "sides");
}

TEST_CASE("A program that is written reads as it was") {
  for (const auto* name : {"dining", "bathroom", "bedroom"}) {
    const auto program = read_program(example(name));
    REQUIRE(program.ok());
    const auto again = program_from_json(to_json(*program), name);
    INFO(name << ": " << error_of(again));
    REQUIRE(again.ok());
    CHECK(again->sets == program->sets);
    CHECK(again->constraints == program->constraints);
    CHECK(again->scores == program->scores);
    CHECK(dumped(*again) == dumped(*program));
  }
}

TEST_CASE("Random programs that are written read as they were") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto program = Generator(seed).program();
    const auto text = dumped(program);
    const auto again = read(text);
    INFO("seed " << seed << ": " << error_of(again) << "\n" << text);
    REQUIRE(again.ok());
    CHECK(again->sets == program.sets);
    CHECK(again->constraints == program.constraints);
    CHECK(again->scores == program.scores);
    CHECK(again->parameters == program.parameters);
    CHECK(again->relations == program.relations);
    CHECK(dumped(*again) == text);
  }
}

TEST_CASE("The source's axes are directions of things that look along its x") {
  const std::vector<std::pair<std::string, std::string>> axes = {
      {"+x", "front"}, {"-x", "back"}, {"+y", "left"}, {"-y", "right"}, {"+-y", "sides"}, {"+z", "up"}, {"-z", "down"}};
  for (const auto& [axis, direction] : axes) {
    const auto term = R"(["<=", ["access", "chairs", "objects", {"dir": ")";
    CHECK(with_constraint(term + axis + "\"}], 1]").constraints == with_constraint(term + direction + "\"}], 1]").constraints);
  }
}

TEST_CASE("Words for several faces give all of them") {
  const auto program = sound(with_parts(
      R"("relations": {"beside": {"type": "stable_against", "child": ["leftright"], "parent": ["side", "wall"], "margin": 0.1}})"));
  const PutUp& beside = program.relations.at("beside");
  CHECK(beside.child == std::vector{Face::left, Face::right});
  CHECK(beside.parent == std::vector{Face::front, Face::left, Face::right, Face::wall});
  CHECK(beside.within_height);
}

TEST_CASE("The size of the room is a number, a range, an area or an outline") {
  const auto room = [](const std::string& text) {
    return sound(R"({"sets": {}, "constraints": {}, "room": )" + text + "}").room;
  };
  CHECK(room(R"({"type": "kids-room"})").type == "kids room");
  CHECK(room(R"({"type": "x", "width": 4, "depth": [3, 5]})").depth == Range{3, 5});
  CHECK(room(R"({"type": "x", "width": 4, "depth": [3, 5]})").width == Range{4, 4});
  CHECK(room(R"({"type": "x", "area": [12, 20]})").area == Range{12, 20});
  // Given clockwise; the door stays where it was.
  const auto outlined = room(R"({"type": "x", "height": 3, "polygon": [[0, 0], [0, 3], [4, 3], [4, 0]],
    "openings": [{"id": "door-0", "type": "door", "wall": 1, "from": 0.5, "to": 1.4}]})");
  CHECK(area(*outlined.polygon) == Approx(12));
  CHECK(outlined.height == 3.0);
  REQUIRE(outlined.openings);
  const auto& door = outlined.openings->at(0);
  CHECK(outlined.polygon->edge(door.wall).a.y() == Approx(3));
  CHECK(outlined.polygon->edge(door.wall).b.y() == Approx(3));
  const auto fixed = room(R"({"type": "x", "width": 4, "depth": 3,
    "openings": [{"id": "door-0", "type": "door", "wall": 0, "from": 0.5, "to": 1.4}]})");
  CHECK(fixed.openings->size() == 1);
  CHECK(!room(R"({"type": "x", "area": 12})").openings);
}

TEST_CASE("What cannot be read is said with its place and the nearest word") {
  CHECK(has(complaint(R"(["cuont", "chairs"])"), "/constraints/it/0: \"cuont\" is no operator; did you mean \"count\"?"));
  CHECK(has(complaint(R"(["count"])"), "/constraints/it: 0 operands; expected [\"count\", SET]"));
  CHECK(has(complaint(R"(["in", ["count", "chairs"], 1, 2, 3])"), "4 operands"));
  CHECK(has(complaint(R"(["in", ["count", "chairs"], 1, "two"])"), "/constraints/it/3: expected a number"));
  CHECK(has(complaint(R"(["==", ["count", 3], 1])"), "/constraints/it/1/1: expected a set"));
  CHECK(has(complaint(R"([">=", ["dist", "chairs", "room", "wal"], 1])"), "/constraints/it/1/3: \"wal\" is no face; did you mean \"wall\"?"));
  CHECK(has(complaint(R"([">=", ["dist", "chairs", "room", "side"], 1])"), "several faces"));
  CHECK(has(complaint(R"([">=", ["access", "chairs", "room", {"dir": "+-x"}], 1])"), "is no direction"));
  CHECK(has(complaint(R"([">=", ["access", "chairs", "room", {"deepth": 1}], 1])"), "did you mean \"depth\"?"));
  CHECK(has(complaint(R"(["all", "$c", "chairs", ["and"]])"), "cannot name a variable"));
  CHECK(has(complaint(R"("full")"), "/constraints/it: \"full\" is neither \"@parameter\""));
  CHECK(has(complaint("true"), "expected a number"));
  CHECK(has(complaint("[]"), "expected [\"operator\", operands]"));
  CHECK(has(complaint_of_set(R"({"tag": ["bed"]})"), "/sets/it: unknown key \"tag\"; did you mean \"tags\"?"));
  CHECK(has(complaint_of_set(R"({"rel": [["on"]]})"), "/sets/it/rel/0: expected [\"relation\", SET]"));
  CHECK(has(complaint_of_set(R"({"union": []})"), "a union of no sets"));
  CHECK(has(complaint_of_set(R"({"union": ["a"], "tags": []})"), "unknown key \"tags\""));
  CHECK(has(complaint_of_set("\"@p\""), "names no set"));
  CHECK(has(error_of(read(with_parts(R"("sets": {"room": {}})"))), "every program has a set"));
  CHECK(has(error_of(read(with_parts(R"("sets": {"a/b": {}})"))), "cannot be a name"));
  CHECK(has(error_of(read(with_parts(R"("set": {})"))), "did you mean \"sets\"?"));
  CHECK(has(error_of(read(with_parts(R"("params": {"p": {"uniform": [0, 1], "choice": [1]}})"))), "/params/p"));
  CHECK(has(error_of(read(with_parts(R"("params": {"p": {"choice": []}})"))), "a choice of nothing"));
  CHECK(has(error_of(read(with_parts(R"("relations": {"r": {"type": "touching", "child": ["top"], "parent": ["top"]}})"))),
            "/relations/r/type"));
  CHECK(has(error_of(read(R"({"format": "roomgen-program", "version": 2, "room": {"type": "x"}})")), "/version"));
  CHECK(has(error_of(read(R"({"format": "roomgen-program"})")), "/room"));
  CHECK(has(error_of(read(R"({"room": {"type": "x", "width": 3}})")), "both width and depth"));
  CHECK(has(error_of(read(R"({"room": {"type": "x", "area": 9, "openings": []}})")), "walls of a known length"));
  CHECK(has(error_of(read(R"({"room": {"type": "x", "width": 4, "depth": 3, "openings": [{"id": "door-0", "wall": 0, "from": 0, "to": 9}]}})")),
            "/room/openings"));
}

TEST_CASE("What is hostile is refused in bounded time") {
  // Deeper than JSON files may be, so built: the reader has a bound of its own.
  Json deep = 1.0;
  for (int i = 0; i < 5000; ++i) deep = Json::array({"abs", std::move(deep)});
  Json document = {{"room", {{"type", "x"}}}, {"constraints", {{"it", std::move(deep)}}}};
  CHECK(has(error_of(program_from_json(document, "deep")), "nested more than"));

  Json deep_set = "room";
  for (int i = 0; i < 5000; ++i) deep_set = {{"from", std::move(deep_set)}};
  document = {{"room", {{"type", "x"}}}, {"sets", {{"it", std::move(deep_set)}}}};
  CHECK(has(error_of(program_from_json(document, "deep")), "nested more than"));

  Json wide = Json::array({"and"});
  for (int i = 0; i < 200000; ++i) wide.push_back(Json::array({"not", 1}));
  document = {{"room", {{"type", "x"}}}, {"constraints", {{"it", wide}}}};
  CHECK(has(error_of(program_from_json(document, "wide")), "more than"));

  // Each list within its bound, all together not.
  Json many = Json::object();
  Json sum = Json::array({"+"});
  for (int i = 0; i < 900; ++i) sum.push_back(1);
  for (int i = 0; i < 900; ++i) many["c" + std::to_string(i)] = sum;
  document = {{"room", {{"type", "x"}}}, {"scores", many}};
  CHECK(has(error_of(program_from_json(document, "many")), "more than 20000 sets and terms"));

  for (const auto* text : {"3", "[]", "\"import bpy\"", "null", R"({"room": 3})", R"({"room": {"type": 3}})",
                           R"({"room": {"type": "x"}, "sets": []})", R"({"room": {"type": "x"}, "sets": {"a": null}})",
                           R"({"room": {"type": "x"}, "scores": {"a": [[]]}})",
                           R"({"room": {"type": "x"}, "scores": {"a": [3, 3]}})",
                           R"({"room": {"type": "x"}, "constraints": {"a": ["all", 1, 2, 3]}})",
                           R"({"room": {"type": "x", "polygon": 7}})",
                           R"({"room": {"type": "x"}, "params": {"p": "x"}})",
                           R"({"room": {"type": "x"}, "relations": {"p": []}})"}) {
    INFO(text);
    CHECK(!read(text).ok());
  }
  CHECK(!read("def build_constraints():\n  return cl.Problem()").ok());
}

TEST_CASE("Examples with parts in wrong places are refused with a place, or mean something") {
  std::vector<Json> documents;
  for (const auto* name : {"dining", "bathroom", "bedroom"})
    documents.push_back(*parse_json(*read_file(example(name)), name));
  Random random(16);
  std::size_t read = 0;
  for (int i = 0; i < 2000; ++i) {
    Json document = random.pick(documents);
    for (int n = random.integer(1, 3); n > 0; --n) {
      // What stands somewhere in one example takes the place of something in another.
      const Json other = random.pick(documents).flatten(), here = document.flatten();
      const auto from = std::next(other.begin(), random.integer(0, static_cast<int>(other.size()) - 1));
      const auto to = std::next(here.begin(), random.integer(0, static_cast<int>(here.size()) - 1));
      Json::json_pointer source(from.key()), target(to.key());
      for (int up = random.integer(0, 3); up > 0 && !source.empty(); --up) source = source.parent_pointer();
      for (int up = random.integer(0, 2); up > 0 && !target.parent_pointer().empty(); --up) target = target.parent_pointer();
      document[target] = other.unflatten()[source];
    }
    const auto program = program_from_json(document, "mixed");
    if (!program) {
      INFO(document.dump());
      CHECK(has(program.error().message, "mixed: /"));
      continue;
    }
    ++read;
    for (const auto& finding : check(*program, KindTable::built_in())) CHECK(finding.at.starts_with("/"));
    const auto again = program_from_json(to_json(*program), "again");
    INFO(error_of(again));
    REQUIRE(again.ok());
    CHECK(again->constraints == program->constraints);
    CHECK(to_text(*again) == to_text(*program));
  }
  CHECK(read > 20);
}

TEST_CASE("Programs are known by their format, or by what they have") {
  const auto is = [](const char* text) { return is_program(*parse_json(text, "text")); };
  CHECK(is(R"({"format": "roomgen-program"})"));
  CHECK(is(R"({"version": 1, "room": {}, "sets": {}, "constraints": {}})"));
  CHECK(!is(R"({"format": "roomgen-plan", "sets": {}, "constraints": {}})"));
  CHECK(!is(R"({"objects": [], "constraints": "edge"})"));
  CHECK(!is("[]"));
}

TEST_CASE("What is built says what is read") {
  using namespace roomgen::lab::programs;
  const auto program = with_constraint(
      R"(["and", ["==", ["count", {"from": "chairs", "tags": ["seating", "-table"], "rel": [["on_floor", "room"], ["-any", "sofas"]]}], "@p"],
          ["<", ["dist", "chairs", "doors", "left"], 2]])");
  ProgramSet described = with(tagged("seating"), "on_floor", room());
  described.without = {"table"};
  described = without(among(set("chairs"), described), "any", set("sofas"));
  const ProgramTerm built = term(ProgramOp::equal, {}, {count(described), parameter("p")}) &&
                            term(ProgramOp::less, {}, {distance(set("chairs"), doors(), Face::left), number(2)});
  CHECK(program.constraints[0].second == built);
  CHECK(among(set("a"), among(set("b"), tagged("bed"))) == among(set("a"), tagged("bed")));
  CHECK(among(things(), tagged("bed")) == tagged("bed"));
}
