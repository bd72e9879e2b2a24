#include "roomgen/chat/chat_model.h"

#include <fstream>

#include "base/resource.h"
#include "catch.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

}  // namespace

TEST_CASE("Every prompt is rendered whole when its slots are filled, and not otherwise") {
  const Prompts prompts = Prompts::built_in();
  const Prompts::Slots plan = {{"prompt", "a study"}, {"room", ""}};
  const Prompts::Slots place = {{"prompt", "a study"}, {"room", "r"},        {"parts", "p"},
                                {"placed", "o"},       {"later", "l"},       {"id", "desk-0"},
                                {"description", "d"},  {"size", "1 x 1 x 1"}, {"mount", "on the floor"},
                                {"refusals", ""},       {"order", ""}};
  Prompts::Slots in_design = place;
  in_design["concept"] = "calm";
  const std::vector<std::pair<std::string, Prompts::Slots>> cases = {
      {"plan-system", {}},
      {"plan-user", plan},
      {"design-system", {{"kinds", "chair, table"}}},
      {"design-pictures", {{"count", "a picture"}}},
      {"design-user", {{"prompt", "a study"}, {"room", "4 x 5 m"}, {"requirements", "r1: a desk"}, {"compositions", "work desk"}}},
      {"place-groups-system", {{"frame", "metres"}, {"words", "edge"}}},
      {"place-groups-user", in_design},
      {"place-system", {{"frame", "metres"}, {"words", "edge"}}},
      {"place-user", place},
      {"place-image-system", {{"frame", "metres"}, {"words", "edge"}}},
      {"place-image-user", place},
      {"place-constraints-system", {{"words", "edge"}}},
      {"place-constraints-user", place},
      {"choose-system", {}},
      {"choose-user", {{"prompt", "a study"}, {"room", "r"}, {"again", ""}, {"offers", "1. desk"}, {"making", "m"}}},
      {"make-system", {{"shapes", "boxes"}}},
      {"make-user", {{"prompt", "a study"}, {"room", "r"}, {"things", "1. globe"}}},
      {"make-again-user", {{"prompt", "a study"}, {"room", "r"}, {"things", "1. globe"}, {"pictures", "p"}}},
      {"place-words", {}},
      {"read-system", {{"relations", "\"on\""}}},
      {"read-user", {{"wish", "a study"}}},
      {"read-pictures", {{"count", "a picture"}}},
      {"again-user", {{"error", "no JSON"}}},
      {"edit-system", {{"frame", "metres"}, {"words", "edge"}, {"operations", "move"}, {"shapes", "boxes"}}},
      {"edit-operations", {}},
      {"review-system", {{"frame", "metres"}, {"words", "edge"}, {"operations", "move"}, {"shapes", "boxes"}}},
      {"review-user", {{"prompt", "a study"}, {"requirements", "r1"}, {"unplaced", "nothing"}, {"room", "r"}, {"parts", "p"}, {"placed", "s"}, {"refused", "x"}}},
      {"edit-user", {{"room", "r"}, {"parts", "p"}, {"placed", "s"}, {"recent", "nothing"}, {"sentence", "add a chair"}}},
      {"program-system", {{"operators", "count"}, {"relations", "on_floor"}, {"kinds", "desk"}, {"tags", "seating"}, {"examples", "{}"}}},
      {"program-user", {{"wish", "a study"}, {"measures", "seats 2"}}},
      {"program-revise-user", {{"wish", "a study"}, {"measures", "seats 2"}, {"program", "{}"}, {"report", "r"}, {"earlier", "e"}}},
      {"question-system", {{"answer_form", "a number"}}},
      {"question-user", {{"times", "0 s"}, {"question", "How high is the desk?"}, {"choices", "0.7\n1.2"}}},
      {"question-video-user", {{"question", "How high is the desk?"}, {"choices", "0.7\n1.2"}}},
      {"create-classify-system", {}},
      {"create-classify-user", {{"prompt", "a stool"}}},
      {"create-decompose-system", {}},
      {"create-decompose-user", {{"prompt", "a stool"}, {"kinds", "chair, table"}}},
      {"create-generate-system", {}},
      {"create-generate-user", {{"prompt", "a stool"}, {"description", "d"}, {"examples", "e"}}},
      {"create-refine-user", {{"prompt", "taller"}, {"earlier", "{}"}}},
      {"create-mesh-system", {}},
      {"create-mesh-user", {{"prompt", "a stool"}, {"description", "d"}}},
      {"create-judge-system", {}},
      {"create-judge-user", {{"prompt", "a stool"}, {"views", "4"}}}};
  CHECK(cases.size() == resources("prompts/").size());
  for (const auto& [name, slots] : cases) {
    INFO(name);
    const auto text = prompts.render(name, slots);
    REQUIRE(text);
    CHECK(text->find("{{") == std::string::npos);
    for (const auto& [slot, value] : slots) {
      INFO(slot);
      CHECK(contains_text(*text, value));
      auto fewer = slots;
      fewer.erase(slot);
      const auto incomplete = prompts.render(name, fewer);
      REQUIRE(!incomplete);
      CHECK(contains_text(incomplete.error().message, slot));
    }
  }
}

TEST_CASE("What fills a slot is not searched for slots") {
  const auto text = Prompts::built_in().render("again-user", {{"error", "{{prompt}} {{error}}"}});
  REQUIRE(text);
  CHECK(contains_text(*text, "{{prompt}} {{error}}"));
}

TEST_CASE("A folder replaces the prompts that it holds") {
  const TemporaryFolder folder;
  write(folder.path() / "again-user.md", "No: {{ error }}!");
  const auto prompts = Prompts::from_folder(folder.path());
  REQUIRE(prompts);
  CHECK(*prompts->render("again-user", {{"error", "late"}}) == "No: late!");
  CHECK(prompts->version() != Prompts::built_in().version());
  CHECK(*prompts->render("plan-system", {}) == *Prompts::built_in().render("plan-system", {}));
}

TEST_CASE("A slot that nothing fills and a folder without prompts are refused") {
  const TemporaryFolder folder;
  const auto empty = Prompts::from_folder(folder.path());
  REQUIRE(!empty);
  CHECK(empty.error().kind == Error::Kind::not_found);
  write(folder.path() / "place-user.md", "Put {{id}} at {{mood}}.");
  const auto strange = Prompts::from_folder(folder.path());
  REQUIRE(!strange);
  CHECK(contains_text(strange.error().message, "mood"));
  CHECK(contains_text(strange.error().message, "refusals"));
}
