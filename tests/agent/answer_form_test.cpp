// What servers put around an answer.
#include "answer_form.h"

#include <nlohmann/json.hpp>

#include "catch.h"
#include "wire.h"
#include "roomgen/base/json.h"

using namespace roomgen;

namespace {

// What a body says once it is read as OpenAI's protocol has it; "" if nothing.
std::string said(std::string_view body) {
  const auto json = parse_json(plain_json(body), "");
  if (!json) return {};
  const auto reply = read_openai_reply(*json, "there");
  return reply ? reply->text : "";
}

int status_of(int status, const char* body) {
  HttpAnswer answer;
  answer.status = status;
  answer.body = body;
  return as_meant(answer).status;
}

}  // namespace

TEST_CASE("An answer is found behind comments, and put together from a stream") {
  const std::string whole = R"({"choices": [{"message": {"content": "bed"}}]})";
  const auto piece = [](const std::string& delta) {
    return "data: {\"choices\": [{\"delta\": " + delta + "}]}\r\n\r\n";
  };
  CHECK(said(whole) == "bed");
  CHECK(said("\n: PROCESSING\n\n: PROCESSING\n\n" + whole) == "bed");
  CHECK(said("data: " + whole + "\n\ndata: [DONE]\n") == "bed");
  CHECK(said(piece(R"({"role": "assistant"})") + piece(R"({"content": "b"})") + ": ping\n" +
             piece(R"({"content": "ed"})") + "data: [DONE]\n\n") == "bed");
  CHECK(said(piece(R"({"content": null, "reasoning_content": "bed"})")) == "bed");
  CHECK(said("data: {\"choices\": [{\"del").empty());
  CHECK(said("data: [DONE]\n").empty());
}

TEST_CASE("A stream keeps its usage and why it ended") {
  const auto json = Json::parse(plain_json(
      "data: {\"choices\": [{\"delta\": {\"content\": \"a\"}, \"finish_reason\": \"length\"}]}\n"
      "data: {\"choices\": [], \"usage\": {\"prompt_tokens\": 7, \"completion_tokens\": 2}}\n"));
  const auto reply = read_openai_reply(json, "there");
  REQUIRE(reply);
  CHECK(reply->cut_off);
  CHECK(reply->input_tokens == 7);
  CHECK(reply->output_tokens == 2);
}

TEST_CASE("A failure within an answer is one, by its code") {
  CHECK(status_of(200, R"({"error": {"code": 429}})") == 429);
  CHECK(status_of(200, "data: {\"error\": {\"code\": 503}}\n\n") == 503);
  CHECK(status_of(200, R"({"error": {"code": "busy"}})") == 200);
  CHECK(status_of(200, R"({"error": null})") == 200);
  CHECK(status_of(500, R"({"error": {"code": 429}})") == 500);
  CHECK(status_of(200, "[1]") == 200);
}
