#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace roomgen::shape {

/// Gives equal positions equal numbers, counting from 0 in the order of their appearance.
class Weld {
 public:
  std::uint32_t operator()(const Eigen::Vector3f& position) {
    // Adding zero makes -0 and 0 one value.
    const Key key{std::bit_cast<std::uint32_t>(position.x() + 0.0f),
                  std::bit_cast<std::uint32_t>(position.y() + 0.0f),
                  std::bit_cast<std::uint32_t>(position.z() + 0.0f)};
    const auto [place, is_new] =
        numbers_.try_emplace(key, static_cast<std::uint32_t>(positions_.size()));
    if (is_new) positions_.push_back(position);
    return place->second;
  }
  const std::vector<Eigen::Vector3f>& positions() const { return positions_; }

 private:
  struct Key {
    std::uint32_t x, y, z;
    bool operator==(const Key&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t h = key.x * 0x9e3779b97f4a7c15ull;
      h = (h ^ (h >> 29) ^ key.y) * 0xbf58476d1ce4e5b9ull;
      h = (h ^ (h >> 32) ^ key.z) * 0x94d049bb133111ebull;
      return static_cast<std::size_t>(h ^ (h >> 31));
    }
  };
  std::unordered_map<Key, std::uint32_t, Hash> numbers_;
  std::vector<Eigen::Vector3f> positions_;
};

}  // namespace roomgen::shape
