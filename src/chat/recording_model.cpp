#include <utility>

#include "chat_recording.h"
#include "roomgen/base/file.h"
#include "roomgen/chat/chat_model.h"

namespace roomgen {

namespace {

class RecordingModel final : public ChatModel {
 public:
  RecordingModel(std::unique_ptr<ChatModel> inner, AppendedFile file)
      : inner_(std::move(inner)), file_(std::move(file)) {}

  Result<ChatReply> chat(const ChatRequest& request) override {
    auto answer = inner_->chat(request);
    if (!answer && answer.error().kind == Error::Kind::cancelled) return answer;
    if (auto status = file_.append(recorded_line(request, answer)); !status) return status.error();
    return answer;
  }

 private:
  std::unique_ptr<ChatModel> inner_;
  AppendedFile file_;
};

}  // namespace

Result<std::unique_ptr<ChatModel>> make_recording_model(std::unique_ptr<ChatModel> inner,
                                                        const std::filesystem::path& path) {
  auto file = AppendedFile::open(path);
  if (!file) return with_context(file.error(), "the recording");
  return std::unique_ptr<ChatModel>(
      std::make_unique<RecordingModel>(std::move(inner), *std::move(file)));
}

}  // namespace roomgen
