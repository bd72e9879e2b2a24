#include <algorithm>

#include "catch.h"
#include "roomgen/design/designer.h"
#include "support/contains.h"
#include "support/rooms.h"
#include "support/scripted_model.h"

using namespace roomgen;

namespace {

const char* const good_plan = R"({"room": {"type": "study", "size_m": [4, 3], "height_m": 2.6},
  "objects": [{"name": "desk", "description": "an oak desk", "size_cm": [140, 70, 75], "quantity": 1},
              {"name": "chair", "description": "a chair", "size_cm": [50, 50, 90], "quantity": 2}]})";

Error failure(Error::Kind kind) {
  return {kind, "the line is dead"};
}

// A study with a desk, in which a chair is to be placed, and a designer that asks a script.
struct Conversation {
  explicit Conversation(std::vector<Result<ChatReply>> answers, ModelDesignerOptions options = {})
      : script(make_script(std::move(answers))), model(script) {
    scene.room = rooms::box(4, 3);
    scene.room.openings = {rooms::door("door-0", 0, 0.4, 1.3)};
    scene.objects = {rooms::thing("desk-0", "desk", {1.4, 0.7, 0.75}, {2, 2.6})};
    plan.prompt = "a study";
    plan.room = scene.room;
    PlanItem seat;
    seat.category = "chair";
    plan.items = {seat};
    designer = make_model_designer(model, make_rule_designer(), Prompts::built_in(),
                                   KindTable::built_in(), std::move(options));
  }

  Result<PlaceAdvice> place(std::vector<std::string> refusals = {},
                            std::vector<Bounds2> free_floor = {}) {
    PlaceRequest request{plan, scene, planned, chair, std::move(refusals)};
    request.free_floor = std::move(free_floor);
    request.later = {"chair-1", "floor lamp-0"};
    request.marks = [] { return Result<std::vector<Image>>(std::vector<Image>{Image(2, 2)}); };
    return designer->place(request);
  }
  Result<Plan> make_plan(const std::string& prompt = "a study with a desk") {
    PlanRequest request;
    request.prompt = prompt;
    return designer->plan(request);
  }
  const std::string& question(std::size_t turn) const {
    return script->questions.at(turn).messages.back().text;
  }

  std::shared_ptr<ScriptedModel::Script> script;
  ScriptedModel model;
  Scene scene;
  Plan plan;
  PlannedObject planned{"chair-0", 0, 0};
  Object chair = rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9});
  std::unique_ptr<Designer> designer;
};

const std::string good_place =
    R"({"reasoning": "to sit", "constraints": "middle | near, desk-0 | face to, desk-0",
        "location": [2.0, 1.8], "facing": "desk-0"})";

}  // namespace

TEST_CASE("A model's plan and place are taken as they are said") {
  Conversation talk({reply_saying(good_plan), reply_saying(good_place)});
  const auto plan = talk.make_plan();
  REQUIRE(plan);
  CHECK(plan->room.type == "study");
  REQUIRE(plan->items.size() == 2);
  CHECK(plan->items[0].category == "desk");
  CHECK(plan->items[1].quantity == 2);
  CHECK_FALSE(talk.designer->plan_consultation().fell_back);
  CHECK(talk.designer->plan_consultation().input_tokens == 100);

  const auto advice = talk.place();
  REQUIRE(advice);
  CHECK(to_text(advice->relations) == "middle | near, desk-0 | face to, desk-0");
  REQUIRE(advice->location);
  CHECK((*advice->location - Vec2(2.0, 1.8)).norm() < 1e-9);
  REQUIRE(advice->yaw);
  CHECK(std::abs(wrap_angle(*advice->yaw - pi)) < 1e-6);
  CHECK(advice->consultation.calls == 1);
  CHECK_FALSE(advice->consultation.fell_back);
  for (const char* word : {"desk-0", "door-0", "chair-0", "a study"})
    CHECK(contains_text(talk.question(1), word));
}

TEST_CASE("An answer that cannot be used is asked for again with the reason, then rules decide") {
  Conversation talk({reply_saying("I would rather not."), reply_saying("{}"),
                     reply_saying(R"({"constraints": "near, throne-0"})")});
  const auto advice = talk.place();
  REQUIRE(advice);
  CHECK(advice->consultation.calls == 3);
  CHECK(advice->consultation.fell_back);
  CHECK(advice->usual);
  CHECK(contains_text(talk.question(1), "holds no JSON object"));
  CHECK(contains_text(talk.question(1), "\"constraints\", \"location\""));
  CHECK(talk.script->questions[1].messages.size() == 4);
  CHECK(talk.script->questions[2].messages.size() == 6);
}

TEST_CASE("The second answer counts when it can be used") {
  Conversation talk({reply_saying("{]"), reply_saying(good_place)});
  const auto advice = talk.place();
  REQUIRE(advice);
  CHECK(advice->consultation.calls == 2);
  CHECK_FALSE(advice->consultation.fell_back);
  CHECK(advice->location);
}

TEST_CASE("A model that takes no pictures goes on without them, and that is said once") {
  std::vector<std::string> said;
  ModelDesignerOptions options;
  options.encode_picture = [](const Image&) { return Result<std::string>("PNG"); };
  options.log = [&](LogLevel, std::string_view message) { said.emplace_back(message); };
  Conversation talk({failure(Error::Kind::invalid_input), reply_saying(good_place), reply_saying(good_place)},
                    options);
  for (int turn = 0; turn < 2; ++turn) {
    const auto advice = talk.place();
    REQUIRE(advice);
    CHECK_FALSE(advice->consultation.fell_back);
    CHECK(advice->consultation.image_sha256.empty());
  }
  REQUIRE(talk.script->questions.size() == 3);
  for (const std::size_t turn : {0u, 1u, 2u})
    CHECK(talk.script->questions[turn].messages.back().images.size() == (turn == 0 ? 1 : 0));
  CHECK(said.size() == 1);
}

TEST_CASE("After three failures in a row the model is not asked any more") {
  Conversation talk({failure(Error::Kind::io), failure(Error::Kind::io), reply_saying(good_place),
                     failure(Error::Kind::io), failure(Error::Kind::io), failure(Error::Kind::io),
                     reply_saying(good_place)});
  for (const bool by_rules : {true, true, false, true, true, true, true}) {
    const auto advice = talk.place();
    REQUIRE(advice);
    CHECK(advice->consultation.fell_back == by_rules);
  }
  CHECK(talk.script->questions.size() == 6);
}

TEST_CASE("After two calls that ran out of time the model is not asked any more") {
  Conversation talk({failure(Error::Kind::limit), failure(Error::Kind::limit), reply_saying(good_place)});
  for (int i = 0; i < 3; ++i) {
    const auto advice = talk.place();
    REQUIRE(advice);
    CHECK(advice->consultation.fell_back);
  }
  CHECK(talk.script->questions.size() == 2);
}

TEST_CASE("A model that cannot be used at all is asked once") {
  Conversation talk({failure(Error::Kind::unavailable)});
  REQUIRE(talk.place());
  const auto advice = talk.place();
  REQUIRE(advice);
  CHECK(talk.script->questions.size() == 1);
  REQUIRE_FALSE(advice->consultation.notes.empty());
  CHECK(contains_text(advice->consultation.notes.back(), "the line is dead"));
}

TEST_CASE("Without a model there is no plan, but one that fails leaves it to the rules") {
  CHECK_FALSE(Conversation({failure(Error::Kind::unavailable)}).make_plan());
  CHECK_FALSE(Conversation({failure(Error::Kind::cancelled)}).make_plan());
  Conversation talk({failure(Error::Kind::io)});
  const auto plan = talk.make_plan();
  REQUIRE(plan);
  CHECK(plan->items.size() > 3);
  CHECK(talk.designer->plan_consultation().fell_back);
  REQUIRE_FALSE(plan->notes.empty());
  CHECK(contains_text(plan->notes.back(), "rules made this one"));
}

TEST_CASE("What a plan forgot goes back once, then rules add it") {
  const std::string prompt = "a study with a desk, a green wardrobe by the window and no chair";
  Conversation talk({reply_saying(good_plan), reply_saying(good_plan)});
  const auto plan = talk.make_plan(prompt);
  REQUIRE(plan);
  CHECK(talk.designer->plan_consultation().calls == 2);
  CHECK_FALSE(talk.designer->plan_consultation().fell_back);
  CHECK(contains_text(talk.question(1), "a green wardrobe"));
  REQUIRE(plan->items.size() == 2);
  for (const auto& item : plan->items) CHECK(item.asked);
  CHECK(plan->items[0].category + ", " + plan->items[1].category == "desk, wardrobe");
  const auto has = [&](Requirement::Kind kind, const std::string& category) {
    return std::any_of(plan->requirements.begin(), plan->requirements.end(), [&](const auto& one) {
      return one.kind == kind && one.category == category && one.source == Requirement::Source::prompt;
    });
  };
  CHECK(has(Requirement::Kind::count, "desk"));
  CHECK(has(Requirement::Kind::count, "wardrobe"));
  CHECK(has(Requirement::Kind::attribute, "wardrobe"));
  CHECK(has(Requirement::Kind::relation, "wardrobe"));
  CHECK(has(Requirement::Kind::absence, "chair"));
  for (const auto& one : plan->requirements)
    if (one.kind == Requirement::Kind::relation)
      CHECK(one.subjects == std::vector<std::string>{"wardrobe-0"});
  CHECK(std::any_of(plan->heard.begin(), plan->heard.end(),
                    [](const Heard& words) { return words.text == "wardrobe"; }));
}

TEST_CASE("A second plan that forgets nothing is taken") {
  const std::string whole = R"({"room": {"type": "study", "size_m": [4, 3]}, "objects": [
    {"name": "desk", "size_cm": [140, 70, 75]}, {"name": "wardrobe", "size_cm": [100, 60, 200]}]})";
  Conversation talk({reply_saying(good_plan), reply_saying(whole)});
  const auto plan = talk.make_plan("a study with a desk and a wardrobe");
  REQUIRE(plan);
  CHECK(plan->items.size() == 2);
  CHECK(plan->items[1].category == "wardrobe");
  CHECK(std::none_of(plan->notes.begin(), plan->notes.end(),
                     [](const auto& note) { return contains_text(note, "added by rules"); }));
}

TEST_CASE("A plan that was cut off is used as far as it goes") {
  ChatReply half = reply_saying(std::string(good_plan).substr(0, 260));
  half.cut_off = true;
  Conversation talk({half});
  const auto plan = talk.make_plan();
  REQUIRE(plan);
  CHECK(plan->items.front().category == "desk");
  CHECK_FALSE(talk.designer->plan_consultation().fell_back);
  CHECK(contains_text(talk.designer->plan_consultation().notes.front(), "cut off"));
}

TEST_CASE("A plan with more furniture than floor is sent back") {
  std::string many = R"({"room": {"type": "study", "size_m": [3, 3]}, "objects": [)";
  for (int i = 0; i < 12; ++i)
    many +=
        std::string(i ? "," : "") + R"({"name": "bed", "size_cm": [160, 210, 50], "quantity": 1})";
  Conversation talk({reply_saying(many + "]}"), reply_saying(good_plan)});
  const auto plan = talk.make_plan();
  REQUIRE(plan);
  CHECK(plan->items.front().category == "desk");
  CHECK(contains_text(talk.question(1), "m2 of floor"));
}

TEST_CASE("What is shown and kept depends on the mode") {
  ModelDesignerOptions options;
  options.encode_picture = [](const Image&) { return Result<std::string>("PNG"); };
  for (const auto mode : {ModelMode::constraints, ModelMode::image, ModelMode::fused}) {
    options.mode = mode;
    Conversation talk({reply_saying(good_place)}, options);
    const auto advice = talk.place();
    REQUIRE(advice);
    const auto& question = talk.script->questions.front();
    CHECK(question.messages.back().images.size() == (mode == ModelMode::constraints ? 0 : 1));
    CHECK(advice->location.has_value() == (mode == ModelMode::fused));
    CHECK(advice->yaw.has_value() == (mode == ModelMode::fused));
    CHECK(question.schema["properties"].contains("location") == (mode == ModelMode::fused));
    std::string words;
    for (const auto& message : question.messages) words += message.text;
    CHECK(contains_text(words, "picture") == (mode != ModelMode::constraints));
    CHECK(contains_text(words, "\"location\"") == (mode == ModelMode::fused));
    CHECK(contains_text(words, "(2, 2.6)") == (mode != ModelMode::constraints));  // the desk's place
    CHECK_FALSE(advice->relations.empty());
  }
}

TEST_CASE("In the paper's frame coordinates are told and read from the top right corner") {
  ModelDesignerOptions options;
  options.paper_frame = true;
  Conversation talk({reply_saying(R"({"constraints": "middle", "location": [1.0, 0.5]})")},
                    options);
  const auto advice = talk.place({"it was full"}, {{Vec2(0, 0), Vec2(1, 2)}});
  REQUIRE(advice);
  REQUIRE(advice->location);
  CHECK((*advice->location - Vec2(3.5, 2.0)).norm() < 1e-9);
  // The desk at (2, 2.6): 0.4 m from the top, 2 m from the right.
  CHECK(contains_text(talk.question(0), "(0.4, 2)"));
  CHECK(contains_text(talk.question(0), "2 x 1 about (2, 3.5)"));
}

TEST_CASE("A refusal is told with what floor is left") {
  Conversation talk({reply_saying(good_place)});
  REQUIRE(talk.place({"desk-0 was in the way"}, {{Vec2(0.2, 0.4), Vec2(1.4, 1.4)}}));
  CHECK(contains_text(talk.question(0), "desk-0 was in the way"));
  CHECK(contains_text(talk.question(0), "1.2 x 1 about (0.8, 0.9)"));
}

TEST_CASE("Constraints that do not hold are marked as such") {
  Conversation talk({reply_saying(good_place)});
  talk.scene.objects[0].relations = *parse_relations("edge | middle");
  REQUIRE(talk.place());
  CHECK(contains_text(talk.question(0), "edge | middle (does not hold)"));
}

TEST_CASE("What of an answer could not be followed is asked about with that answer") {
  Conversation talk({reply_saying(good_place)});
  PlaceRequest request{talk.plan, talk.scene, talk.planned, talk.chair};
  PlaceAdvice before;
  before.relations = *parse_relations("near, desk-0");
  before.location = Vec2(0.5, 0.5);
  request.earlier = {before};
  request.objections = {"it stands 1.20 m from the suggested place"};
  request.standing_at = Vec2(1.5, 1.2);
  REQUIRE(talk.designer->place(request));
  CHECK(contains_text(talk.question(0), "near, desk-0; at (0.5, 0.5)"));
  CHECK(contains_text(talk.question(0), "it stands 1.20 m from the suggested place"));
  CHECK(contains_text(talk.question(0), "(1.5, 1.2)"));
}

TEST_CASE("The model chooses what comes next only when it may") {
  const std::string answer =
      R"({"constraints": "middle", "location": [2, 1], "next": "Floor_Lamp 0"})";
  ModelDesignerOptions options;
  Conversation planned({reply_saying(answer)}, options);
  CHECK(planned.place()->next.empty());
  CHECK_FALSE(contains_text(planned.question(0), "\"next\""));
  options.chooses_order = true;
  Conversation chosen({reply_saying(answer)}, options);
  CHECK(chosen.place()->next == "floor lamp-0");
  CHECK(contains_text(chosen.question(0), "chair-1, floor lamp-0"));
  Conversation unknown({reply_saying(R"({"constraints": "middle", "next": "throne-0"})")}, options);
  const auto advice = unknown.place();
  CHECK(advice->next.empty());
  CHECK(contains_text(advice->consultation.notes.back(), "next"));
}

TEST_CASE("When the budget is spent the designer says so instead of asking") {
  ModelDesignerOptions options;
  options.budget_is_spent = [] { return true; };
  Conversation talk({failure(Error::Kind::limit)}, options);
  const auto advice = talk.place();
  REQUIRE_FALSE(advice);
  CHECK(advice.error().kind == Error::Kind::limit);
}

TEST_CASE("An answer in plain words is read when it holds a list of constraints") {
  Conversation talk(
      {reply_saying("I think it goes by the desk.\n\n**Constraints:** middle | near, "
                    "desk-0 | face to, desk-0\nat (2.0, 1.8)\n")});
  const auto advice = talk.place();
  REQUIRE(advice);
  CHECK(advice->consultation.calls == 1);
  CHECK(advice->relations.size() == 3);
  REQUIRE(advice->location);
  CHECK((*advice->location - Vec2(2.0, 1.8)).norm() < 1e-9);
}

namespace {

PlanItem cups_on_desk(int quantity) {
  PlanItem cup;
  cup.category = "cup";
  cup.mount = Mount::surface;
  cup.on = "desk-0";
  cup.quantity = quantity;
  return cup;
}

}  // namespace

TEST_CASE("Small things of one carrier are asked for at once") {
  Conversation talk({reply_saying(
      R"({"constraints": "on, desk-0", "location": [1.8, 2.6], "others": [)"
      R"({"id": "cup-1", "constraints": "on, desk-0", "location": [2.3, 2.5], "facing": null}]})")});
  talk.plan.items = {cups_on_desk(2)};
  Object first = rooms::thing("cup-0", "cup", {0.1, 0.1, 0.1});
  first.mount = Mount::surface;
  const PlannedObject one{"cup-0", 0, 0}, other{"cup-1", 0, 1};
  PlaceRequest request{talk.plan, talk.scene, one, first};
  request.later = {"cup-1"};
  REQUIRE(talk.designer->place(request));
  CHECK(contains_text(talk.question(0), "cup-1"));
  Object second = first;
  second.id = "cup-1";
  const PlaceRequest next{talk.plan, talk.scene, other, second};
  const auto advice = talk.designer->place(next);
  REQUIRE(advice);
  CHECK(advice->location->isApprox(Vec2(2.3, 2.5)));
  CHECK(advice->consultation.calls == 0);
  CHECK(talk.script->questions.size() == 1);
}

TEST_CASE("Small things that get no places stand in a row along what carries them, as answered") {
  Conversation talk({reply_saying(R"({"constraints": "on, desk-0", "others": [)"
                                  R"({"id": "cup-3", "constraints": "on, desk-0", "location": []},)"
                                  R"({"id": "cup-1", "constraints": "on, desk-0", "location": [2.6, 2.7]},)"
                                  R"({"id": "cup-2", "constraints": "on, desk-0"}]})")});
  talk.plan.items = {cups_on_desk(4)};
  std::map<std::string, PlaceAdvice> answers;
  for (int number = 0; number < 4; ++number) {
    Object object = rooms::thing("cup-" + std::to_string(number), "cup", {0.1, 0.1, 0.1});
    object.mount = Mount::surface;
    const PlannedObject planned{object.id, 0, number};
    PlaceRequest request{talk.plan, talk.scene, planned, object};
    request.later = {"cup-1", "cup-2", "cup-3"};
    const auto advice = talk.designer->place(request);
    REQUIRE(advice);
    REQUIRE(advice->location);
    answers[object.id] = *advice;
  }
  CHECK(talk.script->questions.size() == 1);
  CHECK_FALSE(answers["cup-1"].spread);
  double before = 2.0 - 0.7;  // the desk's left end
  for (const char* id : {"cup-0", "cup-3", "cup-2"}) {
    INFO(id);
    CHECK(answers[id].spread);
    CHECK(answers[id].location->x() - before == Approx(id == std::string("cup-0") ? 1.4 / 6 : 1.4 / 3));
    CHECK(answers[id].location->y() == Approx(2.6));
    before = answers[id].location->x();
  }
}
