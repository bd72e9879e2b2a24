#include <nlohmann/json.hpp>

#include "wire.h"

#include "asking.h"
#include "byte_text.h"
#include "catch.h"
#include "roomgen/base/json.h"
#include "support/contains.h"
#include "support/error_of.h"
#include "byte_text.h"

using namespace roomgen;

namespace {

Result<ChatReply> openai_reply(const char* text) {
  return read_openai_reply(Json::parse(text), "there");
}

Result<ChatReply> anthropic_reply(const char* text) {
  return read_anthropic_reply(Json::parse(text), "there");
}

}  // namespace

TEST_CASE("Base64 pads to whole groups") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe") == "//4=");
}

TEST_CASE("Only whole and shortest UTF-8 counts") {
  for (const char* text : {"", "bed", "Küche", "€", "🛏"}) CHECK(is_utf8(text));
  for (const char* text :
       {"\xff", "\xc3", "\xc0\xaf", "\xe2\x82", "\xed\xa0\x80", "\xf5\x80\x80\x80"})
    CHECK_FALSE(is_utf8(text));
}

TEST_CASE("An excerpt is one line of whole characters") {
  CHECK(excerpt("a\r\n\tb", 10) == "a b");
  CHECK(excerpt("abcdef", 3) == "abc…");
  CHECK(excerpt("a\xff"
                "b",
                10) == "a?b");
  CHECK(excerpt("aü", 2) == "a…");
}

TEST_CASE("Only a schema that OpenAI takes as strict is sent as one") {
  ChatRequest request = question_with_schema();
  const Dialect all;
  CHECK(openai_body(request, "m", all)["response_format"]["json_schema"].contains("strict"));
  request.schema.erase("additionalProperties");
  CHECK_FALSE(openai_body(request, "m", all)["response_format"]["json_schema"].contains("strict"));
}

TEST_CASE("Questions that are no UTF-8 still make a body") {
  const auto body = openai_body(question("\xff"), "m", {});
  CHECK_NOTHROW(body.dump(-1, ' ', false, Json::error_handler_t::replace));
}

TEST_CASE("Content may come in parts, and counts may be missing") {
  const auto reply = openai_reply(
      R"({"choices": [{"message": {"content": [{"type": "text", "text": "be"}, {"text": "d"}]}}]})");
  REQUIRE(reply);
  CHECK(reply->text == "bed");
  CHECK(reply->input_tokens == 0);
}

TEST_CASE("A refusal is told in the model's words") {
  CHECK(contains_text(
      error_of(openai_reply(
          R"({"choices": [{"message": {"content": null, "refusal": "I will not"}}]})")),
      "declined to answer: I will not"));
  CHECK(contains_text(error_of(anthropic_reply(R"({"content": [], "stop_reason": "refusal"})")),
                      "declined to answer"));
}

TEST_CASE("Answers of the wrong shape are located") {
  CHECK(contains_text(error_of(openai_reply("[]")), "there: "));
  CHECK(
      contains_text(error_of(openai_reply(R"({"choices": [{}]})")), "/choices/0/message: missing"));
  CHECK(contains_text(error_of(openai_reply(R"({"choices": 3})")), "/choices: "));
  CHECK(contains_text(error_of(anthropic_reply("{}")), "/content: missing"));
  CHECK(contains_text(error_of(anthropic_reply(R"({"content": [{"type": "text", "text": 1}]})")),
                      "/content/0/text: expected a text"));
}

TEST_CASE("An answer that was cut off says so, and is an error when nothing came before the cut") {
  const auto anthropic = anthropic_reply(
      R"({"content": [{"type": "text", "text": "a"}], "stop_reason": "max_tokens"})");
  REQUIRE(anthropic);
  CHECK(anthropic->cut_off);
  const auto openai = openai_reply(
      R"({"choices": [{"message": {"content": "a"}, "finish_reason": "length"}]})");
  REQUIRE(openai);
  CHECK(openai->cut_off);
  CHECK_FALSE(openai_reply(R"({"choices": [{"message": {"content": "a"}, "finish_reason": "stop"}]})")
                  ->cut_off);
  const auto silent = openai_reply(
      R"({"choices": [{"message": {"content": ""}, "finish_reason": "length"}]})");
  REQUIRE_FALSE(silent);
  CHECK(contains_text(silent.error().message, "cut off"));
}

TEST_CASE("An answer may be in the call of a tool, or all of it be taken for thinking") {
  const auto tool = openai_reply(
      R"({"choices": [{"message": {"content": null, "tool_calls": [{"function": {"arguments": "{}"}}]}}]})");
  REQUIRE(tool);
  CHECK(tool->text == "{}");
  const auto thought = openai_reply(
      R"({"choices": [{"message": {"content": "", "reasoning_content": "{}"}, "finish_reason": "stop"}]})");
  REQUIRE(thought);
  CHECK(thought->text == "{}");
  CHECK_FALSE(openai_reply(
      R"({"choices": [{"message": {"content": "", "reasoning_content": "{"}, "finish_reason": "length"}]})"));
}

TEST_CASE("The endpoint's complaint is found in all its forms") {
  CHECK(complaint_in(R"({"error": {"message": "no"}})") == "no");
  CHECK(complaint_in(R"({"error": "no"})") == "no");
  CHECK(complaint_in(R"({"detail": "no"})") == "no");
  CHECK(complaint_in(R"([{"error": {"message": "no"}}])") == "no");
  CHECK(complaint_in("no\n") == "no");
  CHECK(complaint_in("<html>no</html>") == "");
  CHECK(complaint_in(std::string(1000, 'n')).size() < 310);
}

TEST_CASE("An endpoint is conceded one option at a time, until none is left") {
  const auto request = question_with_schema();
  std::optional<Dialect> dialect = Dialect();
  dialect = concede(*dialect, request, "Unsupported parameter: 'max_tokens'");
  REQUIRE(dialect);
  CHECK(dialect->token_limit == Dialect::TokenLimit::max_completion_tokens);
  dialect = concede(*dialect, request, "Temperature is not supported; max_tokens neither");
  REQUIRE(dialect);
  CHECK_FALSE(dialect->temperature);
  CHECK(dialect->schema);
  dialect = concede(*dialect, request, "Bad Request");
  REQUIRE(dialect);
  CHECK_FALSE(dialect->schema);
  CHECK_FALSE(concede(*dialect, request, "Bad Request"));
  CHECK_FALSE(concede(Dialect(), question(), "Bad Request"));
}
