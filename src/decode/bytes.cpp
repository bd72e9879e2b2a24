#include "bytes.h"

namespace roomgen::decode {

void put_text(std::string& bytes, std::string_view text) {
  put(bytes, static_cast<std::uint32_t>(text.size()));
  bytes.append(text);
}

std::string ByteReader::take_text(std::size_t most) {
  const std::size_t size = take<std::uint32_t>();
  if (size > most) fail();
  return std::string(whole_ ? take_bytes(size) : std::string_view());
}

std::string_view ByteReader::take_bytes(std::size_t size) {
  if (size > rest_.size()) fail();
  if (!whole_) return {};
  const auto taken = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return taken;
}

}  // namespace roomgen::decode
