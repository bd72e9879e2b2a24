#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace roomgen::lab::annealing {

/// The lasting number of a thing while it is in the room; the room, doors and windows have numbers too.
using Slot = int;
inline constexpr int most_things = 320;
inline constexpr int most_slots = 384;  ///< with the room's own parts
inline constexpr Slot room_slot = most_things;
inline constexpr Slot first_opening_slot = room_slot + 1;

/// A set of slots.
class SlotSet {
 public:
  void insert(Slot slot) { words_[word(slot)] |= bit(slot); }
  void erase(Slot slot) { words_[word(slot)] &= ~bit(slot); }
  bool has(Slot slot) const { return (words_[word(slot)] & bit(slot)) != 0; }

  int size() const {
    int sum = 0;
    for (const auto w : words_) sum += std::popcount(w);
    return sum;
  }
  bool empty() const {
    for (const auto w : words_)
      if (w) return false;
    return true;
  }
  SlotSet& operator&=(const SlotSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
    return *this;
  }
  SlotSet& operator|=(const SlotSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    return *this;
  }
  bool operator==(const SlotSet&) const = default;

  /// In ascending order.
  template <typename Visit>
  void each(Visit&& visit) const {
    for (std::size_t i = 0; i < words_.size(); ++i)
      for (std::uint64_t left = words_[i]; left; left &= left - 1)
        visit(static_cast<Slot>(64 * i) + std::countr_zero(left));
  }

 private:
  static std::size_t word(Slot slot) { return static_cast<std::size_t>(slot) / 64; }
  static std::uint64_t bit(Slot slot) { return std::uint64_t{1} << (slot % 64); }

  std::array<std::uint64_t, most_slots / 64> words_{};
};

}  // namespace roomgen::lab::annealing
