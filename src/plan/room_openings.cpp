#include "room_openings.h"

#include <algorithm>
#include <array>
#include <utility>

#include "opening_plan.h"
#include "scene/opening_kind.h"
#include "scene/wall_sides.h"

namespace roomgen::plan {

namespace {

constexpr double least_bay = 0.5;  // of a wall that is worth glazing

bool has_entrance(const std::vector<Opening>& openings) {
  return std::any_of(openings.begin(), openings.end(),
                     [](const Opening& opening) { return opening.is_entrance(); });
}

/// The openings that one room needs.
class RoomNeeds {
 public:
  RoomNeeds(const Room& room, const brief::RoomKind& kind, const std::vector<std::size_t>& glazed)
      : room_(room), kind_(kind), glazed_(glazed), walls_(whole_walls(room)) {}

  /// A door in a wall that is drawn, bays and windows.
  void add_usual(const RoomOpenings& openings, Random& random) {
    add_door(openings, random);
    const std::size_t door_wall = needs_.front().walls.front();
    // Of walls that suit equally well those that come first, going round from the door.
    const std::size_t n = walls_.size(), step = random.chance(0.5) ? 1 : n - 1;
    for (std::size_t k = 0; k < n; ++k) order_.push_back((door_wall + k * step) % n);
    for (const std::size_t wall : glazed_)
      if (wall != door_wall && walls_[wall].length() > least_bay) add_glazing(wall);
    // A bay is one of the windows.
    for (int left = openings.windows - (needs_.size() > 1 ? 1 : 0); left > 0; --left)
      add_window(openings, random);
  }

  void add_wish(const brief::OpeningWish& wish, Random& random) {
    const auto& kinds = OpeningKinds::built_in();
    const OpeningKind* kind = kinds ? kinds->find(wish.kind) : nullptr;
    if (!kind) return;
    OpeningNeed need = wished_opening(wish, *kind, kind_, room_.height, random);
    for (int i = 0; i < wish.count; ++i) {
      need.walls = told_walls(wish, static_cast<std::size_t>(i));
      needs_.push_back(need);
    }
  }

  void remove_entrances() {
    std::erase_if(needs_, [](const OpeningNeed& need) { return !need.is_window(); });
  }

  OpeningPlaces places() const {
    OpeningPlaces places;
    for (const std::size_t wall : order_) places.stretches.push_back(walls_[wall]);
    return places;
  }

  const std::vector<OpeningNeed>& all() const { return needs_; }

 private:
  void add_door(const RoomOpenings& openings, Random& random) {
    OpeningNeed need = usual_door(kind_, room_.height);
    auto walls = door_walls(need);
    if (openings.front_door) keep_front(walls);
    squeeze(need, walls_);
    if (kind_.door_on_long_side) {
      // Balconies are entered through the middle of the wall of the dwelling.
      need.walls = {walls[random.chance(0.5) ? walls.size() - 1 : 0]};
      need.middles = {random.uniform(0.36, 0.64)};
    } else {
      need.walls = {random.pick(walls)};
      const double end = random.chance(0.5) ? 0.0 : 1.0;
      need.middles = {end, 1.0 - end, 0.5};
    }
    needs_.push_back(std::move(need));
  }

  void keep_front(std::vector<std::size_t>& walls) const {
    std::vector<std::size_t> front;
    for (const std::size_t wall : walls_on_side(room_.polygon, 0))
      if (std::find(walls.begin(), walls.end(), wall) != walls.end()) front.push_back(wall);
    if (!front.empty()) walls = std::move(front);
  }

  // Walls that take a door and before which there is room for it; the longest ones if none does.
  std::vector<std::size_t> door_walls(const OpeningNeed& door) const {
    double longest = 0.0;
    for (const auto& wall : walls_) longest = std::max(longest, wall.length());
    std::vector<std::size_t> walls, long_ones;
    for (const auto& wall : walls_) {
      if (wall.length() > longest - 1e-6) long_ones.push_back(wall.wall);
      if (!is_glazed(wall.wall) && wall.length() >= door.opening.width() + 2.0 * door.clear &&
          contains(room_.polygon, door_clearance(room_, placed_alone(room_, door, wall))))
        walls.push_back(wall.wall);
    }
    return walls.empty() || kind_.door_on_long_side ? long_ones : walls;
  }

  void add_glazing(std::size_t wall) {
    OpeningNeed need = glazing(kind_, walls_[wall].length(), room_.height);
    need.walls = {wall};
    needs_.push_back(std::move(need));
  }

  void add_window(const RoomOpenings& openings, Random& random) {
    OpeningNeed need = usual_window(kind_, openings.wide, room_.height, random);
    need.middles = {random.uniform(0.42, 0.58)};
    need.asked = openings.counted;
    needs_.push_back(std::move(need));
  }

  // The i-th of those that are wished for together.
  std::vector<std::size_t> told_walls(const brief::OpeningWish& wish, std::size_t i) const {
    if (!wish.sides.empty())
      return walls_on_side(room_.polygon, wish.sides[i % wish.sides.size()]);
    if (wish.walls == 0) return {};
    // "on two walls": each in turn.
    auto longest = order_;
    std::stable_sort(longest.begin(), longest.end(), [&](std::size_t a, std::size_t b) {
      return walls_[a].length() > walls_[b].length() + 1e-9;
    });
    const std::size_t count = std::min(static_cast<std::size_t>(wish.walls), longest.size());
    return {longest[i % count]};
  }

  bool is_glazed(std::size_t wall) const {
    return std::find(glazed_.begin(), glazed_.end(), wall) != glazed_.end();
  }

  const Room& room_;
  const brief::RoomKind& kind_;
  const std::vector<std::size_t>& glazed_;
  std::vector<WallStretch> walls_;
  std::vector<std::size_t> order_;
  std::vector<OpeningNeed> needs_;
};

}  // namespace

void plan_openings(Room& room, const brief::RoomKind& kind, const std::vector<std::size_t>& glazed,
                   const RoomOpenings& openings, Random& random, std::vector<std::string>& notes) {
  RoomNeeds usual(room, kind, glazed);
  usual.add_usual(openings, random);
  std::vector<brief::OpeningWish> windows = openings.wishes;
  std::erase_if(windows,
                [](const brief::OpeningWish& wish) { return wish.type != OpeningType::window; });
  // A room that nobody would enter has the usual door.
  const std::array attempts = {openings.wishes, windows, std::vector<brief::OpeningWish>()};
  for (const auto& wishes : attempts) {
    Random told = random.fork("told openings");
    RoomNeeds needs = usual;
    if (wishes.size() > windows.size()) needs.remove_entrances();
    for (const auto& wish : wishes) needs.add_wish(wish, told);
    Room planned = room;
    planned.openings = place_openings(room, needs.places(), needs.all(), told, notes);
    name_openings(planned);
    const bool is_sound = check(planned) && has_entrance(planned.openings);
    if (!is_sound && !wishes.empty()) continue;
    room = std::move(planned);
    return;
  }
}

void ensure_door(Room& room, const brief::RoomKind& kind, std::vector<std::string>& notes) {
  if (has_entrance(room.openings)) return;
  const OpeningPlaces places{bare_walls(room), nullptr};
  OpeningNeed need = usual_door(kind, room.height);
  squeeze(need, places.stretches);
  need.middles = {0.0, 1.0, 0.5};
  for (auto& door : place_openings(room, places, {need}, Random(0), notes)) {
    notes.push_back("the floor plan has no door; one was put into wall " + std::to_string(door.wall));
    room.openings.push_back(std::move(door));
  }
  name_openings(room);
}

}  // namespace roomgen::plan
