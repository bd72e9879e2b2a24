#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "brief/prompt.h"
#include "brief/said_wish.h"
#include "catch.h"
#include "roomgen/design/designer.h"
#include "support/contains.h"
#include "support/scripted_model.h"

using namespace roomgen;

namespace {

// A thing of a form as a model writes it: what is not given is left out.
Json thing(const std::string& id, const std::string& name, int count,
           std::vector<std::string> words, std::vector<Json> relations = {},
           std::vector<std::string> count_words = {}) {
  return {{"id", id},
          {"name", name},
          {"count", count},
          {"words", words},
          {"count_words", count_words},
          {"relations", relations}};
}

Json relation(const std::string& name, const std::string& to, std::vector<std::string> words) {
  return {{"relation", name}, {"to", to}, {"words", words}};
}

struct Talk {
  explicit Talk(std::vector<std::string> answers, ModelReaderOptions options = {}) {
    std::vector<Result<ChatReply>> replies;
    for (const auto& answer : answers) replies.push_back(reply_saying(answer));
    script = make_script(std::move(replies));
    model = std::make_unique<ScriptedModel>(script);
    reader = make_model_reader(*model, Prompts::built_in(), KindTable::built_in(), options);
  }

  const brief::Brief& read(const std::string& prompt) {
    request.prompt = prompt;
    request.seed = 3;
    REQUIRE(reader->read(request));
    REQUIRE(request.said);
    return request.said->brief;
  }
  Plan plan() {
    const auto made = make_rule_designer()->plan(request);
    REQUIRE(made);
    return *made;
  }
  const std::string& question(std::size_t turn) const {
    return script->questions.at(turn).messages.back().text;
  }

  std::shared_ptr<ScriptedModel::Script> script;
  std::unique_ptr<ChatModel> model;
  std::unique_ptr<Reader> reader;
  PlanRequest request;
};

std::string clauses(const std::vector<Requirement>& requirements) {
  std::string text;
  for (const auto& requirement : requirements)
    text += (text.empty() ? "" : "; ") + requirement.clause;
  return text;
}

Heard::As heard_as(const std::vector<Heard>& heard, const std::string& prompt,
                   const std::string& word) {
  const auto at = prompt.find(word);
  for (const auto& words : heard)
    if (words.begin <= at && at < words.end) return words.as;
  return Heard::As::not_understood;
}

}  // namespace

TEST_CASE("The ledger is what the model read, and nothing that rules would read besides") {
  const std::string prompt =
      "Ein Schlafzimmer: zwei rote Stühle AM Tisch, kein Teppich, bitte. Zwei Lampen!";
  const Json form = {
      {"room", {{"type", "bedroom"}, {"words", {"schlafzimmer"}}}},
      {"things",
       {thing("t1", "chair", 2, {"Stühle"}, {relation("around", "t2", {"am tisch"})}, {"zwei"}),
        thing("t2", "table", 1, {"Tisch"})}},
      {"absences", {{{"name", "rug"}, {"words", {"kein teppich"}}}}},
      {"talk", {{{"as", "talk"}, {"words", {"bitte"}}}}}};
  Json read = form;
  read["things"][0]["looks"] = {{{"look", "red"}, {"words", {"rote"}}}};
  Talk talk({read.dump()});
  talk.read(prompt);
  CHECK(talk.script->questions.size() == 1);
  const Plan plan = talk.plan();
  CHECK(clauses(plan.requirements) ==
        "2 chair; red chair; chair around table; a table; no rug; a bedroom");
  CHECK(heard_as(plan.heard, prompt, "rote") == Heard::As::attribute);
  CHECK(heard_as(plan.heard, prompt, "bitte") == Heard::As::room);
  CHECK(heard_as(plan.heard, prompt, "Lampen") == Heard::As::not_understood);
}

TEST_CASE("What a picture shows is read as words of the wish, and its requirements say so") {
  const Json form = {
      {"pictures", {{{"says", "A bedroom with a\nblue bed and a desk."}, {"scale", "the door is 0.9 m"}}}},
      {"room", {{"type", "bedroom"}, {"words", {"bedroom"}}}},
      {"things", {thing("t1", "bed", 1, {"bed"}), thing("t2", "desk", 1, {"desk #1", "desk #2"})}},
      {"absences", {{{"name", "rug"}, {"words", {"no rug"}}}}}};
  Json looks = form;
  looks["things"][0]["looks"] = {{{"look", "blue"}, {"words", {"blue"}}}};
  Talk talk({looks.dump()});
  talk.request.pictures = {"a PNG"};
  talk.read("a desk, no rug");
  CHECK(talk.script->questions[0].messages.back().images == talk.request.pictures);
  CHECK(talk.request.prompt == "a desk, no rug\nImage 1: A bedroom with a blue bed and a desk.");
  const Plan plan = talk.plan();
  std::string told_all;
  for (const auto& requirement : plan.requirements) told_all += told(requirement) + "; ";
  CHECK(told_all == "a bed (image 1); blue bed (image 1); a desk; no rug; a bedroom (image 1); ");
  for (const auto& words : plan.heard) CHECK(words.as != Heard::As::not_understood);
  const Json brief = *brief_json(talk.request);
  CHECK(brief["things"][0]["source"] == "image 1");
  CHECK_FALSE(brief["things"][1].contains("source"));
  CHECK(brief["room"]["source"] == "image 1");

  Talk blind({R"({"room": {"type": "bedroom", "words": []}, "things": []})"}, {.answers = 1});
  blind.request.pictures = {"a PNG"};
  const auto status = blind.reader->read(blind.request);
  REQUIRE_FALSE(status);
  CHECK(contains_text(status.error().message, "what image 1 shows"));
}

TEST_CASE(
    "Words are found where they are said of the thing, and the n-th time where that is told") {
  const std::string prompt = "A study with a red chair, a red table and a red chair by the window.";
  Json form = {
      {"room", {{"type", "study"}, {"words", {"study"}}}},
      {"things",
       {thing("t1", "chair", 1, {"chair"}), thing("t2", "table", 1, {"table"}),
        thing("t3", "chair", 1, {"chair"}, {relation("near", "window", {"by the window"})})}}};
  for (auto& one : form["things"]) one["looks"] = {{{"look", "red"}, {"words", {"red"}}}};
  form["things"].push_back(thing("t4", "chair", 1, {"chair #1"}));
  Talk talk({form.dump()});
  const brief::Brief& brief = talk.read(prompt);
  REQUIRE(brief.mentions.size() == 4);
  const auto first_word = [&](std::size_t mention, Heard::As as) {
    for (const std::size_t heard : brief.mentions[mention].heard)
      if (brief.heard[heard].as == as)
        return brief.tokens[brief.heard[heard].tokens.begin].span.begin;
    return 0u;
  };
  CHECK(first_word(0, Heard::As::thing) == prompt.find("chair"));
  CHECK(first_word(2, Heard::As::thing) == prompt.rfind("chair"));
  CHECK(first_word(3, Heard::As::thing) == prompt.find("chair"));
  CHECK(first_word(1, Heard::As::attribute) == prompt.find("red table"));
  CHECK(first_word(2, Heard::As::attribute) == prompt.rfind("red"));
}

TEST_CASE("What cannot be read is told once with its place, and the rest counts") {
  const std::string prompt = "A study with many chairs hugging a desk";
  Json form = {{"room", {{"type", "study"}, {"words", {"study"}}}},
               {"things",
                {thing("t1", "chair", 0, {"chairs"}, {relation("hugging", "t2", {"hugging"})}),
                 thing("t2", "desk", 1, {"desk"}, {relation("near", "t9", {"a desk"})}),
                 thing("t3", "unicorn", 1, {"unicorn"})}}};
  form["things"][0]["count"] = "many";
  Talk talk({form.dump(), form.dump()});
  const brief::Brief& brief = talk.read(prompt);
  CHECK(talk.script->questions.size() == 2);
  for (const char* place : {"/things/0/relations/0/relation: \"hugging\"",
                            "/things/1/relations/0/to: \"t9\"", "/things/2/words: \"unicorn\""})
    CHECK(contains_text(talk.question(1), place));
  REQUIRE(brief.mentions.size() == 2);
  CHECK(brief.mentions[0].quantity > 1);
  CHECK_FALSE(talk.reader->consultation().fell_back);
}

TEST_CASE("What no clause can hold is kept in the wish's own words, and nobody is asked again") {
  const std::string prompt =
      "A small loft, a frosted window and a hatch, a scroll in the alcove, crates stacked 3 high";
  Json form = {{"room",
                {{"type", "loft"},
                 {"words", {"loft"}},
                 {"clauses", {{{"is", "proportion"}, {"name", "small"}, {"words", {"small"}}}}}}},
               {"openings",
                {{{"kind", "window"}, {"count", 1}, {"words", {"window"}}, {"remarks", {"frosted"}}},
                 {{"kind", "hatch"}, {"count", 1}, {"words", {"a hatch"}}}}},
               {"things",
                {thing("t1", "scroll", 1, {"scroll"}, {relation("in", "alcove", {"in the alcove"})}),
                 thing("t2", "crate", 0, {"crates"})}},
               {"remarks", {"stacked 3 high"}}};
  Talk talk({form.dump()});
  talk.read(prompt);
  CHECK(talk.script->questions.size() == 1);
  const Plan plan = talk.plan();
  for (const char* said : {"small", "frosted", "a hatch", "in the alcove", "stacked 3 high"}) {
    INFO(said);
    CHECK(std::any_of(plan.requirements.begin(), plan.requirements.end(),
                      [&](const Requirement& one) { return one.clause == said; }));
  }
}

TEST_CASE("Where the model gives no reading rules read, and the plan says so") {
  for (const std::string& answer :
       {std::string("A lovely room!"), std::string("{}"), std::string(5000, '['),
        std::string(
            R"({"things": 7, "room": [[[]]], "openings": "no", "people": {"count": {}}})")}) {
    INFO(answer.substr(0, 60));
    Talk talk({answer, answer});
    talk.read("a study with a desk");
    CHECK(talk.reader->consultation().fell_back);
    const Plan plan = talk.plan();
    CHECK(clauses(plan.requirements) == "a desk; a study");
    CHECK(std::any_of(plan.notes.begin(), plan.notes.end(), [](const std::string& note) {
      return contains_text(note, "rules read it");
    }));
  }
  Talk strict({"no"}, {.no_fallback = true});
  strict.request.prompt = "a study";
  CHECK_FALSE(strict.reader->read(strict.request));
}

TEST_CASE("Half an answer is read as far as it goes, and nothing of it is shown again") {
  Json form = {{"room", {{"type", "study"}, {"words", {"study"}}}},
               {"things", {thing("t1", "desk", 1, {"desk"}), thing("t2", "chair", 1, {"chair"})}}};
  std::string half = form.dump();
  half.resize(half.find("chair"));
  Talk talk({});
  ChatReply cut = reply_saying(half);
  cut.cut_off = true;
  talk.script->answers = {cut, Error{Error::Kind::io, "the line is dead"}};
  const brief::Brief& brief = talk.read("a study with a desk and a chair");
  REQUIRE(brief.mentions.size() == 1);
  CHECK(brief.mentions[0].category == "desk");
  CHECK(talk.script->questions.size() == 2);
  for (const auto& message : talk.script->questions[1].messages)
    CHECK_FALSE(contains_text(message.text, half.substr(0, 30)));
  CHECK(contains_text(talk.question(1), "cut off"));
}

TEST_CASE("However much a model answers, a bounded number of things is read") {
  Json form = {{"room", {{"type", "study"}, {"words", {"study"}}}}, {"things", Json::array()}};
  for (int i = 0; i < 10'000; ++i)
    form["things"].push_back(thing("t" + std::to_string(i), "desk", 1'000'000, {"desks"},
                                   {relation("near", "t" + std::to_string(i + 1), {"desks"})}));
  Talk talk({form.dump(), form.dump()});
  const brief::Brief& brief = talk.read("a study with desks");
  CHECK(brief.mentions.size() <= 120);
  for (const auto& mention : brief.mentions) CHECK(mention.quantity <= 200);
}

TEST_CASE("Whatever a form holds, what is read of it is sound") {
  const std::string prompt =
      "a study with two red desks, each with a lamp on it, six chairs in two rows and a plant next "
      "to the door, no rug";
  const auto& kinds = *brief::built_in_room_kinds();
  const Json form = brief::to_json(brief::read_words(prompt, kinds, KindTable::built_in()), prompt);
  const Json junk = {nullptr,
                     -1,
                     1e300,
                     "",
                     "t1",
                     "walls #0",
                     "#",
                     Json::array(),
                     Json::object(),
                     true,
                     {{"words", "desks"}},
                     Json::array({Json::array()})};
  Random random(11);
  for (int i = 0; i < 400; ++i) {
    Json broken = form;
    for (int n = random.integer(1, 6); n > 0; --n) {
      Json* at = &broken;
      while (at->is_structured() && !at->empty() && (at == &broken || random.chance(0.8)))
        at = &*std::next(at->begin(), random.integer(0, static_cast<int>(at->size()) - 1));
      *at = junk[static_cast<std::size_t>(random.integer(0, static_cast<int>(junk.size()) - 1))];
    }
    const auto wish = brief::wish_from_json(broken, prompt, kinds, KindTable::built_in()).wish;
    for (const auto& words : wish.brief.heard) CHECK(words.tokens.end <= wish.brief.tokens.size());
    PlanRequest request;
    request.prompt = prompt;
    if (i % 40 == 0) {
      request.said = std::make_shared<const brief::SaidWish>(wish);
      if (const auto plan = make_rule_designer()->plan(request))
        CHECK(plan_from_json(to_json(*plan), "plan.json"));
    }
  }
}

TEST_CASE("Things for each, some of several, denials and limits are read") {
  const std::string prompt =
      "A dining room with six chairs, two of them red, a lamp on each of two tables, no plant next "
      "to the door, nothing else";
  Json each = relation("on", "t3", {"on each of"});
  each["each"] = 1;
  Json never = relation("next to", "door", {"next to the door"});
  never["denied"] = true;
  Json form = {
      {"room", {{"type", "dining room"}, {"words", {"dining room"}}}},
      {"things",
       {thing("t1", "chair", 6, {"chairs"}, {}, {"six"}),
        thing("t2", "chair", 2, {"chairs"}, {}, {"two of them"}),
        thing("t3", "table", 2, {"tables"}, {}, {"two #2"}),
        thing("t4", "lamp", 1, {"lamp"}, {each}), thing("t5", "plant", 1, {"plant"}, {never})}},
      {"limits", {{{"words", {"nothing else"}}}}}};
  form["things"][1]["some_of"] = "t1";
  form["things"][1]["looks"] = {{{"look", "red"}, {"words", {"red"}}}};
  Talk talk({form.dump()});
  talk.read(prompt);
  const std::string all = clauses(talk.plan().requirements);
  INFO(all);
  for (const char* clause :
       {"4 chair", "2 chair", "red chair", "2 lamp", "a lamp on each table",
        "plant not next to door-0", "nothing else"})
    CHECK(contains_text(all, clause));
}

TEST_CASE("Several rooms are planned each by its own reading") {
  const std::string prompt =
      "A flat: bedroom with a desk, kitchen with two stools, and a sauna off the bedroom with a "
      "bench.";
  const auto room = [](const std::string& type, std::vector<Json> things,
                       const std::string& from = "") {
    return Json{{"name", type},
                {"only_from", from},
                {"room", {{"type", type}, {"words", {type}}}},
                {"things", things}};
  };
  const Json form = {{"room", {{"type", "flat"}, {"words", {"flat"}}}},
                     {"rooms",
                      {room("bedroom", {thing("t1", "desk", 1, {"desk"})}),
                       room("kitchen", {thing("t1", "stool", 2, {"stools"}, {}, {"two"})}),
                       room("sauna", {thing("t1", "bench", 1, {"bench"})}, "bedroom")}}};
  Talk talk({form.dump(), form.dump()});
  talk.read(prompt);
  const auto designer = make_rule_designer();
  const auto plan = plan_dwelling(talk.request, *designer);
  REQUIRE(plan);
  REQUIRE(*plan);
  REQUIRE((*plan)->rooms.size() >= 3);
  CHECK((*plan)->rooms[2].room.type == "sauna");
  CHECK(contains_text(clauses((*plan)->rooms[1].requirements), "2 stool"));
  CHECK_FALSE(contains_text(clauses((*plan)->rooms[1].requirements), "desk"));
  CHECK(heard_as((*plan)->heard, prompt, "stools") == Heard::As::thing);
  CHECK(heard_as((*plan)->heard, prompt, "sauna") == Heard::As::room);
}

TEST_CASE("A model that designs is held to what was read, by the clause") {
  Json form = {
      {"room", {{"type", "study"}, {"words", {"Kammer"}}}},
      {"things",
       {thing("t1", "desk", 1, {"Pult"}), thing("t2", "chair", 2, {"Stühle"}, {}, {"zwei"})}}};
  const std::string lacking =
      R"({"room": {"type": "study", "size_m": [4, 3], "height_m": 2.6}, "excluded": [],
      "objects": [{"name": "desk", "description": "a desk", "size_cm": [140, 70, 75], "quantity": 1},
                  {"name": "chair", "description": "a chair", "size_cm": [50, 50, 90], "quantity": 1}]})";
  Talk talk({form.dump(), lacking, lacking});
  talk.read("Kammer mit Pult, zwei Stühle");
  const auto designer = make_model_designer(*talk.model, make_rule_designer(), Prompts::built_in(),
                                            KindTable::built_in());
  const auto plan = designer->plan(talk.request);
  REQUIRE(plan);
  CHECK(contains_text(talk.question(2), "r2: 2 chair: 1 of 2"));
  CHECK(clauses(plan->requirements) == "a desk; 2 chair; a study");
}
