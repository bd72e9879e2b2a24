#include "mcp/server.h"

#include <algorithm>
#include <random>
#include <set>
#include <thread>

#include "catch.h"
#include "mcp/about.h"
#include "mcp/page.h"
#include "support/contains.h"

using namespace roomgen;
using namespace roomgen::mcp;

namespace {

/// A server of the real tools' descriptions whose tools say what they were given.
struct Conversation {
  Conversation()
      : server(offer(), [this](const std::string& line) {
          auto json = parse_json(line, "answer");
          REQUIRE(json);
          sent.push_back(*json);
        }) {}

  static Offer offer() {
    Offer offer;
    offer.about = about();
    offer.version = "1";
    for (const auto& tool : offer.about["tools"])
      offer.tools[tool["name"]] = [](const ToolCall& call) -> Result<ToolAnswer> {
        for (const double done : {0, 1, 1, 2, 2}) call.progress(done, 2, "so far");
        const std::string room = call.arguments.value("room", "");
        if (room == "missing") return Error{Error::Kind::not_found, "no such room"};
        if (room == "huge") return huge_answer();
        if (room == "broken") throw std::runtime_error("broken");
        return text_answer("did it", call.arguments);
      };
    offer.list_resources = [] { return Json::array({Json{{"uri", "roomgen:///a/scene.json"}, {"name", "a"}}}); };
    offer.read_resource = [](const std::string& uri) -> Result<std::string> {
      if (uri == "roomgen:///a/scene.json") return std::string("{}");
      return Error{Error::Kind::not_found, "no resource"};
    };
    return offer;
  }

  static ToolAnswer huge_answer() {
    std::string text;
    Json data = {{"changes", Json::array()}, {"notices", {"one"}}};
    for (int i = 0; i < 10'000; ++i) {
      data["changes"].push_back("chair-" + std::to_string(i) + " moved");
      text += (i > 0 ? "\n" : "") + data["changes"].back().get<std::string>();
    }
    return text_answer(text, data);
  }

  /// The answer to one request.
  Json ask(const Json& id, const std::string& method, const Json& params = Json::object()) {
    sent.clear();
    server.take(to_line({{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}}));
    if (sent.empty()) REQUIRE(server.work());
    REQUIRE_FALSE(sent.empty());
    CHECK(sent.back()["id"] == id);
    return sent.back();
  }
  Json call(const std::string& tool, const Json& arguments, const Json& meta = Json::object()) {
    return ask(1, "tools/call", {{"name", tool}, {"arguments", arguments}, {"_meta", meta}});
  }
  /// Answers all that waits.
  void finish() {
    server.close();
    while (server.work()) {
    }
  }

  std::vector<Json> sent;
  Server server;
};

std::string check_call(const Json& id) {
  const Json params = {{"name", "check"}, {"arguments", {{"room", "a"}}}};
  return to_line({{"jsonrpc", "2.0"}, {"id", id}, {"method", "tools/call"}, {"params", params}});
}

const Json modern = {{"io.modelcontextprotocol/protocolVersion", "2026-07-28"}};

}  // namespace

TEST_CASE("Client and server agree on the client's revision if it is spoken, else on the newest") {
  Conversation talk;
  for (const std::string version : {"2024-11-05", "2025-03-26", "2025-06-18", "2025-11-25"})
    CHECK(talk.ask(1, "initialize", {{"protocolVersion", version}})["result"]["protocolVersion"] == version);
  const Json answer = talk.ask("x", "initialize", {{"protocolVersion", "1999-01-01"}})["result"];
  CHECK(answer["protocolVersion"] == "2025-11-25");
  CHECK(answer["serverInfo"]["name"] == "roomgen");
  CHECK(answer["capabilities"].contains("tools"));
  CHECK(talk.ask(2, "initialize", {{"protocolVersion", 7}})["error"]["code"] == invalid_params);
  CHECK(talk.ask(3, "ping")["result"] == Json::object());
}

TEST_CASE("A request that names its revision is answered in its manner") {
  Conversation talk;
  const Json found = talk.ask(1, "server/discover", {{"_meta", modern}})["result"];
  CHECK(found["supportedVersions"].back() == "2026-07-28");
  CHECK(found["resultType"] == "complete");
  const Json tools = talk.ask(1, "tools/list", {{"_meta", modern}})["result"];
  CHECK(tools["ttlMs"] == 0);
  CHECK(tools["_meta"].contains("io.modelcontextprotocol/serverInfo"));
  CHECK_FALSE(talk.ask(1, "tools/list")["result"].contains("resultType"));
  const Json unknown = {{"io.modelcontextprotocol/protocolVersion", "2099-01-01"}};
  const Json refused = talk.ask(1, "tools/list", {{"_meta", unknown}})["error"];
  CHECK(refused["code"] == unsupported_version);
  CHECK(refused["data"]["requested"] == "2099-01-01");
  CHECK(talk.ask(1, "resources/read", {{"uri", "x"}})["error"]["code"] == resource_not_found);
  CHECK(talk.ask(1, "resources/read", {{"uri", "x"}, {"_meta", modern}})["error"]["code"] == invalid_params);
}

TEST_CASE("Tools are called with what keeps to their schema, and say so when they fail") {
  Conversation talk;
  const Json done = talk.call("check", {{"room", "a"}})["result"];
  CHECK(done["isError"] == false);
  CHECK(done["content"][0]["text"] == "did it");
  CHECK(done["structuredContent"]["room"] == "a");
  for (const Json& arguments : {Json{{"room", 7}}, Json{{"rom", "a"}}, Json::array(), Json("text"), Json(true)}) {
    const Json failed = talk.call("check", arguments)["result"];
    CHECK(failed["isError"] == true);
    CHECK(contains_text(failed["content"][0]["text"].get<std::string>(), "check: "));
  }
  CHECK(talk.call("check", {{"room", "missing"}})["result"]["isError"] == true);
  CHECK(talk.call("check", {{"room", "broken"}})["error"]["code"] == internal_error);
  CHECK(contains_text(talk.call("chek", {})["error"]["message"].get<std::string>(), "preview"));
  CHECK(talk.ask(1, "tools/call", {{"name", 7}})["error"]["code"] == invalid_params);
  CHECK(talk.ask(1, "tools/fly")["error"]["code"] == method_not_found);
  CHECK(talk.ask(1, "resources/list")["result"]["resources"].size() == 1);
  CHECK(talk.ask(1, "resources/read", {{"uri", "roomgen:///a/scene.json"}})["result"]["contents"][0]["text"] == "{}");
}

TEST_CASE("Who gives a token is told how far the work is, before the answer") {
  Conversation talk;
  talk.call("check", {{"room", "a"}}, {{"progressToken", "t"}});
  REQUIRE(talk.sent.size() == 4);
  for (int i = 0; i < 3; ++i) {
    CHECK(talk.sent[i]["method"] == "notifications/progress");
    CHECK(talk.sent[i]["params"]["progressToken"] == "t");
    CHECK(talk.sent[i]["params"]["progress"] == i);  // larger each time
    CHECK(talk.sent[i]["params"]["message"] == "so far");
  }
}

TEST_CASE("No answer is longer than a model can read") {
  Conversation talk;
  const Json result = talk.call("check", {{"room", "huge"}})["result"];
  CHECK(to_line(result).size() < 2 * answer_bytes + 1'000);
  const Json& data = result["structuredContent"];
  CHECK(data["changes"].size() + data["cut"]["changes"].get<std::size_t>() == 10'000);
  CHECK(data["notices"].size() == 1);
  const std::string text = result["content"][0]["text"];
  const auto lines = std::count(text.begin(), text.end(), '\n');
  CHECK(contains_text(text, "(cut here; " + std::to_string(10'000 - lines) + " more lines)"));
}

TEST_CASE("A call that is cancelled while it waits is not answered, and the others are") {
  Conversation talk;
  for (const Json& id : {Json(1), Json(2), Json("3")}) talk.server.take(check_call(id));
  talk.server.take(R"({"jsonrpc":"2.0","method":"notifications/cancelled","params":{"requestId":2}})");
  talk.server.take(R"({"jsonrpc":"2.0","method":"notifications/cancelled","params":{"requestId":"none"}})");
  talk.server.take(R"({"jsonrpc":"2.0","method":"notifications/cancelled"})");
  talk.finish();
  REQUIRE(talk.sent.size() == 2);
  CHECK(talk.sent[0]["id"] == 1);
  CHECK(talk.sent[1]["id"] == "3");
}

TEST_CASE("More calls than may wait are refused, and none of those that wait is lost") {
  Conversation talk;
  for (int id = 0; id < 150; ++id)
    talk.server.take(check_call(id));
  CHECK(talk.sent.size() == 50);
  CHECK(talk.sent[0]["error"]["code"] == busy);
  talk.finish();
  std::set<int> ids;
  for (const auto& each : talk.sent) ids.insert(each["id"].get<int>());
  CHECK(ids.size() == 150);
}

TEST_CASE("Messages and calls on two threads are all answered, once each") {
  Conversation talk;
  std::thread worker([&] {
    while (talk.server.work()) {
    }
  });
  for (int id = 0; id < 60; ++id) {
    const bool quick = id % 2 == 0;
    talk.server.take(to_line({{"jsonrpc", "2.0"}, {"id", id}, {"method", quick ? "ping" : "resources/list"}}));
  }
  talk.server.close();
  worker.join();
  std::multiset<int> ids;
  for (const auto& each : talk.sent) ids.insert(each["id"].get<int>());
  CHECK(ids.size() == 60);
  CHECK(std::set<int>(ids.begin(), ids.end()).size() == 60);
}

TEST_CASE("No bytes end the server, and what it answers has the id that was asked with, or none") {
  const std::vector<std::string> sound = {
      R"({"jsonrpc":"2.0","id":41,"method":"initialize","params":{"protocolVersion":"2025-06-18","capabilities":{}}})",
      R"({"jsonrpc":"2.0","id":42,"method":"tools/call","params":{"name":"edit","_meta":{"progressToken":5},)"
      R"("arguments":{"room":"a","change":"x","operations":[{"do":"turn"}]}}})",
      R"({"jsonrpc":"2.0","id":43,"method":"resources/read","params":{"uri":"roomgen:///a/scene.json"}})",
      R"([{"jsonrpc":"2.0","id":44,"method":"ping"},)"
      R"({"jsonrpc":"2.0","method":"notifications/cancelled","params":{"requestId":42}}])",
      R"({"jsonrpc":"2.0","id":45,"method":"tools/list",)"
      R"("params":{"_meta":{"io.modelcontextprotocol/protocolVersion":"2026-07-28"}}})"};
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::string pieces = "{}[]\",:0123456789-eE.\\nulltrue \x01\xff";
  std::size_t answered = 0;
  for (int round = 0; round < 1'500; ++round) {
    std::string line = sound[below(sound.size())];
    for (std::size_t changes = 1 + below(4); changes > 0 && !line.empty(); --changes) {
      const std::size_t at = below(line.size());
      switch (below(4)) {
        case 0: line[at] = pieces[below(pieces.size())]; break;
        case 1: line.erase(at, 1 + below(6)); break;
        case 2: line.insert(at, 1, pieces[below(pieces.size())]); break;
        default: line.insert(at, line.substr(below(line.size()), below(20)));
      }
    }
    Conversation talk;
    talk.server.take(line);
    talk.finish();
    for (const auto& each : talk.sent) {
      if (each.contains("method")) continue;  // progress
      ++answered;
      const std::string id = each["id"].is_null() ? "" : each["id"].dump();
      if (!id.empty() && each["id"].is_number_integer()) CHECK(contains_text(line, id));
      CHECK(each.contains("result") != each.contains("error"));
    }
  }
  CHECK(answered > 900);
}
