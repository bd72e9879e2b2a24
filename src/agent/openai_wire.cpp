#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "byte_text.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "wire.h"

namespace roomgen {

namespace {

// A plain string where there are no images: the form that every server knows.
Json openai_content(const ChatMessage& message) {
  if (message.images.empty()) return message.text;
  Json parts = Json::array({{{"type", "text"}, {"text", message.text}}});
  for (const auto& image : message.images) {
    const std::string type = media_type(image), url = "data:" + type + ";base64," + base64(image);
    // OpenAI's own models take no videos; servers of open models call them so.
    const char* part = type.starts_with("video/") ? "video_url" : "image_url";
    parts.push_back({{"type", part}, {part, {{"url", url}}}});
  }
  return parts;
}

// OpenAI enforces a schema only as `strict`, and takes as strict only one whose objects list all
// their members as required and allow no others.
bool may_be_strict(const Json& schema) {
  if (schema.is_array()) return std::all_of(schema.begin(), schema.end(), may_be_strict);
  if (!schema.is_object()) return true;
  if (const auto properties = schema.find("properties");
      properties != schema.end() && properties->is_object()) {
    const auto required = schema.find("required");
    if (schema.value("additionalProperties", Json(true)) != Json(false)) return false;
    if (required == schema.end() || required->size() != properties->size()) return false;
  }
  return std::all_of(schema.begin(), schema.end(), may_be_strict);
}

Json response_format(const ChatRequest& request) {
  Json schema = {{"name", request.schema_name}, {"schema", request.schema}};
  if (may_be_strict(request.schema)) schema["strict"] = true;
  return {{"type", "json_schema"}, {"json_schema", schema}};
}

// The protocol has words for it: low, medium, high. Gateways take them for about 1,000, 8,000 and 24,000 tokens.
const char* effort_for(int thinking) {
  constexpr int little = 2000, some = 12000;
  return thinking <= little ? "low" : thinking <= some ? "medium" : "high";
}

std::string text_of(const JsonReader& content) {
  if (!content.is_array()) return content.text_or("", max_answer_text);
  std::string text;
  for (const auto& part : content.elements()) text += part["text"].text_or("", max_answer_text);
  return text;
}

// Where an answer is that is not in the content: in the call of a tool that nobody offered, or, for
// servers that take the whole of it for thinking, there. Thinking that was cut off is no answer.
std::string text_elsewhere(const JsonReader& message, bool cut_off) {
  for (const auto& call : message["tool_calls"].elements_or_none())
    if (const auto function = call["function"]; function.exists())
      return function["arguments"].text_or("", max_answer_text);
  for (const char* key : {"reasoning_content", "reasoning"})
    if (!cut_off && message[key].is_string()) return message[key].text(max_answer_text);
  return {};
}

}  // namespace

Json openai_body(const ChatRequest& request, const std::string& model, const Dialect& dialect) {
  Json body = {{"model", model}};
  for (const auto& message : request.messages)
    body["messages"].push_back({{"role", name(message.role)}, {"content", openai_content(message)}});
  const bool completion = dialect.token_limit == Dialect::TokenLimit::max_completion_tokens;
  const bool thinks = dialect.thinking && request.thinking > 0;
  body[completion ? "max_completion_tokens" : "max_tokens"] = request.max_tokens + (thinks ? request.thinking : 0);
  if (thinks) body["reasoning_effort"] = effort_for(request.thinking);
  if (dialect.temperature) body["temperature"] = request.temperature;
  if (dialect.stream) body["stream"] = true, body["stream_options"] = {{"include_usage", true}};
  if (dialect.schema && !request.schema.is_null())
    body["response_format"] = response_format(request);
  return body;
}

Result<ChatReply> read_openai_reply(const Json& answer, const std::string& source) {
  // Gateways report failures of the server behind them with status 200.
  if (answer.is_object() && answer.contains("error") && !answer["error"].is_null())
    return Error{Error::Kind::io, source + ": " + complaint_in(answer.dump())};

  AnswerReader reader(answer, source);
  const auto choices = reader.root["choices"].elements();
  if (choices.empty()) reader.root["choices"].report("missing; expected at least one choice");

  ChatReply reply;
  reply.model = reader.root["model"].text_or("");
  reader.read_usage("prompt_tokens", "completion_tokens", reply);
  if (!choices.empty()) {
    const auto message = choices.front()["message"];
    if (!message.exists()) message.report("missing");
    const std::string reason = choices.front()["finish_reason"].text_or("");
    const std::string refusal =
        message.exists() ? message["refusal"].text_or("", max_answer_text) : std::string();
    if (!refusal.empty() || reason == "content_filter") return refused(source, refusal);
    reply.cut_off = reason == "length";
    if (message.exists()) reply.text = text_of(message["content"]);
    if (message.exists() && trim(reply.text).empty())
      reply.text = text_elsewhere(message, reply.cut_off);
  }
  return reader.finish(std::move(reply), source);
}

}  // namespace roomgen
