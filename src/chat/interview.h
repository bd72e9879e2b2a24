#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "patience.h"
#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/chat/chat_model.h"

namespace roomgen {

/// What was made of an answer.
template <typename T>
struct Reading {
  T value;
  std::vector<std::string> repairs = {};
  /// What should be better although the answer can be used: worth one more question.
  std::string complaint = {};
  /// Of use as far as it goes, so that it is not asked for again because it was cut off.
  bool in_part = false;
};

/// An answer as it is shown to the model again: at most so many bytes, and nothing of one that was
/// cut off, which it would only continue or repeat.
std::string quoted_answer(const ChatReply& reply, std::size_t most);

/// One thing that a model is asked for.
struct Question {
  std::string system, user;  ///< names of prompts
  Prompts::Slots system_slots = {}, user_slots = {};
  Json schema = {};
  std::string schema_name = "answer";
  int max_tokens = 4096;
  int thinking = 0;  ///< ChatRequest::thinking
  std::vector<std::string> images = {};
  CancelToken cancel = {};
};

/// Asks a model, and asks again with what was wrong. Gives a model up that cannot be used or that
/// fails again and again.
class Interview {
 public:
  /// `answers`: asked for at most, for one question.
  Interview(ChatModel& model, Prompts prompts, int answers)
      : model_(model), prompts_(std::move(prompts)), answers_(answers) {}

  /// `read` makes a Result<Reading<T>> of the text of an answer.
  template <typename Read>
  auto ask(const Question& question, Read read)
      -> Result<decltype(std::declval<decltype(read(std::string()))>()->value)> {
    auto request = first_request(question);
    if (!request) return request.error();
    return ask(*std::move(request), read);
  }

  template <typename Read>
  auto ask(ChatRequest request, Read read)
      -> Result<decltype(std::declval<decltype(read(std::string()))>()->value)> {
    using Understood = decltype(read(std::string()));
    std::optional<Understood> usable;
    for (int answer = 1;; ++answer) {
      auto reply = call(request);
      if (!reply && (!usable || reply.error().kind == Error::Kind::cancelled)) return reply.error();
      if (!reply) return settle(**usable);
      Understood understood = read(reply->text);
      const std::string objection = objection_to(request, *reply, understood);
      const bool enough = usable || answer >= answers_ || is_enough(*reply, understood);
      const bool done = understood && (objection.empty() || enough);
      if (done) {
        if (!objection.empty()) notes_.push_back(objection);
        return settle(*understood);
      }
      if (answer >= answers_) {
        if (usable) return settle(**usable);
        return Error{Error::Kind::invalid_input, objection};
      }
      if (understood) usable = std::move(understood);
      if (auto status = ask_again(request, *reply, objection); !status) return status.error();
    }
  }

  /// Why the model is not asked any more; empty while it is.
  const std::string& lost() const { return patience_.lost(); }
  /// Has it ever answered?
  bool has_answered() const { return has_answered_; }
  /// What was repaired and asked again since the last call of this function.
  std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

 private:
  template <typename T>
  T settle(Reading<T>& reading) {
    notes_.insert(notes_.end(), reading.repairs.begin(), reading.repairs.end());
    return std::move(reading.value);
  }

  template <typename T>
  static std::string objection_to(const ChatRequest& request, const ChatReply& reply,
                                  const Result<Reading<T>>& understood) {
    const std::string what = understood ? understood->complaint : understood.error().message;
    return with_ending(request, reply, what);
  }

  template <typename T>
  static bool is_enough(const ChatReply& reply, const Result<Reading<T>>& understood) {
    return understood && reply.cut_off && understood->in_part && understood->complaint.empty();
  }

  static std::string with_ending(const ChatRequest& request, const ChatReply& reply,
                                 std::string objection);
  Result<ChatRequest> first_request(const Question& question) const;
  Result<ChatReply> call(const ChatRequest& request);
  Status ask_again(ChatRequest& request, const ChatReply& reply, const std::string& objection);

  ChatModel& model_;
  Prompts prompts_;
  int answers_;
  std::vector<std::string> notes_;
  Patience patience_;
  bool has_answered_ = false;
};

}  // namespace roomgen
