#include <utility>

#include "base/sha256.h"
#include "chat_recording.h"
#include "roomgen/base/file.h"
#include "roomgen/chat/chat_model.h"

namespace roomgen {

namespace {

// A picture that is there already is the same one: its name is what it holds.
Status keep_picture(const std::filesystem::path& folder, const std::string& bytes) {
  const bool is_png = bytes.starts_with("\x89PNG");
  const auto file = folder / (sha256_hex(bytes) + (is_png ? ".png" : ".jpg"));
  std::error_code error;
  if (std::filesystem::exists(file, error)) return {};
  if (auto status = make_folder(folder); !status) return status;
  return write_file(file, bytes);
}

class RecordingModel final : public ChatModel {
 public:
  RecordingModel(std::unique_ptr<ChatModel> inner, AppendedFile file, std::filesystem::path pictures)
      : inner_(std::move(inner)), file_(std::move(file)), pictures_(std::move(pictures)) {}

  Result<ChatReply> chat(const ChatRequest& request) override {
    auto answer = inner_->chat(request);
    if (!answer && answer.error().kind == Error::Kind::cancelled) return answer;
    for (const auto& message : request.messages)
      for (const auto& picture : message.images)
        if (auto status = keep_picture(pictures_, picture); !status)
          return with_context(status.error(), "the pictures of the recording");
    if (auto status = file_.append(recorded_line(request, answer)); !status) return status.error();
    return answer;
  }

 private:
  std::unique_ptr<ChatModel> inner_;
  AppendedFile file_;
  std::filesystem::path pictures_;
};

}  // namespace

Result<std::unique_ptr<ChatModel>> make_recording_model(std::unique_ptr<ChatModel> inner,
                                                        const std::filesystem::path& path) {
  auto file = AppendedFile::open(path);
  if (!file) return with_context(file.error(), "the recording");
  return std::unique_ptr<ChatModel>(
      std::make_unique<RecordingModel>(
      std::move(inner), *std::move(file), std::filesystem::path(path) += ".pictures"));
}

}  // namespace roomgen
