#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "base/random.h"
#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/lab/program.h"
#include "support/error_of.h"

/// Programs to test with.
namespace test_programs {

using namespace roomgen;
using namespace roomgen::lab;

/// In tests/data/programs.
inline std::filesystem::path example(const std::string& name) {
  return std::filesystem::path(ROOMGEN_TEST_DATA) / "programs" / (name + ".json");
}

inline Result<ConstraintProgram> read(const std::string& text) {
  const auto json = parse_json(text, "text");
  if (!json) return json.error();
  return program_from_json(*json, "text");
}

/// A living room with these parts.
inline std::string with_parts(const std::string& parts) {
  return R"({"format": "roomgen-program", "version": 1, "room": {"type": "living room"}, )" + parts + "}";
}

inline ConstraintProgram sound(const std::string& text) {
  auto program = read(text);
  INFO(text << ": " << error_of(program));
  REQUIRE(program.ok());
  return *std::move(program);
}

/// With sofas, tables and chairs, and this for its only constraint.
inline ConstraintProgram with_constraint(const std::string& truth) {
  return sound(with_parts(R"("params": {"p": 2}, "sets": {"sofas": {"factory": "sofa"}, "tables": {"factory": "table"},
    "chairs": {"factory": "chair"}}, "constraints": {"it": )" + truth + "}, \"scores\": {}"));
}

/// Anything that a program may say, whether or not it makes sense.
class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed) {}

  ProgramSet set(int depth = 0) {
    using Source = ProgramSet::Source;
    ProgramSet result;
    result.source = static_cast<Source>(random_.integer(0, depth > 3 ? 5 : 7));
    if (result.source == Source::named || result.source == Source::variable) result.name = word();
    if (result.source == Source::described) describe(result, depth);
    if (result.source == Source::united)
      for (int i = random_.integer(1, 3); i > 0; --i) result.from.push_back(set(depth + 1));
    return result;
  }

  ProgramTerm term(int depth = 0) {
    ProgramTerm result;
    if (depth > 3 || random_.chance(0.2)) {
      if (random_.chance(0.3)) return programs::parameter(word());
      return programs::number(random_.uniform(-5, 5));
    }
    const auto& form = random_.pick(program_op_forms());
    result.op = form.op;
    for (const char c : form.operands) fill(c, result, depth);
    return result;
  }

  ConstraintProgram program() {
    ConstraintProgram result;
    if (random_.chance(0.3)) result.prompt = "a room";
    result.seed = static_cast<std::uint64_t>(random_.integer(0, 3));
    result.room = room();
    for (int i = random_.integer(0, 3); i > 0; --i) result.parameters[word()] = parameter();
    for (int i = random_.integer(0, 2); i > 0; --i) result.relations["own " + word()] = put_up();
    for (int i = 0; i < 3; ++i) {
      result.sets.emplace_back("set " + std::to_string(i), set());
      result.constraints.emplace_back("constraint " + std::to_string(i), term());
      result.scores.emplace_back("score " + std::to_string(i), term());
    }
    return result;
  }

 private:
  std::string word() {
    static const std::vector<std::string> words = {"table", "dining_table", "s", "office-shelf-item", "x y", "größe"};
    return random_.pick(words);
  }

  Range range(double low, double high) {
    const double first = random_.uniform(low, high);
    return random_.chance(0.5) ? Range{first, first} : Range{first, random_.uniform(first, high)};
  }

  void describe(ProgramSet& result, int depth) {
    if (random_.chance(0.5)) {
      result.from.push_back(set(depth + 1));
      if (result.from[0].source == ProgramSet::Source::objects) result.from.clear();
    }
    for (int i = random_.integer(0, 2); i > 0; --i) result.tags.push_back(word());
    for (int i = random_.integer(0, 2); i > 0; --i) result.without.push_back(word());
    if (random_.chance(0.5)) result.factory = word();
    for (int i = random_.integer(0, 2); i > 0; --i)
      result.relations.push_back({random_.chance(0.3), word(), {set(depth + 1)}});
  }

  void fill(char operand, ProgramTerm& result, int depth) {
    static const std::vector<std::string> directions = {"front", "back", "left", "right", "up", "down", "sides"};
    switch (operand) {
      case 'S': result.sets.push_back(set()); break;
      case 'L':
        if (result.op == ProgramOp::minimize || result.op == ProgramOp::maximize) result.number = random_.uniform(0, 9);
        else result.literals.push_back(random_.uniform(-9, 9));
        break;
      case 'v': result.name = word(); break;
      case 's':
        if (random_.chance(0.5)) result.face = static_cast<Face>(random_.integer(0, 9));
        break;
      case 'a':
        if (random_.chance(0.5)) result.direction = random_.pick(directions);
        if (random_.chance(0.5)) result.depth = random_.uniform(0.1, 5);
        break;
      case '+':
        for (int i = random_.integer(0, 2); i > 0; --i) result.operands.push_back(term(depth + 1));
        break;
      default: result.operands.push_back(term(depth + 1));
    }
  }

  ProgramParameter parameter() {
    ProgramParameter result;
    if (random_.chance(0.5)) result.uniform = range(0, 1);
    else
      for (int i = random_.integer(1, 3); i > 0; --i) result.choice.push_back(random_.uniform(0, 1));
    return result;
  }

  PutUp put_up() {
    PutUp result;
    if (random_.chance(0.5)) result.type = PutUp::Type::coplanar;
    result.child = {static_cast<Face>(random_.integer(0, 9))};
    for (int i = 0; i < 2; ++i) result.parent.push_back(static_cast<Face>(random_.integer(0, 9)));
    result.margin = random_.uniform(0, 1);
    result.within_height = random_.chance(0.5);
    return result;
  }

  ProgramRoom room() {
    ProgramRoom result;
    result.type = "living room";
    if (random_.chance(0.5)) result.height = random_.uniform(2, 4);
    if (random_.chance(0.3)) {
      result.area = range(5, 40);
    } else if (random_.chance(0.6)) {
      result.width = range(3, 8);
      result.depth = range(3, 8);
    } else {
      result.polygon = *make_polygon({{0, 0}, {4, 0}, {4, random_.uniform(2, 5)}, {0, 3}});
      if (random_.chance(0.5)) {
        result.openings.emplace();
        Opening door;
        door.id = "door-0";
        door.from = 0.5;
        door.to = 1.4;
        result.openings->push_back(door);
      }
    }
    return result;
  }

  Random random_;
};

}  // namespace test_programs
