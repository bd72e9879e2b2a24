// Both protocols against a server that checks what it gets.
#include <nlohmann/json.hpp>

#include "asking.h"
#include "base/sha256.h"
#include "catch.h"
#include "roomgen/base/json.h"

using namespace roomgen;

namespace {

// The smallest PNG: one transparent pixel.
const std::string pixel(
    "\x89PNG\r\n\x1a\n"
    "\0\0\0\rIHDR\0\0\0\x01\0\0\0\x01\x08\x06\0\0\0\x1f\x15\xc4\x89"
    "\0\0\0\x0bIDATx\x9c\x63\x60\0\x02\0\0\x05\0\x01\x7a\x5e\xab\x3f"
    "\0\0\0\0IEND\xae\x42\x60\x82",
    68);

ChatRequest question_with_image() {
  ChatRequest request = question();
  request.messages.back().images = {pixel};
  return request;
}

}  // namespace

TEST_CASE("A question goes out as OpenAI's protocol has it") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  CHECK(ask(quick_options(server.url("ok") + "/?api-version=3")).text() == "hello");
  const auto requests = server.requests();
  REQUIRE(requests.size() == 1);
  CHECK(requests[0]["path"] == "/ok/v1/chat/completions?api-version=3");
  CHECK(requests[0]["headers"]["authorization"] == "Bearer " + secret);
  CHECK(requests[0]["headers"]["content-type"] == "application/json");
  const Json& body = requests[0]["body"];
  CHECK(body["model"] == "tiny-1");
  CHECK(body["max_tokens"] == 100);
  CHECK(body["temperature"] == 0.0);
  CHECK(body["messages"].size() == 2);
  CHECK(body["messages"][0]["role"] == "system");
  CHECK(body["messages"][1]["content"] == "Where does the bed go?");
  CHECK_FALSE(body.contains("response_format"));
}

TEST_CASE("A server on this machine is asked without a key") {
  REQUIRE_PYTHON();
  const Environment environment("");
  const Server server;
  CHECK(ask(quick_options(server.url("ok"))).text() == "hello");
  REQUIRE(server.requests().size() == 1);
  CHECK_FALSE(server.requests()[0]["headers"].contains("authorization"));
}

TEST_CASE("An image arrives as it was sent") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  CHECK(ask(quick_options(server.url("image")), question_with_image()).text() == sha256_hex(pixel));
}

TEST_CASE("A schema goes out as the form of the answer") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  const auto asked = ask(quick_options(server.url("schema")), question_with_schema());
  REQUIRE(asked.ok());
  const auto form = Json::parse(asked.text());
  CHECK(form["type"] == "json_schema");
  CHECK(form["json_schema"]["name"] == "answer");
  CHECK(form["json_schema"]["strict"] == true);
  CHECK(form["json_schema"]["schema"]["required"][0] == "size");
}

TEST_CASE("An endpoint without eyes says so once, and keeps its schema") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  auto request = question_with_image();
  request.schema = question_with_schema().schema;
  const auto asked = ask(quick_options(server.url("no-pictures")), request);
  REQUIRE_FALSE(asked.ok());
  CHECK(asked.reply.error().kind == Error::Kind::invalid_input);
  CHECK(server.count() == 1);
}

TEST_CASE("An event stream that nobody asked for is read") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  CHECK(ask(quick_options(server.url("stream"))).text() == "hello");
}

TEST_CASE("What an endpoint refuses is left out, and not tried again") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  const auto [scenario, option] =
      GENERATE(table<std::string, std::string>({{"no-schema", "response_format"},
                                                {"no-grammar", "response_format"},
                                                {"no-old-limit", "max_tokens"},
                                                {"no-temperature", "temperature"}}));
  const auto model = make_http_model(quick_options(server.url(scenario)));
  REQUIRE(model);
  const auto first = ask(**model, question_with_schema());
  const auto second = ask(**model, question_with_schema());
  CHECK(first.text() == "hello");
  CHECK(second.text() == "hello");
  REQUIRE(first.ok());
  CHECK(first.reply->attempts == 2);
  const auto requests = server.requests();
  REQUIRE(requests.size() == 3);
  CHECK(requests[0]["body"].contains(option));
  CHECK_FALSE(requests[1]["body"].contains(option));
  CHECK_FALSE(requests[2]["body"].contains(option));
  CHECK(requests[1]["body"].contains("max_completion_tokens") == (option == "max_tokens"));
}

TEST_CASE("Thinking is asked for in OpenAI's words, beside the answer, and given up where it is unknown") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  ChatRequest request = question();
  request.thinking = 4000;
  CHECK(ask(quick_options(server.url("ok")), request).text() == "hello");
  const auto model = make_http_model(quick_options(server.url("no-thinking")));
  REQUIRE(model);
  CHECK(ask(**model, request).text() == "hello");
  CHECK(ask(**model, request).text() == "hello");
  const auto requests = server.requests();
  REQUIRE(requests.size() == 4);
  CHECK(requests[0]["body"]["reasoning_effort"] == "medium");
  CHECK(requests[0]["body"]["max_tokens"] == request.max_tokens + 4000);
  for (const std::size_t later : {2u, 3u}) {
    CHECK_FALSE(requests[later]["body"].contains("reasoning_effort"));
    CHECK(requests[later]["body"]["max_tokens"] == request.max_tokens);
  }
}

TEST_CASE("With Anthropic thinking has a budget of its own, and a schema is offered") {
  REQUIRE_PYTHON();
  const Environment environment("ANTHROPIC_API_KEY");
  const Server server;
  auto options = quick_options(server.url("anthropic"));
  options.protocol = ChatProtocol::anthropic;
  ChatRequest request = question_with_schema();
  request.thinking = 100;
  ask(options, request);
  const auto requests = server.requests();
  REQUIRE(requests.size() == 1);
  const Json& body = requests[0]["body"];
  CHECK(body["thinking"] == Json({{"type", "enabled"}, {"budget_tokens", 1024}}));
  CHECK(body["max_tokens"] == request.max_tokens + 1024);
  CHECK_FALSE(body.contains("temperature"));
  CHECK(body["tool_choice"]["type"] == "auto");
}

TEST_CASE("A question goes out as Anthropic's protocol has it") {
  REQUIRE_PYTHON();
  const Environment environment("ANTHROPIC_API_KEY");
  const Server server;
  auto options = quick_options(server.url("anthropic"));
  options.protocol = ChatProtocol::anthropic;
  const auto asked = ask(options);
  CHECK(asked.text() == "You furnish rooms.");
  REQUIRE(asked.ok());
  CHECK(asked.reply->input_tokens == 21);
  CHECK(asked.reply->output_tokens == 4);
  const auto requests = server.requests();
  REQUIRE(requests.size() == 1);
  CHECK(requests[0]["path"] == "/anthropic/v1/messages");
  CHECK(requests[0]["headers"]["x-api-key"] == secret);
  CHECK_FALSE(requests[0]["headers"].contains("authorization"));
}

TEST_CASE("With Anthropic a schema is a tool, and its input the answer") {
  REQUIRE_PYTHON();
  const Environment environment("ANTHROPIC_API_KEY");
  const Server server;
  auto options = quick_options(server.url("anthropic"));
  options.protocol = ChatProtocol::anthropic;
  CHECK(ask(options, question_with_schema()).text() == R"({"size":[4,3]})");
}

TEST_CASE("With Anthropic an image arrives as it was sent") {
  REQUIRE_PYTHON();
  const Environment environment("ANTHROPIC_API_KEY");
  const Server server;
  auto options = quick_options(server.url("anthropic-image"));
  options.protocol = ChatProtocol::anthropic;
  CHECK(ask(options, question_with_image()).text() == sha256_hex(pixel));
}
