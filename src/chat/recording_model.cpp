#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "chat_recording.h"
#include "roomgen/chat/chat_decorators.h"

namespace roomgen {

namespace {

Error file_error(const std::filesystem::path& path) {
  return {Error::Kind::io, path.string() + ": cannot write the recording: " + std::strerror(errno)};
}

class RecordingModel final : public ChatModel {
 public:
  RecordingModel(std::unique_ptr<ChatModel> inner, std::filesystem::path path, int descriptor)
      : inner_(std::move(inner)), path_(std::move(path)), descriptor_(descriptor) {}
  RecordingModel(const RecordingModel&) = delete;
  RecordingModel& operator=(const RecordingModel&) = delete;
  ~RecordingModel() override { ::close(descriptor_); }

  Result<ChatReply> chat(const ChatRequest& request) override {
    auto answer = inner_->chat(request);
    if (!answer && answer.error().kind == Error::Kind::cancelled) return answer;
    if (!append(recorded_line(request, answer))) return file_error(path_);
    return answer;
  }

 private:
  bool append(std::string_view bytes) const {
    while (!bytes.empty()) {
      const auto count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }

  std::unique_ptr<ChatModel> inner_;
  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace

Result<std::unique_ptr<ChatModel>> make_recording_model(std::unique_ptr<ChatModel> inner,
                                                        const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor < 0) return file_error(file);
  return std::unique_ptr<ChatModel>(
      std::make_unique<RecordingModel>(std::move(inner), file, descriptor));
}

}  // namespace roomgen
