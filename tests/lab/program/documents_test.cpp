#include <set>

#include "lab/program/form_operands.h"
#include "programs.h"
#include "roomgen/base/file.h"

using namespace roomgen;
using namespace roomgen::lab;
using namespace test_programs;

namespace {

std::string file(const std::string& path) {
  const auto text = read_file(std::filesystem::path(ROOMGEN_SOURCE_DIR) / path);
  REQUIRE(text);
  return *text;
}

std::set<std::string> strings(const Json& array) {
  std::set<std::string> result;
  for (const auto& element : array) result.insert(element.get<std::string>());
  return result;
}

std::string listed(const std::vector<Face>& faces) {
  static const std::vector<std::string> names = {"front",  "back",    "left", "right", "top",
                                                 "bottom", "support", "wall", "floor", "ceiling"};
  std::string text;
  for (const Face face : faces) text += (text.empty() ? "" : ", ") + names[static_cast<std::size_t>(face)];
  return text;
}

}  // namespace

TEST_CASE("The page of the language has every operator and every relation as they are") {
  const auto page = file("docs/programs.md");
  for (const auto& form : program_op_forms()) {
    const auto row = "| `" + usage(form) + "` | " + std::string(form.meaning) + " |";
    INFO(row);
    CHECK(page.find(row) != std::string::npos);
  }
  for (const auto& [name, how] : built_in_relations()) {
    std::ostringstream row;
    row << "| `" << name << "` | " << listed(how.child) << " | " << listed(how.parent) << " | " << how.margin << " | "
        << (how.type == PutUp::Type::coplanar ? "coplanar" : how.within_height ? "" : "any height") << " |";
    INFO(row.str());
    CHECK(page.find(row.str()) != std::string::npos);
  }
}

TEST_CASE("The example of the page is sound, and said as it stands there") {
  const auto page = file("docs/programs.md");
  const auto begin = page.find("```json\n") + 8, end = page.find("```", begin);
  const auto program = sound(page.substr(begin, end - begin));
  CHECK(check(program, KindTable::built_in()).empty());
  CHECK(page.find("```\n" + to_text(program) + "```") != std::string::npos);
}

TEST_CASE("The schema knows the operators that there are, with their operands") {
  const auto schema = parse_json(file("docs/program.schema.json"), "schema");
  REQUIRE(schema);
  for (const bool truth : {false, true}) {
    const auto& operation = (*schema)["$defs"][truth ? "truthOperation" : "numberOperation"];
    std::set<std::string> names;
    for (const auto& form : program_op_forms())
      if (form.truth == truth) names.emplace(form.name);
    CHECK(strings(operation["prefixItems"][0]["enum"]) == names);
    REQUIRE(operation["allOf"].size() == names.size());
    for (const auto& each : operation["allOf"]) {
      const auto* form = find_op_form(each["if"]["prefixItems"][0]["const"].get<std::string>());
      REQUIRE(form);
      INFO(form->name);
      CHECK(each["then"]["description"] == form->meaning);
      CHECK(each["then"]["minItems"] == operand_count(*form).least + 1);
      CHECK(each["then"]["maxItems"] == operand_count(*form).most + 1);
    }
  }
}

TEST_CASE("Our nine rooms are sound programs") {
  std::size_t programs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(ROOMGEN_SOURCE_DIR) / "examples" / "programs")) {
    const auto program = read_program(entry.path());
    INFO(entry.path() << ": " << error_of(program));
    REQUIRE(program.ok());
    ++programs;
    for (const auto& finding : check(*program, KindTable::built_in())) FAIL_CHECK(finding.at << ": " << finding.message);
  }
  CHECK(programs == 9);
}
