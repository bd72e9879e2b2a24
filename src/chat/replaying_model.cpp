#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "chat_question.h"
#include "chat_recording.h"
#include "question_difference.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/chat/chat_model.h"

namespace roomgen {

namespace {

constexpr std::size_t max_recording_bytes = 128u << 20;

class ReplayingModel final : public ChatModel {
 public:
  ReplayingModel(std::string source, std::vector<RecordedAnswer> answers)
      : source_(std::move(source)), answers_(std::move(answers)) {
    for (std::size_t i = 0; i < answers_.size(); ++i) by_key_[answers_[i].key].answers.push_back(i);
  }

  Result<ChatReply> chat(const ChatRequest& request) override {
    if (request.cancel.cancelled()) return Error{Error::Kind::cancelled, source_ + ": cancelled"};
    const Json question = question_json(request);
    const auto found = by_key_.find(question_key(question));
    if (found == by_key_.end()) return miss(question);
    auto& [answers, next] = found->second;
    const std::size_t index = answers[std::min(next, answers.size() - 1)];
    ++next;
    return answers_[index].answer;
  }

 private:
  struct Takes {
    std::vector<std::size_t> answers;
    std::size_t next = 0;
  };

  Error miss(const Json& question) const {
    std::string message = source_ + ": no recorded answer to this question";
    if (const auto* nearest = nearest_question(answers_, question))
      message += "; the nearest one, in line " + std::to_string(nearest->line) + ", differs in " +
                 describe_difference(nearest->question, question);
    return {Error::Kind::unavailable, message + "; record it anew"};
  }

  std::string source_;
  std::vector<RecordedAnswer> answers_;
  std::map<std::string, Takes> by_key_;
};

}  // namespace

Result<std::unique_ptr<ChatModel>> make_replaying_model(const std::filesystem::path& file) {
  const auto text = read_file(file, max_recording_bytes);
  if (!text) return text.error();
  auto answers = parse_recording(*text, file.string());
  if (!answers) return answers.error();
  return std::unique_ptr<ChatModel>(
      std::make_unique<ReplayingModel>(file.string(), *std::move(answers)));
}

}  // namespace roomgen
