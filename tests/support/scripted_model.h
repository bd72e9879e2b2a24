#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "roomgen/chat/chat_model.h"

/// Gives the answers of a script, one after the other, and keeps the questions.
class ScriptedModel final : public roomgen::ChatModel {
 public:
  struct Script {
    std::vector<roomgen::Result<roomgen::ChatReply>> answers;
    std::vector<roomgen::ChatRequest> questions;
  };

  explicit ScriptedModel(std::shared_ptr<Script> script) : script_(std::move(script)) {}

  roomgen::Result<roomgen::ChatReply> chat(const roomgen::ChatRequest& request) override {
    script_->questions.push_back(request);
    const std::size_t turn = script_->questions.size() - 1;
    if (turn < script_->answers.size()) return script_->answers[turn];
    return roomgen::Error{roomgen::Error::Kind::io, "the script has ended"};
  }

 private:
  std::shared_ptr<Script> script_;
};

inline std::shared_ptr<ScriptedModel::Script> make_script(
    std::vector<roomgen::Result<roomgen::ChatReply>> answers) {
  return std::make_shared<ScriptedModel::Script>(ScriptedModel::Script{std::move(answers), {}});
}

inline roomgen::ChatReply reply_saying(const std::string& text, long long input_tokens = 100,
                                       long long output_tokens = 10) {
  roomgen::ChatReply reply;
  reply.text = text;
  reply.model = "tiny-1";
  reply.input_tokens = input_tokens;
  reply.output_tokens = output_tokens;
  reply.seconds = 0.25;
  return reply;
}

inline roomgen::ChatRequest asking(const std::string& text) {
  using roomgen::ChatMessage;
  roomgen::ChatRequest request;
  request.messages = {{ChatMessage::Role::system, "You furnish rooms.", {}},
                      {ChatMessage::Role::user, text, {}}};
  request.max_tokens = 100;
  return request;
}

/// What was answered, nothing if nothing was.
inline std::string text_of(const roomgen::Result<roomgen::ChatReply>& reply) {
  return reply ? reply->text : "";
}
