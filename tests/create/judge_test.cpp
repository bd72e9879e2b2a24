#include "roomgen/create/maker.h"

#include "conversation.h"

using namespace conversation;

namespace {

const std::string good_scores =
    R"({"structure": {"reason": "all parts meet", "points": 5},
        "realism": {"reason": "plain edges", "points": 3},
        "alignment": {"reason": "three legs as said", "points": 4}})";

Result<Scores> judged(ScriptedModel& model) {
  return judge(model, Prompts::built_in(), "a stool of three legs", {"PNG-1", "PNG-2"});
}

}  // namespace

TEST_CASE("A judge sees the words and the views and gives points with reasons") {
  const auto script = make_script({reply_saying(good_scores)});
  ScriptedModel model(script);
  const auto scores = judged(model);
  REQUIRE(scores);
  CHECK(scores->structure.points == 5);
  CHECK(scores->realism.reason == "plain edges");
  CHECK(scores->mean() == 4.0);
  const auto& question = script->questions[0].messages.back();
  CHECK(question.images == std::vector<std::string>{"PNG-1", "PNG-2"});
  CHECK(contains_text(question.text, "a stool of three legs"));
}

TEST_CASE("Points are read in other words, too") {
  const auto script = make_script({reply_saying(
      R"(My view: {"structural_coherence": "4/5", "visual realism": {"score": "2 points"},
                  "prompt alignment": 1})")});
  ScriptedModel model(script);
  const auto scores = judged(model);
  REQUIRE(scores);
  CHECK(scores->structure.points == 4);
  CHECK(scores->realism.points == 2);
  CHECK(scores->alignment.points == 1);
}

TEST_CASE("Points out of range are asked for again") {
  const auto script =
      make_script({reply_saying(R"({"structure": 7, "realism": 3, "alignment": 3})"),
                   reply_saying(good_scores)});
  ScriptedModel model(script);
  REQUIRE(judged(model));
  CHECK(contains_text(script->questions[1].messages.back().text, "/structure"));
}

TEST_CASE("Without scores or pictures there is no judgement") {
  const auto script = make_script({reply_saying("nice"), reply_saying("nice"), reply_saying("{}")});
  ScriptedModel model(script);
  const auto scores = judged(model);
  REQUIRE_FALSE(scores);
  CHECK(scores.error().kind == Error::Kind::invalid_input);
  CHECK_FALSE(judge(model, Prompts::built_in(), "a stool", {}));
}
