#include <nlohmann/json.hpp>
#include <utility>

#include "base/json_reader.h"
#include "chat_question.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/chat/chat_model.h"

namespace roomgen {

namespace {

namespace fs = std::filesystem;

class CachingModel final : public ChatModel {
 public:
  CachingModel(std::unique_ptr<ChatModel> inner, fs::path folder, std::string source)
      : inner_(std::move(inner)), folder_(std::move(folder)), source_(std::move(source)) {}

  Result<ChatReply> chat(const ChatRequest& request) override {
    const fs::path file = file_of(request);
    if (auto kept = load(file)) return *std::move(kept);
    auto answer = inner_->chat(request);
    if (answer) store(file, *answer);
    return answer;
  }

 private:
  fs::path file_of(const ChatRequest& request) const {
    Json question = question_json(request);
    question["source"] = source_;
    return folder_ / (question_key(question) + ".json");
  }

  static std::optional<ChatReply> load(const fs::path& file) {
    const auto text = read_file(file);
    if (!text) return std::nullopt;
    const auto json = parse_json(*text, file.string());
    if (!json) return std::nullopt;
    JsonReader::Problems problems(file.string());
    ChatReply reply = read_reply(JsonReader(*json, problems));
    if (problems.first()) return std::nullopt;
    reply.input_tokens = reply.output_tokens = 0;
    reply.seconds = 0.0;
    reply.attempts = 0;
    return reply;
  }

  // A cache that cannot be written is only slower.
  void store(const fs::path& file, const ChatReply& reply) const {
    if (make_folder(folder_)) (void)write_file(file, dump_json(reply_json(reply)));
  }

  std::unique_ptr<ChatModel> inner_;
  fs::path folder_;
  std::string source_;
};

}  // namespace

std::unique_ptr<ChatModel> make_caching_model(std::unique_ptr<ChatModel> inner,
                                              const fs::path& folder, std::string source) {
  return std::make_unique<CachingModel>(std::move(inner), folder, std::move(source));
}

}  // namespace roomgen
