#include <nlohmann/json.hpp>
#include <string>

#include "box_library.h"
#include "catch.h"
#include "roomgen/lab/compose.h"
#include "roomgen/evaluate/report.h"
#include "support/contains.h"
#include "support/scripted_model.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

const KindTable& kinds() { return KindTable::built_in(); }

ComposeRequest request_for(const std::string& prompt) {
  ComposeRequest request;
  request.plan.prompt = prompt;
  request.plan.seed = 3;
  return request;
}

ComposeOptions quick(int rounds = 5) {
  ComposeOptions options;
  options.rounds = rounds;
  options.assets_each = 1;
  options.optimise.steps = 3000;
  options.optimise.chains = 1;
  options.optimise.seed = 3;
  return options;
}

Composition composed(const std::string& prompt, const ProgramAuthor& author, const ComposeOptions& options) {
  auto result = compose_room(request_for(prompt), author, BoxLibrary(), kinds(), options);
  INFO(prompt);
  if (!result) INFO(result.error().message);
  REQUIRE(result);
  return *std::move(result);
}

std::string program_text(const std::string& desks, const std::string& width = "4") {
  return R"({"reasoning": "desks", "program": {"format": "roomgen-program", "version": 1, "room": {"type": "study", "width": )" + width +
         R"(, "depth": 4}, "sets": {"desk": {"factory": "desk", "rel": [["on_floor", "room"], ["against_wall", "room"]]}},
          "constraints": {"desks": ["==", ["count", "desk"], )" + desks + R"(]}, "scores": {}}})";
}

}  // namespace

TEST_CASE("Rooms that are composed are valid, and rounds end when all is met", "[compose]") {
  for (const std::string prompt :
       {"a bedroom with a double bed and two nightstands", "a meeting room with one table and 8 chairs",
        "a reading room with four bookshelves and seating for three"}) {
    const auto result = composed(prompt, rule_author(), quick());
    for (const auto& round : result.rounds) {
      const auto report = examine(round.result.scene, round.models, kinds());
      for (const auto& violation : report.violations)
        INFO(name(violation.fault) << " " << violation.object << " " << violation.other);
      CHECK(report.violations.empty());
      CHECK(round.report.colliding.empty());
    }
    // Only the last round may be met: there is none behind it.
    for (std::size_t i = 0; i + 1 < result.rounds.size(); ++i) CHECK_FALSE(result.rounds[i].report.is_met());
    CHECK((result.rounds.size() == 5 || result.rounds.back().report.is_met()));
  }
}

TEST_CASE("Patches lead from each program to the next", "[compose]") {
  // More than the room holds: no round can meet it.
  const auto result = composed("a study of 2 x 2.4 m with 6 desks and 6 wardrobes", rule_author(), quick(4));
  REQUIRE(result.rounds.size() > 1);
  for (std::size_t i = 1; i < result.rounds.size(); ++i) {
    const auto& round = result.rounds[i];
    CHECK_FALSE(round.reason.empty());
    CHECK(to_json(result.rounds[i - 1].written.program).patch(round.patch) == to_json(round.written.program));
    // A room that was given stays.
    CHECK(round.written.plan.room.polygon.points == result.rounds[0].written.plan.room.polygon.points);
  }
  double least = 1e9;
  for (const auto& round : result.rounds) least = std::min(least, round.report.violation);
  CHECK(result.chosen().report.violation == least);
}

TEST_CASE("Equal requests give equal rooms", "[compose]") {
  const std::string prompt = "a home office, 30 % of the floor covered";
  const auto once = composed(prompt, rule_author(), quick(2)), again = composed(prompt, rule_author(), quick(2));
  CHECK(to_json(once.chosen().result.scene) == to_json(again.chosen().result.scene));
}

TEST_CASE("A model writes a program, and patches it when the report says what is missed", "[compose]") {
  const auto script = make_script({reply_saying("```json\n" + program_text("9", "2.5") + "\n```"),
                                   reply_saying(R"({"reasoning": "too many", "patch": [{"op": "replace", "path": "/constraints/desks/2", "value": 1}]})")});
  ScriptedModel model(script);
  ComposeOptions options = quick();
  options.picture = [](const Scene&, const ModelTable&) { return Result<std::string>("\x89PNG picture"); };
  const auto author = model_author(model, Prompts::built_in(), {.kinds = {{"desk", {1.4, 0.7, 0.75}}}});
  const auto result = composed("a study with a desk", author, options);
  REQUIRE(result.rounds.size() == 2);
  CHECK(result.rounds[0].report.unmet.size() == 1);
  CHECK(result.rounds[1].report.is_met());
  CHECK(result.best == 1);
  CHECK(result.rounds[1].reason == "too many");
  // The first question has the language and the kinds; the second the program, the report and the picture.
  const auto& first = script->questions.at(0).messages;
  CHECK(contains_text(first.front().text, "desk 1.4x0.7x0.75"));
  CHECK(contains_text(first.front().text, "front_against"));
  CHECK(contains_text(first.front().text, "roomgen-program"));
  const auto& second = script->questions.at(1).messages;
  CHECK(contains_text(second.back().text, "is missed by"));
  CHECK(contains_text(second.back().text, "\"desks\""));
  CHECK(contains_text(second.back().text, "this room cannot have desks"));
  REQUIRE(second.back().images.size() == 1);
  CHECK(second.back().images[0] == "\x89PNG picture");
}

TEST_CASE("What is said of seats, shelves, things and the floor is heard", "[compose]") {
  const std::string prompt = "a lounge with seating for six and 20 to 30 % of the floor covered";
  const auto result = composed(prompt, rule_author(), quick(1));
  const auto& heard = result.chosen().result.scene.heard;
  std::size_t end = 0;
  std::string unheard;
  for (const auto& words : heard) {
    CHECK(words.begin >= end);
    CHECK(words.text == prompt.substr(words.begin, words.end - words.begin));
    end = words.end;
    if (words.as == Heard::As::not_understood) unheard += words.text + "; ";
  }
  CHECK_FALSE(contains_text(unheard, "six"));
  CHECK_FALSE(contains_text(unheard, "30"));
  CHECK_FALSE(contains_text(unheard, "floor"));
}

TEST_CASE("The ledger says of each measure what the error report says, and nothing else of it", "[compose]") {
  for (const std::string prompt : {"a lounge with seating for six and an occupancy of 25 %", "a cafe with seats for ten"}) {
    INFO(prompt);
    const auto result = composed(prompt, rule_author(), quick(1));
    const auto& round = result.chosen();
    REQUIRE_FALSE(round.report.measures.empty());
    for (const auto& measure : round.report.measures) {
      INFO(measure.name);
      const auto& ledger = round.result.scene.requirements;
      const auto found = std::ranges::find_if(
          ledger, [&](const auto& verdict) { return verdict.requirement.id == "measure-" + measure.name; });
      REQUIRE(found != ledger.end());
      CHECK(found->met() == (measure.missed <= 0.0));
      CHECK(std::ranges::any_of(round.result.scene.heard, [&](const Heard& words) {
        return std::ranges::find(words.requirements, found->requirement.id) != words.requirements.end();
      }));
    }
    for (const auto& verdict : round.result.scene.requirements)
      CHECK(verdict.compliance != Compliance::not_judged);
  }
}

TEST_CASE("A model that answers Python is asked again, then the work ends with what was wrong", "[compose]") {
  const auto python = reply_saying("def build_constraints():\n    return cl.Problem(constraints={}, score_terms={})");
  const auto script = make_script({python, python, python});
  ScriptedModel model(script);
  const auto result = compose_room(request_for("a study with a desk"), model_author(model, Prompts::built_in(), {}),
                                   BoxLibrary(), kinds(), quick());
  REQUIRE_FALSE(result);
  CHECK(result.error().kind == Error::Kind::invalid_input);
  CHECK(script->questions.size() == 3);
}

TEST_CASE("Wrong programs and patches are objected to with their place", "[compose]") {
  const auto script = make_script({reply_saying(R"({"program": {"format": "roomgen-program", "version": 1, "room": {"type": "study"},
    "sets": {"x": {"factory": "flux capacitor"}}, "constraints": {"c": ["==", ["count", "x"], 1]}, "scores": {}}})"),
                                   reply_saying(program_text("9", "2.5")),
                                   reply_saying(R"({"patch": [{"op": "remove", "path": "/sets/nothing"}]})"),
                                   reply_saying(program_text("1"))});
  ScriptedModel model(script);
  const auto result = composed("a study with a desk", model_author(model, Prompts::built_in(), {}), quick());
  CHECK(result.chosen().report.is_met());
  CHECK(contains_text(script->questions.at(1).messages.back().text, "flux capacitor"));
  CHECK(contains_text(script->questions.at(3).messages.back().text, "patch"));
}

TEST_CASE("A patch may stand alone", "[compose]") {
  const auto script = make_script(
      {reply_saying(program_text("9", "2.5")),
       reply_saying("```json\n[{\"op\": \"replace\", \"path\": \"/constraints/desks/2\", \"value\": 1}]\n```")});
  ScriptedModel model(script);
  const auto author = model_author(model, Prompts::built_in(), {.kinds = {{"desk", {1.4, 0.7, 0.75}}}});
  const auto result = composed("a study with a desk", author, quick());
  REQUIRE(result.rounds.size() == 2);
  CHECK(result.rounds[1].report.is_met());
}

TEST_CASE("A prompt for several rooms is refused with the way out", "[compose]") {
  const auto result =
      compose_room(request_for("a flat with two bedrooms and a kitchen"), rule_author(), BoxLibrary(), kinds(), quick(1));
  REQUIRE_FALSE(result);
  CHECK(contains_text(result.error().message, "generate"));
}
