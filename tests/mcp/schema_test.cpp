#include <algorithm>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "mcp/about.h"
#include "mcp/input_schema.h"
#include "mcp/meant_input.h"
#include "roomgen/base/file.h"
#include "support/contains.h"

using roomgen::Json;
using roomgen::mcp::as_meant;
using roomgen::mcp::check_input;

namespace {

Json tool(const std::string& name) {
  const Json about = roomgen::mcp::about();
  for (const auto& each : about["tools"])
    if (each["name"] == name) return each;
  FAIL("no tool " << name);
  return {};
}

Json meant(const std::string& name, const std::string& arguments) {
  return as_meant(tool(name)["inputSchema"], Json::parse(arguments));
}

std::string fault(const std::string& name, const std::string& arguments) {
  const auto status = check_input(tool(name)["inputSchema"], meant(name, arguments));
  return status ? "" : status.error().message;
}

/// Clients turn what a tool takes into the narrower forms of model providers, some of which refuse the whole
/// server over one schema: each needs one type, alternatives are none, enum is for texts, an object has members.
void check_form(const Json& schema, const std::string& where) {
  INFO(where);
  REQUIRE(schema.is_object());
  REQUIRE(schema.contains("type"));
  REQUIRE(schema["type"].is_string());
  for (const char* word : {"anyOf", "oneOf", "allOf", "not", "$ref", "const", "prefixItems"})
    CHECK_FALSE(schema.contains(word));
  if (schema.contains("enum")) CHECK(schema["type"] == "string");
  CHECK(schema.contains("properties") == (schema["type"] == "object"));
  CHECK(schema.contains("items") == (schema["type"] == "array"));
  const Json members = schema.value("properties", Json::object());
  for (const auto& key : schema.value("required", Json::array())) CHECK(members.contains(key.get<std::string>()));
  for (const auto& [key, member] : members.items()) check_form(member, where + "/" + key);
  if (schema.contains("items")) check_form(schema["items"], where + "/items");
}

/// Wherever values are enumerated, their type is said.
void check_enums(const Json& json, const std::string& where) {
  INFO(where);
  if (json.is_object() && json.contains("enum") && json["enum"].is_array()) CHECK(json.contains("type"));
  if (json.is_structured())
    for (const auto& [key, member] : json.items()) check_enums(member, where + "/" + key);
}

}  // namespace

TEST_CASE("Arguments that keep to a tool's schema are taken, others are told where they do not") {
  CHECK(fault("preview", R"({"room":"a","object":"desk-0","position":[1,2.5]})") == "");
  CHECK(contains_text(fault("preview", R"({"room":"a","object":"desk-0","position":[1]})"), "/position"));
  CHECK(contains_text(fault("preview", R"({"room":"a","object":"desk-0","position":[1,"two"]})"),
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
  CHECK(contains_text(fault("plan", R"({"prompt":""})"), "\"prompt\" is missing or empty"));
  CHECK(contains_text(fault("preview", R"({"room":"a","object":"bed-0","position":[]})"), "\"position\" is missing"));
}

TEST_CASE("What is null or empty counts as left out") {
  const Json all = meant("generate", R"({"folder":"b","prompt":"a bedroom","plan":"","seed":null,"size":null,
      "floor_plan":"","replace":null,"picture":""})");
  CHECK(all == Json::parse(R"({"folder":"b","prompt":"a bedroom"})"));
  CHECK(meant("edit", R"({"room":"a","change":"x","operations":[]})") == Json::parse(R"({"room":"a","change":"x"})"));
  CHECK(meant("edit", R"({"room":"a","operations":[{"do":"lock","objects":["bed-0"],"locked":null,"on":"","size":[]}]})")
            ["operations"] == Json::parse(R"([{"do":"lock","objects":["bed-0"]}])"));
  // What the schema does not know is for the tool to judge.
  CHECK(meant("optimise", R"({"folder":"a","program":{"sets":null}})")["program"].contains("sets"));
  CHECK(fault("check", R"({"room":"a","rom":null})") != "");
}

TEST_CASE("Numbers, truths, lists and objects are read from texts, and nothing else is") {
  const auto operations = Json::parse(R"([{"do":"turn","object":"bed-0","by_deg":4.5}])");
  const std::string one = R"({\"do\":\"turn\",\"object\":\"bed-0\",\"by_deg\":\"4.5\"})";
  for (const std::string& list : {"\"[" + one + "]\"", "[\"" + one + "\"]", "\"" + one + "\""})
    CHECK(meant("edit", R"({"room":"a","operations":)" + list + "}")["operations"] == operations);
  for (const char* position : {R"("[1.5, 2]")", R"("1.5, 2")", R"(["1.5", " 2 "])"})
    CHECK(meant("preview", R"({"room":"a","object":"b","position":)" + std::string(position) + "}")["position"] ==
          Json::parse("[1.5, 2]"));
  CHECK(meant("undo", R"({"room":"a","steps":"7"})")["steps"] == 7);
  CHECK(meant("undo", R"({"room":"a","steps":7.0})")["steps"].is_number_integer());
  CHECK_FALSE(meant("undo", R"({"room":"a","steps":"null"})").contains("steps"));
  CHECK(meant("generate", R"({"folder":"a","replace":"True"})")["replace"] == true);
  CHECK(meant("check", R"("{\"room\":\"a\"}")")["room"] == "a");
  // Texts stay texts, and what cannot be read comes back with the form that is wanted.
  CHECK(meant("compose", R"({"folder":"7","prompt":"true","seats":"4"})")["folder"] == "7");
  CHECK(contains_text(fault("undo", R"({"room":"a","steps":"two"})"), "expected a whole number"));
  CHECK(contains_text(fault("undo", R"({"room":"a","steps":"7.5"})"), "expected a whole number"));
  CHECK(contains_text(fault("undo", R"({"room":"a","steps":true})"), "expected a whole number"));
  CHECK(contains_text(fault("undo", R"({"room":"a","steps":"1e300"})"), "above"));
  CHECK(contains_text(fault("generate", R"({"folder":"a","replace":"yes"})"), "expected true or false"));
  CHECK(contains_text(fault("preview", R"({"room":"a","object":"b","position":{"x":1,"y":2}})"),
                      "/position: expected a list of numbers, as in [1.5, 2]"));
  CHECK(contains_text(fault("edit", R"({"room":"a","operations":[{"do":"lock","objects":"bed-0, desk-0"}]})"),
                      "/operations/0/objects: expected a list of texts"));
}

TEST_CASE("A text of very many members is not read as an object") {
  std::string many = "{";
  for (int i = 0; i < 20'000; ++i) many += "\"k" + std::to_string(i) + "\":0,";
  many.back() = '}';
  const Json schema = {{"type", "object"}, {"properties", Json::object()}};
  CHECK(as_meant(schema, many).is_string());
}

TEST_CASE("What tools take keeps to the form that every client can hand on") {
  const Json about = roomgen::mcp::about();
  for (const auto& each : about["tools"]) check_form(each["inputSchema"], each["name"]);
  check_enums(about, "");
}

TEST_CASE("Every tool says what it takes, and every member of that is explained") {
  const Json about = roomgen::mcp::about();
  CHECK(about["tools"].size() == 21);
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

namespace {

bool contains_element(const Json& list, const Json& element) {
  return list.is_array() && std::find(list.begin(), list.end(), element) != list.end();
}

}  // namespace

TEST_CASE("Agents are told of every operation of an edit") {
  const auto text = roomgen::read_file(ROOMGEN_SOURCE_DIR "/docs/operation.schema.json");
  REQUIRE(text);
  const Json schema = Json::parse(*text), tool_schema = tool("edit")["inputSchema"]["properties"]["operations"];
  Json known = Json::array();
  for (const auto& each : schema["oneOf"]) known.push_back(each["properties"]["do"]["const"]);
  CHECK(tool_schema["items"]["properties"]["do"]["enum"] == known);
  const Json& members = tool_schema["items"]["properties"];
  for (const auto& each : schema["oneOf"])
    for (const auto& [key, member] : each["properties"].items()) {
      INFO(each["properties"]["do"]["const"] << " " << key);
      CHECK(contains_text(tool_schema["description"].get<std::string>(), key));
      if (key == "do" || key == "by") continue;  // by is a list or a number, which no one type can say
      REQUIRE(members.contains(key));
      // Of several types the tool names one: not every client takes a list.
      const Json types = member.contains("type") ? member["type"] : Json("string");
      CHECK((types == members[key]["type"] || contains_element(types, members[key]["type"])));
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
