#include <algorithm>
#include <vector>

#include "clauses.h"

namespace roomgen {

namespace {

// Gives things to owners so that as many places as can be are filled: augmenting paths.
class Sharing {
 public:
  Sharing(std::vector<std::vector<std::size_t>> candidates, std::size_t things)
      : candidates_(std::move(candidates)), owner_of_(things, nobody) {}

  bool give(std::size_t place) {
    seen_.assign(owner_of_.size(), false);
    return augment(place);
  }

 private:
  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);

  bool augment(std::size_t place) {
    for (const std::size_t thing : candidates_[place]) {
      if (seen_[thing]) continue;
      seen_[thing] = true;
      if (owner_of_[thing] != nobody && !augment(owner_of_[thing])) continue;
      owner_of_[thing] = place;
      return true;
    }
    return false;
  }

  std::vector<std::vector<std::size_t>> candidates_;  ///< by place: the things that may fill it
  std::vector<std::size_t> owner_of_;                 ///< by thing: the place that it fills
  std::vector<bool> seen_;
};

}  // namespace

std::string each_fault(std::span<const Object* const> things, std::span<const std::string> owners, int count,
                       const std::function<bool(const Object&, const std::string&)>& belongs) {
  if (owners.empty()) return "there is nothing that could have one";
  const auto each = static_cast<std::size_t>(std::max(1, count));
  std::vector<std::vector<std::size_t>> candidates;
  for (const auto& owner : owners) {
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < things.size(); ++i)
      if (things[i]->id != owner && belongs(*things[i], owner)) own.push_back(i);
    candidates.insert(candidates.end(), each, own);
  }
  Sharing sharing(candidates, things.size());
  for (std::size_t place = 0; place < candidates.size(); ++place)
    if (!sharing.give(place))
      return owners[place / each] +
             (each > 1 ? " has not " + std::to_string(each) + " of its own" : " has none of its own");
  return "";
}

std::string corners_fault(std::span<const Object* const> things, const Room& room, int count,
                          const std::function<bool(const Object&)>& is_in_corner) {
  const Polygon& floor = room.polygon;
  std::vector<int> there(floor.size(), 0);
  for (const Object* object : things) {
    if (!is_in_corner(*object)) continue;
    const Vec2 at = object->position.head<2>();
    const auto nearest = std::min_element(floor.points.begin(), floor.points.end(), [&](const Vec2& a, const Vec2& b) {
      return (a - at).squaredNorm() < (b - at).squaredNorm();
    });
    ++there[static_cast<std::size_t>(nearest - floor.points.begin())];
  }
  int corners = 0, served = 0;
  for (std::size_t k = 0; k < floor.size(); ++k)
    if (floor.is_convex_corner(k)) ++corners, served += there[k] >= count;
  if (served == corners) return "";
  return std::to_string(corners - served) + " of " + std::to_string(corners) + " corners have none";
}

}  // namespace roomgen
