#include <nlohmann/json.hpp>

#include "catch.h"
#include "mcp/about.h"
#include "mcp/input_schema.h"
#include "roomgen/base/file.h"
#include "support/contains.h"

using roomgen::Json;
using roomgen::mcp::check_input;

namespace {

Json tool(const std::string& name) {
  const Json about = roomgen::mcp::about();
  for (const auto& each : about["tools"])
    if (each["name"] == name) return each;
  FAIL("no tool " << name);
  return {};
}

std::string fault(const std::string& name, const std::string& arguments) {
  const auto status = check_input(tool(name)["inputSchema"], Json::parse(arguments));
  return status ? "" : status.error().message;
}

}  // namespace

TEST_CASE("Arguments that keep to a tool's schema are taken, others are told where they do not") {
  CHECK(fault("preview", R"({"room":"a","object":"desk-0","position":[1,2.5]})") == "");
  CHECK(contains_text(fault("preview", R"({"room":"a","object":"desk-0","position":[1]})"), "/position"));
  CHECK(contains_text(fault("preview", R"({"room":"a","object":"desk-0","position":[1,"2"]})"),
                      "/position/1: expected a number"));
  CHECK(contains_text(fault("preview", R"({"room":"a","object":"desk-0","position":[1,1e9]})"), "above"));
  CHECK(contains_text(fault("preview", R"({"room":7,"object":"desk-0","position":[1,2]})"), "/room: expected a text"));
  CHECK(contains_text(fault("preview", R"({"room":"a"})"), "\"object\" is missing"));
  CHECK(contains_text(fault("check", R"({"rom":"a"})"), "did you mean \"room\"?"));
  CHECK(contains_text(fault("check", R"([])"), "expected an object"));
  CHECK(contains_text(fault("render", R"({"room":"a","view":"side"})"), "\"iso\""));
  CHECK(contains_text(fault("render", R"({"room":"a","pixels":5000})"), "/pixels"));
  CHECK(contains_text(fault("undo", R"({"room":"a","steps":1.5})"), "a whole number"));
  CHECK(contains_text(fault("undo", R"({"room":"a","steps":-1})"), "below 1"));
  CHECK(contains_text(fault("edit", R"({"room":"a","operations":[{"do":"fly"}]})"), "/operations/0/do"));
  CHECK(contains_text(fault("edit", R"({"room":"a","operations":[]})"), "below 1"));
  CHECK(contains_text(fault("plan", R"({"prompt":""})"), "/prompt"));
}

TEST_CASE("Every tool says what it takes, and every member of that is explained") {
  const Json about = roomgen::mcp::about();
  CHECK(about["tools"].size() == 15);
  for (const auto& each : about["tools"]) {
    INFO(each["name"]);
    CHECK(each["description"].get<std::string>().size() > 20);
    CHECK(each["inputSchema"]["additionalProperties"] == false);
    for (const auto& [key, member] : each["inputSchema"]["properties"].items()) {
      INFO(key);
      CHECK(member.contains("description"));
      // Whole numbers are read as such: none may be larger than they can be.
      if (member.value("type", "") == "integer") CHECK(member.contains("maximum"));
    }
  }
}

TEST_CASE("Agents are told of every operation of an edit") {
  const auto text = roomgen::read_file(ROOMGEN_SOURCE_DIR "/docs/operation.schema.json");
  REQUIRE(text);
  const Json schema = Json::parse(*text), tool_schema = tool("edit")["inputSchema"]["properties"]["operations"];
  Json known = Json::array();
  for (const auto& each : schema["oneOf"]) known.push_back(each["properties"]["do"]["const"]);
  CHECK(tool_schema["items"]["properties"]["do"]["enum"] == known);
  for (const auto& each : schema["oneOf"])
    for (const auto& member : each["properties"].items()) {
      INFO(each["properties"]["do"]["const"] << " " << member.key());
      CHECK(contains_text(tool_schema["description"].get<std::string>(), member.key()));
    }
}

TEST_CASE("The page for people has every tool and everything that it takes") {
  const auto page = roomgen::read_file(ROOMGEN_SOURCE_DIR "/docs/agents.md");
  REQUIRE(page);
  const Json about = roomgen::mcp::about();
  for (const auto& each : about["tools"]) {
    CHECK(contains_text(*page, "`" + each["name"].get<std::string>() + "`"));
    for (const auto& member : each["inputSchema"]["properties"].items()) {
      INFO(each["name"] << " " << member.key());
      CHECK(contains_text(*page, "`" + member.key() + "`"));
    }
  }
}
