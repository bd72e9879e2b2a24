#include "json_rpc.h"

#include <optional>
#include <utility>

#include "roomgen/base/text.h"

namespace roomgen::mcp {

namespace {

using Reading = std::variant<Message, Refused>;

constexpr std::size_t max_members = 10'000;
constexpr std::size_t max_batch = 100;

bool has_too_many_members(std::string_view line) {
  std::size_t members = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (in_string && line[i] == '\\') ++i;
    else if (line[i] == '"') in_string = !in_string;
    else if (!in_string && line[i] == ':') ++members;
  }
  return members > max_members;
}

Refused refused(const Json& id, std::string why) { return {id, {invalid_request, std::move(why)}}; }

bool is_id(const Json& id) { return id.is_string() || id.is_number(); }

bool is_answer(const Json& json) {
  return !json.contains("method") && (json.contains("result") || json.contains("error"));
}

// Nothing for an answer.
std::optional<Reading> read_one(const Json& json) {
  if (!json.is_object()) return refused(nullptr, "a message is an object with \"jsonrpc\", \"id\" and \"method\"");
  if (is_answer(json)) return std::nullopt;
  Message message;
  const auto id = json.find("id");
  if (id != json.end()) {
    if (!is_id(*id)) return refused(nullptr, "/id: expected a text or a number");
    message.id = *id;
  }
  if (json.value("jsonrpc", Json()) != "2.0") return refused(message.id, "/jsonrpc: expected \"2.0\"");
  const auto method = json.find("method");
  if (method == json.end() || !method->is_string()) return refused(message.id, "/method: expected a text");
  message.method = method->get<std::string>();
  const auto params = json.find("params");
  if (params != json.end() && !params->is_object()) {
    if (message.is_notification()) return std::nullopt;
    return Refused{message.id, {invalid_params, "/params: expected an object"}};
  }
  if (params != json.end()) message.params = *params;
  return message;
}

std::vector<Reading> read_batch(const Json& batch) {
  if (batch.empty()) return {refused(nullptr, "a batch without messages")};
  if (batch.size() > max_batch)
    return {refused(nullptr, "a batch of more than " + std::to_string(max_batch) + " messages; send fewer at a time")};
  std::vector<Reading> readings;
  for (const auto& each : batch)
    if (auto reading = read_one(each)) readings.push_back(*std::move(reading));
  return readings;
}

}  // namespace

Result<Json> parse_from_client(std::string_view text, const std::string& source) {
  if (has_too_many_members(text))
    return Error{Error::Kind::limit, source + ": more than " + std::to_string(max_members) +
                                         " members; send less at a time"};
  return parse_json(text, source);
}

std::vector<Reading> read_messages(std::string_view line) {
  if (trim(line).empty()) return {};
  if (line.size() > max_message_bytes)
    return {refused(nullptr, "a message of more than " + std::to_string(max_message_bytes) +
                                 " bytes; send less at a time")};
  const auto json = parse_from_client(line, "the message");
  if (!json && json.error().kind == Error::Kind::limit) return {refused(nullptr, json.error().message)};
  if (!json) return {Refused{nullptr, {parse_error, json.error().message}}};
  if (json->is_array()) return read_batch(*json);
  if (auto reading = read_one(*json)) return {*std::move(reading)};
  return {};
}

Json reply(const Json& id, Json result) { return {{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}}; }

Json refusal(const Json& id, const Fault& fault) {
  Json error = {{"code", static_cast<int>(fault.code)}, {"message", fault.message}};
  if (!fault.data.is_null()) error["data"] = fault.data;
  return {{"jsonrpc", "2.0"}, {"id", id}, {"error", std::move(error)}};
}

Json notification(const std::string& method, Json params) {
  return {{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
}

std::string to_line(const Json& message) { return json_line(message) + "\n"; }

}  // namespace roomgen::mcp
