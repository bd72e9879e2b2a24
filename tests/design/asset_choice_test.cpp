#include "asset_choice.h"

#include <algorithm>

#include "catch.h"
#include "support/contains.h"
#include "support/rooms.h"
#include "support/scripted_model.h"

using namespace roomgen;
using Take = AssetChoice::Kind;

namespace {

AssetOffer offer(const std::string& id, std::size_t item, std::size_t assets) {
  AssetOffer result{id, {item}, 1, "a thing", {}, {}, {}, {}};
  for (std::size_t i = 0; i < assets; ++i) {
    OfferedAsset one;
    one.asset.ref.library = "shelf";
    one.asset.ref.id = one.asset.name = "thing-" + std::to_string(i);
    one.size = Vec3(1.0, 0.5, 0.7);
    result.assets.push_back(one);
  }
  return result;
}

/// A model that is asked what four things of a study shall be.
struct Choosing {
  explicit Choosing(std::vector<Result<ChatReply>> answers)
      : script(make_script(std::move(answers))), model(script) {
    plan.prompt = "a study";
    plan.room = rooms::box(4, 3);
    for (const char* category : {"desk", "chair", "shelf", "globe"}) {
      plan.items.emplace_back();
      plan.items.back().category = category;
    }
    ModelDesignerOptions options;
    options.encode_picture = [](const Image&) { return Result<std::string>("PNG"); };
    designer = make_model_designer(model, make_rule_designer(), Prompts::built_in(),
                                   KindTable::built_in(), options);
  }

  ChoiceRequest request(bool again = false) const {
    ChoiceRequest result{
        plan, {offer("1", 0, 4), offer("2", 1, 2), offer("3", 2, 1), offer("4", 3, 0)}, again};
    result.sheets = [] { return Result<std::vector<Image>>(std::vector<Image>{Image(2, 2)}); };
    return result;
  }
  AssetChoices choose(bool again = false) {
    auto choices = designer->choose(request(again));
    REQUIRE(choices);
    return *std::move(choices);
  }

  std::shared_ptr<ScriptedModel::Script> script;
  ScriptedModel model;
  Plan plan;
  std::unique_ptr<Designer> designer;
};

bool says(const std::vector<std::string>& notes, const std::string& text) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return contains_text(note, text); });
}

const std::string whole = R"({"choices": [
  {"item": "1", "take": "1b", "words": "", "size_cm": [120, 60, 75], "paint": "dark walnut", "why": "warm"},
  {"item": "2", "take": "search", "words": "windsor chair", "size_cm": null, "paint": "", "why": ""},
  {"item": "3", "take": "make", "words": "a low shelf with two boards", "size_cm": null, "paint": "", "why": ""},
  {"item": "4", "take": "leave out", "words": "", "size_cm": null, "paint": "", "why": "no globe"}]})";

}  // namespace

TEST_CASE("A model is shown what there is, and its choices are taken as they are said") {
  Choosing talk({reply_saying(whole)});
  const AssetChoices answer = talk.choose();
  REQUIRE(talk.script->questions.size() == 1);
  const ChatRequest& question = talk.script->questions.front();
  CHECK(question.messages.back().images.size() == 1);
  CHECK(question.schema["required"] == Json::array({"choices"}));
  for (const char* text : {"1a: thing-0", "1d: thing-3", "2b:", "3a:", "4. globe", "1 x 0.5 x 0.7"})
    CHECK(contains_text(question.messages.back().text, text));
  REQUIRE(answer.choices.size() == 4);
  CHECK(answer.choices[0].asset == 1);
  CHECK(answer.choices[0].paint == "dark walnut");
  CHECK(answer.choices[0].size->isApprox(Vec3(1.2, 0.6, 0.75)));
  CHECK(answer.choices[1].kind == Take::search);
  CHECK(answer.choices[1].words == "windsor chair");
  CHECK(answer.choices[2].kind == Take::make);
  CHECK(answer.choices[3].kind == Take::leave_out);
  CHECK(answer.choices[3].reason == "no globe");
  CHECK(answer.consultation.calls == 1);
  CHECK(answer.consultation.notes.empty());
}

TEST_CASE(
    "What of an answer cannot be used is told once with its place, and the rest of it holds") {
  Choosing talk(
      {reply_saying(R"({"choices": [{"item": 1, "take": "1c"}, {"item": "2", "take": "2z"},
                    {"item": "9", "take": "9a"}, {"item": "1", "take": "1a"}, {"item": "3", "take": "search"}]})"),
       reply_saying(R"({"choices": {"2": "2b", "3": "throne"}})")});
  const AssetChoices answer = talk.choose();
  REQUIRE(talk.script->questions.size() == 2);
  const std::string& told = talk.script->questions[1].messages.back().text;
  for (const char* text : {"/choices/1/take: \"2z\" is not on the sheet; item 2 has 2a to 2b",
                           "/choices/2/item: \"9\"", "/choices/4/words", "said of item 2, 3, 4"})
    CHECK(contains_text(told, text));
  REQUIRE(answer.choices.size() == 2);
  CHECK(answer.choices[0].asset == 2);  // the first of two counts
  CHECK(answer.choices[1].asset == 1);
  CHECK(says(answer.consultation.notes, "item 3"));
  CHECK(says(answer.consultation.notes, "item 4") == false);  // in one list with it
  CHECK_FALSE(answer.consultation.fell_back);
}

TEST_CASE("Without an answer that can be used the library chooses, and a second search is none") {
  Choosing talk(
      {reply_saying("I like them all."), reply_saying("{}"), reply_saying("[]"),
       reply_saying(R"({"choices": [{"item": "1", "take": "search", "words": "another"}]})"),
       reply_saying(R"({"choices": ["1a", "2a", "3a", {"item": "4", "take": "omit"}]})")});
  const AssetChoices none = talk.choose();
  CHECK(none.choices.empty());
  CHECK(none.consultation.fell_back);
  CHECK(none.consultation.calls == 3);
  const AssetChoices again = talk.choose(true);
  CHECK(contains_text(talk.script->questions[4].messages.back().text, "searched again already"));
  CHECK(again.choices.size() == 4);
}

TEST_CASE("A model without eyes chooses by the text alone") {
  Choosing talk({Error{Error::Kind::invalid_input, "no pictures, please"}, reply_saying("{]"),
                 reply_saying(whole)});
  const AssetChoices answer = talk.choose();
  CHECK(answer.choices.size() == 4);
  CHECK(answer.consultation.image_sha256.empty());
  REQUIRE(talk.script->questions.size() == 3);
  for (const std::size_t turn : {1u, 2u})
    for (const auto& message : talk.script->questions[turn].messages) CHECK(message.images.empty());
}

TEST_CASE("What is still to come is told whole, with its sizes") {
  Choosing talk({reply_saying("no"), reply_saying("no"), reply_saying("no")});
  for (int i = 0; i < 30; ++i) {
    talk.plan.items.push_back(talk.plan.items[1]);
    talk.plan.items.back().category = "thing number " + std::to_string(i);
    talk.plan.items.back().size = Vec3(0.31, 0.42, 0.53);
  }
  Scene scene;
  scene.room = talk.plan.room;
  const PlannedObject planned{"desk-0", 0, 0};
  const Object desk = rooms::thing("desk-0", "desk", {1.4, 0.7, 0.75});
  PlaceRequest request{talk.plan, scene, planned, desk};
  for (const auto& later : planned_objects(talk.plan))
    if (later.id != "desk-0") request.later.push_back(later.id);
  REQUIRE(talk.designer->place(request));
  const std::string& question = talk.script->questions[0].messages.back().text;
  CHECK(contains_text(question, "thing number 29 (0.31 x 0.42 x 0.53)"));
  CHECK(contains_text(question, "globe ("));
}
