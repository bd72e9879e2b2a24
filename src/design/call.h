#pragma once

#include <functional>
#include <string>
#include <vector>

#include "chat/interview.h"

namespace roomgen::design {

/// How a model is asked about assets: what to call for an answer, and pictures, as files.
struct Call {
  std::function<Result<ChatReply>(const ChatRequest&)> chat;
  std::vector<std::string> images;
  Prompts prompts;
  int answers = 3;
  int max_tokens = 4096;
  bool makes_itself = false;  ///< what it wants to be made it writes itself; else rules make it

  /// Asks as Interview does; what was repaired and asked again is added to the notes.
  template <typename Read>
  auto ask(Question question, Read read, std::vector<std::string>& notes) const {
    question.images = images;
    question.max_tokens = max_tokens;
    return talk(question, read, notes);
  }

  /// The same of a question that is whole, `images` and `max_tokens` included.
  template <typename Asked, typename Read>
  auto talk(Asked question, Read read, std::vector<std::string>& notes) const {
    Line line(chat);
    Interview interview(line, prompts, answers);
    auto answer = interview.ask(std::move(question), read);
    const auto told = interview.take_notes();
    notes.insert(notes.end(), told.begin(), told.end());
    return answer;
  }

 private:
  /// Whatever answers, as a chat model.
  class Line final : public ChatModel {
   public:
    using Chat = std::function<Result<ChatReply>(const ChatRequest&)>;
    explicit Line(const Chat& chat) : chat_(chat) {}
    Result<ChatReply> chat(const ChatRequest& request) override { return chat_(request); }

   private:
    const Chat& chat_;
  };
};

}  // namespace roomgen::design
