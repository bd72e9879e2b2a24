#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "movable.h"
#include "roomgen/solve/solve.h"

namespace roomgen {

/// Layouts of which every two are distinct. Things that could change places unseen, like the chairs of a table, count
/// as one another; what has no front looks the same from several sides.
class DistinctLayouts {
 public:
  DistinctLayouts(std::span<const Movable> movables, const Apart& apart);

  /// Takes a layout in if it is distinct from all that were taken in before; true if so.
  bool add(const Poses& layout);

 private:
  using Group = std::vector<std::size_t>;  ///< things that could change places
  using Cell = std::array<std::int64_t, 2>;
  bool alike(const Poses& a, const Poses& b) const;
  bool alike(const Group& group, const Poses& a, const Poses& b) const;
  bool alike(std::size_t thing, const Pose& a, const Pose& b) const;
  Cell cell_of(const Group& group, const Poses& layout) const;
  bool is_new(const Poses& layout, std::size_t depth, std::uint64_t hash) const;

  std::vector<Object> objects_;
  std::vector<Group> groups_;  ///< those with the most freedom first
  Apart apart_;
  std::vector<Poses> layouts_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> by_cells_;
};

}  // namespace roomgen
