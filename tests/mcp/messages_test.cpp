#include "catch.h"
#include "mcp/base64.h"
#include "mcp/json_rpc.h"
#include "support/contains.h"

using namespace roomgen::mcp;

namespace {

Refused refused(const std::string& line) {
  const auto readings = read_messages(line);
  REQUIRE(readings.size() == 1);
  REQUIRE(std::holds_alternative<Refused>(readings[0]));
  return std::get<Refused>(readings[0]);
}

Message message(const std::string& line) {
  const auto readings = read_messages(line);
  REQUIRE(readings.size() == 1);
  REQUIRE(std::holds_alternative<Message>(readings[0]));
  return std::get<Message>(readings[0]);
}

}  // namespace

TEST_CASE("Requests and notifications are told apart, and ids are texts or numbers") {
  const auto request = message(R"({"jsonrpc":"2.0","id":"a","method":"ping","params":{"x":1}})");
  CHECK(request.id == "a");
  CHECK(request.method == "ping");
  CHECK(request.params["x"] == 1);
  CHECK_FALSE(request.is_notification());
  CHECK(message(R"({"jsonrpc":"2.0","method":"notifications/initialized"})").is_notification());
  CHECK(message(R"({"jsonrpc":"2.0","id":1.5,"method":"ping"})").id == 1.5);
  CHECK(read_messages(R"({"jsonrpc":"2.0","id":1,"result":{}})").empty());
  CHECK(read_messages("  ").empty());
}

TEST_CASE("What is no message is refused with the code of JSON-RPC and the id where there is one") {
  CHECK(refused("{").fault.code == parse_error);
  CHECK(refused("\xff\xfe").fault.code == parse_error);
  CHECK(refused("7").fault.code == invalid_request);
  CHECK(refused("[]").fault.code == invalid_request);
  CHECK(refused(R"({"id":3,"method":"ping"})").id == 3);
  CHECK(refused(R"({"jsonrpc":"1.0","id":3,"method":"ping"})").fault.code == invalid_request);
  CHECK(refused(R"({"jsonrpc":"2.0","id":3,"method":7})").id == 3);
  CHECK(refused(R"({"jsonrpc":"2.0","id":null,"method":"ping"})").id.is_null());
  CHECK(refused(R"({"jsonrpc":"2.0","id":[1],"method":"ping"})").fault.code == invalid_request);
  CHECK(refused(R"({"jsonrpc":"2.0","id":3,"method":"ping","params":[1]})").fault.code == invalid_params);
}

TEST_CASE("Messages that are too deep, too long or of too many members are refused") {
  CHECK(refused(std::string(100'000, '[')).fault.code == invalid_request);
  CHECK(contains_text(refused(std::string(max_message_bytes + 1, ' ') + "{").fault.message, "1048576"));
  std::string many = "{";
  for (int i = 0; i < 20'000; ++i) many += "\"k" + std::to_string(i) + "\":0,";
  many.back() = '}';
  CHECK(contains_text(refused(many).fault.message, "10000 members"));
  const std::string colons(20'000, ':');  // in a text they are no members
  CHECK(message(R"({"jsonrpc":"2.0","id":1,"method":"ping","params":{"text":")" + colons + "\"}}").id == 1);
}

TEST_CASE("A batch is read message by message") {
  const auto readings = read_messages(R"([{"jsonrpc":"2.0","id":1,"method":"ping"},
      {"jsonrpc":"2.0","id":2,"result":{}}, 4, {"jsonrpc":"2.0","method":"x"}])");
  REQUIRE(readings.size() == 3);
  CHECK(std::holds_alternative<Message>(readings[0]));
  CHECK(std::holds_alternative<Refused>(readings[1]));
}

TEST_CASE("A line ends with its only newline, whatever its texts hold") {
  const std::string line = to_line(reply("a\nb", {{"text", "line\nbreak \xff"}}));
  CHECK(line.find('\n') == line.size() - 1);
  CHECK(roomgen::parse_json(line, "line"));
}

TEST_CASE("Base64 is that of RFC 4648") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfd") == "//79");
}
