#include <tuple>

#include "catch.h"
#include "roomgen/chat/chat_model.h"
#include "support/contains.h"
#include "support/scripted_model.h"

using namespace roomgen;

namespace {

std::unique_ptr<LimitedModel> limited(std::shared_ptr<ScriptedModel::Script> script,
                                      const ChatLimits& limits,
                                      const std::string& model = "gpt-4o") {
  auto made = make_limited_model(std::make_unique<ScriptedModel>(std::move(script)), limits,
                                 PriceTable::built_in(), model);
  REQUIRE(made);
  return *std::move(made);
}

std::shared_ptr<ScriptedModel::Script> many_answers(long long input, long long output) {
  return make_script({100, reply_saying("there", input, output)});
}

// Asks until a limit is met; the message, and how often it was asked.
std::pair<std::string, std::size_t> ask_on(const ChatLimits& limits, long long input,
                                           long long output) {
  const auto script = many_answers(input, output);
  const auto model = limited(script, limits);
  while (true) {
    const auto reply = model->chat(asking("bed?"));
    if (reply) continue;
    CHECK(reply.error().kind == Error::Kind::limit);
    return {reply.error().message, script->questions.size()};
  }
}

}  // namespace

TEST_CASE("Totals add up what was used") {
  const auto model = limited(many_answers(1000, 100), {});
  REQUIRE(model->chat(asking("bed?")));
  REQUIRE(model->chat(asking("bed?")));
  const ChatTotals& totals = model->totals();
  CHECK(totals.calls == 2);
  CHECK(totals.input_tokens == 2000);
  CHECK(totals.output_tokens == 200);
  CHECK(totals.seconds == Approx(0.5));
  REQUIRE(totals.dollars);
  CHECK(*totals.dollars == Approx((2000 * 2.5 + 200 * 10) / 1e6));
}

TEST_CASE("The call that would go beyond a limit is not made") {
  ChatLimits limits;
  limits.calls = 3;
  auto [message, calls] = ask_on(limits, 10, 10);
  CHECK(contains_text(message, "limit of 3 calls"));
  CHECK(calls == 3);

  limits = {};
  limits.tokens = 1000;  // each call takes 110, and is expected to take as much
  std::tie(message, calls) = ask_on(limits, 10, 100);
  CHECK(contains_text(message, "limit of 1000 tokens: 990 used so far"));
  CHECK(calls == 9);

  limits = {};
  limits.dollars = 0.01;  // each call takes 0.001025
  std::tie(message, calls) = ask_on(limits, 10, 100);
  CHECK(contains_text(message, "limit of 0.01 dollars: 0.0092 used so far"));
  CHECK(calls == 9);
}

TEST_CASE("An image counts before the call, as do long texts") {
  ChatLimits limits;
  limits.tokens = 1500;
  const auto model = limited(many_answers(10, 10), limits);
  CHECK(model->chat(asking("bed?")));
  auto request = asking("bed?");
  request.messages.back().images = {"PNG"};
  CHECK_FALSE(model->chat(request));
  CHECK_FALSE(model->chat(asking(std::string(6000, 'x'))));
}

TEST_CASE("A model that counts more than expected is expected to go on so") {
  ChatLimits limits;
  limits.tokens = 5000;
  const auto script = many_answers(2000, 10);
  const auto model = limited(script, limits);
  while (model->chat(asking("bed?"))) continue;
  CHECK(script->questions.size() == 2);
  CHECK(model->totals().input_tokens == 4000);
}

TEST_CASE("Answers without counts are estimated, failures count as calls") {
  const auto script =
      make_script({reply_saying(std::string(300, 'x'), 0, 0), Error{Error::Kind::io, "broken"},
                   Error{Error::Kind::limit, "cut off"}});
  const auto model = limited(script, {});
  CHECK(model->chat(asking("bed?")));
  CHECK(model->totals().output_tokens >= 100);
  CHECK(model->totals().input_tokens > 0);
  const long long before = model->totals().output_tokens;
  CHECK_FALSE(model->chat(asking("bed?")));
  CHECK(model->totals().output_tokens == before);
  CHECK_FALSE(model->chat(asking("bed?")));
  CHECK(model->totals().output_tokens == before + 100);
  CHECK(model->totals().calls == 3);
}

namespace {

// Sends as many requests for a question as it is granted, each of 10 and 100 tokens, and fails.
class Repeating final : public ChatModel {
 public:
  Result<ChatReply> chat(const ChatRequest& request) override {
    while (true) {
      if (auto status = request.meter.admit(); !status) return status.error();
      request.meter.count({10, 100, {}, 1.0});
    }
  }
};

}  // namespace

TEST_CASE("Requests that are repeated within a question count, and the bound holds between them") {
  LimitedModel model(std::make_unique<Repeating>(), {{}, 1000, {}}, Price{1.0, 1.0});
  CHECK_FALSE(model.chat(asking("bed?")));
  CHECK(model.refused());
  CHECK(model.totals().calls == 9);  // a tenth could go beyond 1000
  CHECK(model.totals().output_tokens == 900);
  CHECK(model.totals().seconds == 9.0);
  CHECK(*model.totals().dollars == Approx(990e-6));
}

TEST_CASE("Without a known price money cannot be limited, but all else can") {
  const auto script = many_answers(1, 1);
  ChatLimits limits;
  limits.dollars = 1;
  const auto refused = make_limited_model(std::make_unique<ScriptedModel>(script), limits,
                                          PriceTable::built_in(), "home-brew");
  REQUIRE_FALSE(refused);
  CHECK(contains_text(refused.error().message, "no price is known for the model \"home-brew\""));
  limits = {};
  limits.calls = 1;
  const auto model = limited(script, limits, "home-brew");
  CHECK(model->chat(asking("bed?")));
  CHECK_FALSE(model->totals().dollars);
}
