#include "asset_making.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "support/contains.h"
#include "support/rooms.h"
#include "support/scripted_model.h"

using namespace roomgen;

namespace {

const Json program_form = {{"type", "object"}, {"$defs", {{"number", {{"type", "number"}}}}}};

/// A model that is asked for two things of a diner.
struct Maker {
  explicit Maker(std::vector<Result<ChatReply>> answers)
      : script(make_script(std::move(answers))), model(script) {
    plan.prompt = "a diner";
    plan.room = rooms::box(6, 4);
    plan.room.type = "diner";
    for (const char* category : {"jukebox", "bar counter", "bar stool"}) {
      plan.items.emplace_back();
      plan.items.back().category = category;
    }
    plan.items[1].group = plan.items[2].group = "bar";
    ModelDesignerOptions options;
    options.encode_picture = [](const Image&) { return Result<std::string>("PNG"); };
    designer = make_model_designer(model, make_rule_designer(), Prompts::built_in(),
                                   KindTable::built_in(), options);
  }

  MakingRequest request(bool again = false) const {
    MakingRequest result{plan, {}, program_form, again};
    for (std::size_t i = 0; i < 2; ++i) {
      AssetOffer offer{i == 0 ? "3" : "8", {i}, 1, i == 0 ? "a rounded jukebox" : "a mint bar"};
      offer.size = Vec3(1.0, 0.6, 1.5);
      result.things.push_back({offer, "", {}});
    }
    return result;
  }

  std::shared_ptr<ScriptedModel::Script> script;
  ScriptedModel model;
  Plan plan;
  std::unique_ptr<Designer> designer;
};

Reading<std::map<std::size_t, std::string>> programs_in(const std::string& text, bool again) {
  const Maker making({});
  auto read = design::read_programs(text, making.request(again));
  if (!read) FAIL(read.error().message);
  return *std::move(read);
}

bool tells(const std::vector<std::string>& notes, const std::string& text) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return contains_text(note, text); });
}

}  // namespace

TEST_CASE("Programs of an answer are read by their items, and what is none is told with its place") {
  const auto read = programs_in(R"(Here: {"things": [
      {"item": 8, "program": {"name": "bar", "components": []}},
      {"item": "99", "program": {"components": []}},
      {"item": "3", "program": "a jukebox"},
      {"item": "8", "program": {"name": "another"}},
      {"item": "3", "components": [{"name": "body"}]}, 7]})",
                                false);
  REQUIRE(read.value.size() == 2);
  CHECK(contains_text(read.value.at(1), "\"bar\""));
  CHECK(contains_text(read.value.at(0), "\"body\""));
  for (const char* text : {"/things/1/item: \"99\" was not to be made", "/things/2/program: is no",
                           "/things/3: item 8 was written before", "/things/5: is no object"})
    CHECK(tells(read.repairs, text));
  CHECK(programs_in(R"({"things": {"3": {"program": {"name": "a"}}}})", false).value.count(0) == 1);
}

TEST_CASE("Only who looks again may leave everything as it is") {
  const Maker making({});
  CHECK(programs_in(R"({"things": []})", true).value.empty());
  for (const char* text : {R"({"things": []})", R"({"things": [{"item": "4"}]})", "Fine."}) {
    const auto first = design::read_programs(text, making.request());
    REQUIRE(!first);
    CHECK(first.error().kind == Error::Kind::invalid_input);
  }
  CHECK(!design::read_programs("Fine.", making.request(true)));
}

TEST_CASE("A model is told what shall be made, and shown what it made with what is wrong with it") {
  Maker talk({reply_saying(R"({"things": [{"item": "3", "program": {"name": "a"}}]})"),
               reply_saying(R"({"things": []})")});
  CHECK(talk.designer->makes());
  const auto first = talk.designer->make(talk.request());
  REQUIRE(first);
  CHECK(first->programs.size() == 1);
  CHECK(first->consultation.calls == 1);
  const ChatRequest& question = talk.script->questions.front();
  CHECK(question.schema["$defs"] == program_form["$defs"]);
  CHECK(question.schema["properties"]["things"]["items"]["properties"]["program"]["type"] ==
        "object");
  const auto shapes = Prompts::built_in().render("create-generate-system", {});
  REQUIRE(shapes);
  CHECK(contains_text(question.messages.front().text, *shapes));
  for (const char* text : {"3. jukebox: a rounded jukebox, 1 x 0.6 x 1.5 m",
                           "8. bar counter: a mint bar", "goes with: bar stool", "diner, 6 x 4 m"})
    CHECK(contains_text(question.messages.back().text, text));

  auto request = talk.request(true);
  request.things[0].program = first->programs.at(0);
  request.things[0].notes = {"/components/2/box: is missing"};
  request.sheets = [] { return Result<std::vector<Image>>(std::vector<Image>{Image(2, 2)}); };
  const auto second = talk.designer->make(request);
  REQUIRE(second);
  CHECK(second->programs.empty());
  const ChatMessage& seen = talk.script->questions.back().messages.back();
  CHECK(seen.images.size() == 1);
  CHECK(contains_text(seen.text, "Written: {\"name\":\"a\"}"));
  CHECK(contains_text(seen.text, "- /components/2/box: is missing"));
}

TEST_CASE("Where no answer can be used the designer says so, and rules make things") {
  Maker talk({reply_saying("no"), reply_saying("no"), reply_saying("no")});
  const auto none = talk.designer->make(talk.request());
  REQUIRE(none);
  CHECK(none->programs.empty());
  CHECK(none->consultation.fell_back);
  CHECK(tells(none->consultation.notes, "rules make them"));
}
