#pragma once

#include <array>
#include <cstdint>

namespace roomgen::lab::annealing {

/// Remembers what was found of a room's structure (World::structure): of the one that a move begins with, to which a move
/// that is taken back returns, and of another.
template <typename T>
class StructureMemo {
 public:
  template <typename Find>
  const T& get(std::uint64_t structure, std::uint64_t marked, Find&& find) {
    for (const auto& entry : entries_)
      if (entry.structure == structure) return entry.value;
    T value = find();  // may look into this memo's neighbours, not into this one
    Entry& entry = entries_[structure == marked ? 0 : 1];
    entry = {structure, std::move(value)};
    return entry.value;
  }

 private:
  struct Entry {
    std::uint64_t structure = ~std::uint64_t{0};
    T value{};
  };
  std::array<Entry, 2> entries_;
};

}  // namespace roomgen::lab::annealing
