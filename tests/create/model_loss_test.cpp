#include "conversation.h"

using namespace conversation;

namespace {

Error failure(Error::Kind kind) {
  return {kind, "the line is dead"};
}

}  // namespace

TEST_CASE("A model that was never reached is an error, one that is lost later is replaced") {
  Conversation never({failure(Error::Kind::unavailable)});
  const auto verdict = never.maker->classify("a stool");
  REQUIRE_FALSE(verdict);
  CHECK(verdict.error().kind == Error::Kind::unavailable);

  Conversation later({reply_saying(R"({"passes": true, "reason": "a stool"})"),
                      failure(Error::Kind::unavailable)});
  REQUIRE(later.maker->classify("a stool"));
  CHECK(later.maker->decompose("a stool")->front().noun == "box");
  CHECK(later.generate()->name == "box");
  CHECK(later.script->questions.size() == 2);
  CHECK(mentions(later.maker->take_notes(), "rules take over: the line is dead"));
}

TEST_CASE("After three failures in a row the model is given up") {
  Conversation talk({failure(Error::Kind::io), failure(Error::Kind::io),
                     failure(Error::Kind::io), reply_saying(good_stool)});
  for (int k = 0; k < 5; ++k) CHECK(talk.generate()->name == "box");
  CHECK(talk.script->questions.size() == 3);

  // What ran out of time has kept everybody waiting.
  Conversation slow({failure(Error::Kind::io), failure(Error::Kind::limit), reply_saying(good_stool)});
  for (int k = 0; k < 3; ++k) CHECK(slow.generate()->name == "box");
  CHECK(slow.script->questions.size() == 2);

  Conversation between({failure(Error::Kind::io), failure(Error::Kind::io),
                        reply_saying(good_stool), failure(Error::Kind::io)});
  for (const char* name : {"box", "box", "stool", "box"}) CHECK(between.generate()->name == name);
}

TEST_CASE("Whoever cancels gets no other answer") {
  Conversation talk({failure(Error::Kind::cancelled)});
  const auto program = talk.generate();
  REQUIRE_FALSE(program);
  CHECK(program.error().kind == Error::Kind::cancelled);
}

TEST_CASE("When the budget is spent the maker says so") {
  ModelMakerOptions options;
  options.budget_is_spent = [] { return true; };
  Conversation talk({failure(Error::Kind::limit)}, options);
  const auto program = talk.generate();
  REQUIRE_FALSE(program);
  CHECK(program.error().kind == Error::Kind::limit);
}
