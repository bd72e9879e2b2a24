#include "memory_io.h"

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <cstring>

#include "obj_numbers.h"

namespace roomgen::decode {

namespace {

class MemoryStream final : public Assimp::IOStream {
 public:
  explicit MemoryStream(std::string bytes) : bytes_(std::move(bytes)) {}

  std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t items = std::min(count, (bytes_.size() - position_) / size);
    std::memcpy(buffer, bytes_.data() + position_, items * size);
    position_ += items * size;
    return items;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    std::size_t base = 0;
    if (origin == aiOrigin_CUR) base = position_;
    if (origin == aiOrigin_END) base = bytes_.size();
    const std::size_t target = base + offset;
    if (target > bytes_.size()) return aiReturn_FAILURE;
    position_ = target;
    return aiReturn_SUCCESS;
  }
  std::size_t Tell() const override { return position_; }
  std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

}  // namespace

std::string_view MemoryIo::below_folder(std::string_view path) const {
  if (!folder_.empty() && path.starts_with(folder_ + "/")) path.remove_prefix(folder_.size() + 1);
  return path;
}

bool MemoryIo::Exists(const char* file) const {
  return !tree_.resolve(folder_, below_folder(file)).empty();
}

Assimp::IOStream* MemoryIo::Open(const char* file, const char* mode) {
  if (std::strchr(mode, 'w') || std::strchr(mode, 'a')) return nullptr;
  const std::string name = tree_.resolve(folder_, below_folder(file));
  if (name.empty()) return nullptr;
  auto bytes = tree_.read(name);
  if (bytes && extension_of(name) == "obj") *bytes = with_leading_zeros(*bytes);
  return bytes ? new MemoryStream(*std::move(bytes)) : nullptr;
}

void MemoryIo::Close(Assimp::IOStream* stream) {
  delete stream;
}

}  // namespace roomgen::decode
