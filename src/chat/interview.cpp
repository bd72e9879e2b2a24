#include "interview.h"

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double second_temperature = 0.5;  // weak models repeat a bad answer word for word
// A program must be seen whole to be mended; what is longer is not worth its tokens.
constexpr std::size_t most_quoted = 24000;  // bytes

}  // namespace

std::string quoted_answer(const ChatReply& reply, std::size_t most) {
  return reply.cut_off ? "(an answer that was cut off)" : shortened(reply.text, most);
}

std::string Interview::with_ending(const ChatRequest& request, const ChatReply& reply,
                                   std::string objection) {
  if (!reply.cut_off) return objection;
  if (!objection.empty()) objection += "; ";
  return objection + "the answer was cut off after " + std::to_string(request.max_tokens) +
         " tokens; be brief";
}

Result<ChatRequest> Interview::first_request(const Question& question) const {
  auto system = prompts_.render(question.system, question.system_slots);
  if (!system) return system.error();
  auto user = prompts_.render(question.user, question.user_slots);
  if (!user) return user.error();
  ChatRequest request;
  request.messages = {{ChatMessage::Role::system, *std::move(system), {}},
                      {ChatMessage::Role::user, *std::move(user), question.images}};
  request.schema = question.schema;
  request.schema_name = question.schema_name;
  request.max_tokens = question.max_tokens;
  request.thinking = question.thinking;
  request.cancel = question.cancel;
  return request;
}

Result<ChatReply> Interview::call(const ChatRequest& request) {
  auto reply = model_.chat(request);
  patience_.note(reply);
  has_answered_ = has_answered_ || reply;
  return reply;
}

Status Interview::ask_again(ChatRequest& request, const ChatReply& reply,
                            const std::string& objection) {
  notes_.push_back("asked again: " + objection);
  auto again = prompts_.render("again-user", {{"error", objection}});
  if (!again) return again.error();
  request.messages.push_back({ChatMessage::Role::assistant, quoted_answer(reply, most_quoted), {}});
  request.messages.push_back({ChatMessage::Role::user, *std::move(again), {}});
  request.temperature = second_temperature;
  return {};
}

}  // namespace roomgen
