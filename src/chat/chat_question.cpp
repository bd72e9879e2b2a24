#include "chat_question.h"

#include "base/sha256.h"

namespace roomgen {

namespace {

constexpr std::size_t max_text = 64u << 20;
constexpr long long max_count = 1'000'000'000'000;

Json message_json(const ChatMessage& message) {
  Json json = {{"role", name(message.role)}, {"text", message.text}};
  for (const auto& png : message.images) json["images"].push_back(sha256_hex(png));
  return json;
}

}  // namespace

Json question_json(const ChatRequest& request) {
  Json messages = Json::array();
  for (const auto& message : request.messages) messages.push_back(message_json(message));
  Json json = {{"messages", std::move(messages)},
               {"schema", request.schema},
               {"schema_name", request.schema_name},
               {"max_tokens", request.max_tokens},
               {"temperature", request.temperature}};
  if (request.thinking > 0) json["thinking"] = request.thinking;
  return json;
}

std::string question_key(const Json& question) {
  return sha256_hex(json_line(question));
}

Json reply_json(const ChatReply& reply) {
  Json json = {{"text", reply.text},
               {"model", reply.model},
               {"input_tokens", reply.input_tokens},
               {"output_tokens", reply.output_tokens},
               {"seconds", rounded(reply.seconds)},
               {"attempts", reply.attempts}};
  if (reply.cut_off) json["cut_off"] = true;
  return json;
}

ChatReply read_reply(const JsonReader& json) {
  ChatReply reply;
  reply.text = json["text"].text(max_text);
  reply.model = json["model"].text_or("");
  reply.input_tokens = json["input_tokens"].integer_or(0, 0, max_count);
  reply.output_tokens = json["output_tokens"].integer_or(0, 0, max_count);
  reply.seconds = json["seconds"].number_or(0, 0, 1e9);
  reply.attempts = static_cast<int>(json["attempts"].integer_or(1, 0, 1000000));
  reply.cut_off = json["cut_off"].boolean_or(false);
  return reply;
}

}  // namespace roomgen
