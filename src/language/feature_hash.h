#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace roomgen::language {

/// The number of a feature of a learned model: FNV-1a of its kind and of what was found.
class FeatureHash {
 public:
  explicit FeatureHash(std::size_t which) { add(static_cast<char>('A' + which)); }
  FeatureHash(std::size_t which, std::initializer_list<std::string_view> parts) : FeatureHash(which) {
    for (const auto part : parts) add(part);
  }
  FeatureHash& add(char c) {
    value_ = (value_ ^ static_cast<unsigned char>(c)) * 16777619u;
    return *this;
  }
  FeatureHash& add(std::string_view text) {
    for (const char c : text) add(c);
    return add('\x1f');
  }
  std::uint32_t value() const { return value_; }

 private:
  std::uint32_t value_ = 2166136261u;
};

}  // namespace roomgen::language
