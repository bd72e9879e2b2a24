#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

/// JSON-RPC 2.0: what a line of the protocol says, and the lines that answer it.
namespace roomgen::mcp {

/// Those of JSON-RPC 2.0, and those that the Model Context Protocol adds.
enum ErrorCode {
  parse_error = -32700,
  invalid_request = -32600,
  method_not_found = -32601,
  invalid_params = -32602,
  internal_error = -32603,
  busy = -32000,
  resource_not_found = -32002,
  unsupported_version = -32022,
};

/// A request, or a notification, which has no id and gets no answer.
struct Message {
  Json id;  ///< text or number; null in a notification
  std::string method;
  Json params = Json::object();

  bool is_notification() const { return id.is_null(); }
};

/// Why a request has no result.
struct Fault {
  ErrorCode code = internal_error;
  std::string message;
  Json data = nullptr;
};

/// What cannot be taken for a message. The id is null where none can be told.
struct Refused {
  Json id;
  Fault fault;
};

/// Largest message that is read; what an agent has to say is far shorter.
inline constexpr std::size_t max_message_bytes = 1u << 20;

/// JSON that a client wrote. Objects are searched name by name, so that one of very many names would
/// take very long: more than 10,000 members are refused (Error::Kind::limit), however they are spread.
Result<Json> parse_from_client(std::string_view text, const std::string& source);

/// The messages of a line: one, or those of a batch. Answers to requests are left out, since none are made.
std::vector<std::variant<Message, Refused>> read_messages(std::string_view line);

Json reply(const Json& id, Json result);
Json refusal(const Json& id, const Fault& fault);
Json notification(const std::string& method, Json params);

/// A message as a line, which ends with its only newline.
std::string to_line(const Json& message);

}  // namespace roomgen::mcp
