#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "byte_text.h"
#include "roomgen/base/json.h"
#include "wire.h"

namespace roomgen {

namespace {

Json anthropic_content(const ChatMessage& message) {
  if (message.images.empty()) return message.text;
  Json parts = Json::array({{{"type", "text"}, {"text", message.text}}});
  for (const auto& image : message.images) {
    // The protocol has no videos: the endpoint says so.
    const std::string type = media_type(image);
    parts.push_back({{"type", type.substr(0, type.find('/'))},
                     {"source",
                      {{"type", "base64"},
                       {"media_type", type},
                       {"data", base64(image)}}}});
  }
  return parts;
}

// System messages stand apart from the conversation.
std::string system_text(const ChatRequest& request) {
  std::string text;
  for (const auto& message : request.messages) {
    if (message.role != ChatMessage::Role::system) continue;
    if (!text.empty()) text += "\n\n";
    text += message.text;
  }
  return text;
}

// The budget is part of the bound on the answer, and has a least of its own.
void add_thinking(const ChatRequest& request, Json& body) {
  constexpr int least_budget = 1024;
  const int budget = std::max(least_budget, request.thinking);
  body["thinking"] = {{"type", "enabled"}, {"budget_tokens", budget}};
  body["max_tokens"] = request.max_tokens + budget;
}

// A model that thinks cannot be made to use a tool, only offered it.
void add_tool(const ChatRequest& request, bool thinks, Json& body) {
  body["tools"] = Json::array({{{"name", request.schema_name},
                                {"description", "Give the answer in this form."},
                                {"input_schema", request.schema}}});
  if (thinks) body["tool_choice"] = {{"type", "auto"}};
  else body["tool_choice"] = {{"type", "tool"}, {"name", request.schema_name}};
}

// A tool's input is the answer; prose beside it is not.
std::string text_of(const std::vector<JsonReader>& blocks) {
  std::string text;
  for (const auto& block : blocks) {
    const std::string type = block["type"].text_or("");
    if (type == "tool_use" && block["input"].exists())
      return json_line(*block["input"].raw());
    if (type == "text") text += block["text"].text_or("", max_answer_text);
  }
  return text;
}

}  // namespace

Json anthropic_body(const ChatRequest& request, const std::string& model, const Dialect& dialect) {
  Json body = {{"model", model}, {"max_tokens", request.max_tokens}};
  if (auto system = system_text(request); !system.empty()) body["system"] = std::move(system);
  for (const auto& message : request.messages) {
    if (message.role == ChatMessage::Role::system) continue;
    body["messages"].push_back({{"role", name(message.role)}, {"content", anthropic_content(message)}});
  }
  const bool thinks = dialect.thinking && request.thinking > 0;
  if (thinks) add_thinking(request, body);
  // Its scale ends at 1, that of others at 2; what thinks keeps its own.
  else if (dialect.temperature) body["temperature"] = std::min(request.temperature, 1.0);
  if (dialect.schema && !request.schema.is_null()) add_tool(request, thinks, body);
  return body;
}

Result<ChatReply> read_anthropic_reply(const Json& answer, const std::string& source) {
  AnswerReader reader(answer, source);
  const auto content = reader.root["content"];
  if (!content.exists()) content.report("missing");

  ChatReply reply;
  reply.model = reader.root["model"].text_or("");
  reader.read_usage("input_tokens", "output_tokens", reply);
  const std::string reason = reader.root["stop_reason"].text_or("");
  if (reason == "refusal") return refused(source, "");
  reply.cut_off = reason == "max_tokens";
  if (content.exists()) reply.text = text_of(content.elements());
  return reader.finish(std::move(reply), source);
}

}  // namespace roomgen
