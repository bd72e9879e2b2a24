#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace roomgen::decode {

// Plain values one after the other, as this machine keeps them: both ends are on the same one.

template <typename Value>
void put(std::string& bytes, const Value& value) {
  static_assert(std::is_trivially_copyable_v<Value>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void put_text(std::string& bytes, std::string_view text);

/// Values in a fixed layout without padding, as a block.
template <typename Value>
void put_all(std::string& bytes, const std::vector<Value>& values) {
  put(bytes, static_cast<std::uint32_t>(values.size()));
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
}

/// Takes values off bytes that anybody may have made. Once something is missing, all that follows is
/// zero or empty, and `whole()` false; nothing is made larger than the bytes that are there.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <typename Value>
  Value take() {
    Value value{};
    if (const auto bytes = take_bytes(sizeof value); !bytes.empty())
      std::memcpy(static_cast<void*>(&value), bytes.data(), sizeof value);
    return value;
  }

  /// As put_all() wrote them; at most `most`.
  template <typename Value>
  std::vector<Value> take_all(std::size_t most) {
    const std::size_t count = take<std::uint32_t>();
    if (count > most) fail();
    const auto bytes = whole_ ? take_bytes(count * sizeof(Value)) : std::string_view();
    std::vector<Value> values(bytes.size() / sizeof(Value));
    if (!bytes.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
    return values;
  }

  std::string take_text(std::size_t most);
  std::string_view take_bytes(std::size_t size);

  void fail() { whole_ = false; }
  bool whole() const { return whole_; }
  bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
  bool whole_ = true;
};

}  // namespace roomgen::decode
