#include "distinct.h"

#include <algorithm>

#include "suggestion.h"

namespace roomgen {

namespace {

// Layouts are looked up by the cells of this many groups.
constexpr std::size_t most_looked_up = 2;

bool look_alike(const Object& a, const Object& b) {
  return a.category == b.category && a.description == b.description && a.asset == b.asset && a.traits == b.traits &&
         (a.size - b.size).cwiseAbs().maxCoeff() < 1e-3 && a.relations == b.relations;
}

bool is_named(std::span<const Movable> movables, const Object& object) {
  return std::any_of(movables.begin(), movables.end(), [&](const Movable& other) {
    return depends_on(other.task.object, object.id);
  });
}

// FNV-1a over whole numbers.
std::uint64_t hashed(std::uint64_t hash, std::int64_t value) {
  return (hash ^ static_cast<std::uint64_t>(value)) * 0x100000001b3ull;
}

}  // namespace

DistinctLayouts::DistinctLayouts(std::span<const Movable> movables, const Apart& apart) : apart_(apart) {
  for (std::size_t i = 0; i < movables.size(); ++i) {
    const Object& object = movables[i].task.object;
    objects_.push_back(object);
    if (object.mount != Mount::floor) continue;
    const auto like = std::find_if(groups_.begin(), groups_.end(), [&](const Group& group) {
      return look_alike(objects_[group.front()], object) && !is_named(movables, object) &&
             !is_named(movables, objects_[group.front()]);
    });
    if (like == groups_.end()) groups_.push_back({i});
    else like->push_back(i);
  }
  std::stable_sort(groups_.begin(), groups_.end(), [&](const Group& a, const Group& b) {
    return movables[a.front()].domain.size() > movables[b.front()].domain.size();
  });
}

bool DistinctLayouts::add(const Poses& layout) {
  if (!is_new(layout, 0, 0)) return false;
  std::uint64_t hash = 0;
  for (std::size_t g = 0; g < std::min(most_looked_up, groups_.size()); ++g)
    for (std::int64_t index : cell_of(groups_[g], layout)) hash = hashed(hash, index);
  by_cells_[hash].push_back(static_cast<std::uint32_t>(layouts_.size()));
  layouts_.push_back(layout);
  return true;
}

// Asks all layouts in the cells about those of this one.
bool DistinctLayouts::is_new(const Poses& layout, std::size_t depth, std::uint64_t hash) const {
  if (depth < std::min(most_looked_up, groups_.size())) {
    const Cell cell = cell_of(groups_[depth], layout);
    for (std::int64_t x : {-1, 0, 1})
      for (std::int64_t y : {-1, 0, 1})
        if (!is_new(layout, depth + 1, hashed(hashed(hash, cell[0] + x), cell[1] + y))) return false;
    return true;
  }
  const auto found = by_cells_.find(hash);
  return found == by_cells_.end() || std::none_of(found->second.begin(), found->second.end(), [&](std::uint32_t k) {
           return alike(layout, layouts_[k]);
         });
}

// Alike groups have their centroids less than that far apart, since each of their things is.
DistinctLayouts::Cell DistinctLayouts::cell_of(const Group& group, const Poses& layout) const {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i : group) sum += layout[i].position;
  const Vec2 index = (sum / (static_cast<double>(group.size()) * apart_.metres)).array().floor();
  return {static_cast<std::int64_t>(index.x()), static_cast<std::int64_t>(index.y())};
}

bool DistinctLayouts::alike(const Poses& a, const Poses& b) const {
  return std::all_of(groups_.begin(), groups_.end(), [&](const Group& group) { return alike(group, a, b); });
}

bool DistinctLayouts::alike(std::size_t thing, const Pose& a, const Pose& b) const {
  return (a.position - b.position).squaredNorm() < apart_.metres * apart_.metres &&
         turn_between(objects_[thing], a.yaw, b.yaw) < apart_.radians;
}

// Is there a way to pair them off (augmenting paths, Kuhn 1955)?
bool DistinctLayouts::alike(const Group& group, const Poses& a, const Poses& b) const {
  if (group.size() == 1) return alike(group.front(), a[group.front()], b[group.front()]);
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> partner(group.size(), none);
  std::vector<bool> seen;
  const auto pair_off = [&](const auto& self, std::size_t i) -> bool {
    for (std::size_t j = 0; j < group.size(); ++j) {
      if (seen[j] || !alike(group[i], a[group[i]], b[group[j]])) continue;
      seen[j] = true;
      if (partner[j] == none || self(self, partner[j])) return partner[j] = i, true;
    }
    return false;
  };
  for (std::size_t i = 0; i < group.size(); ++i) {
    seen.assign(group.size(), false);
    if (!pair_off(pair_off, i)) return false;
  }
  return true;
}

}  // namespace roomgen
