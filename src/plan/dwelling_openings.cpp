#include "dwelling_openings.h"

#include <algorithm>
#include <optional>
#include <string>

#include "opening_plan.h"
#include "scene/dwelling.h"

namespace roomgen::plan {

namespace {

constexpr double widest_passage = 1.5, least_passage = 0.9, passage_head = 2.2;
constexpr double entrance_width = 0.95, least_entrance = 0.7;

class Opener {
 public:
  Opener(std::vector<Room>& rooms, const std::vector<LaidRoom>& laid,
         const brief::DwellingKinds& dwellings, const brief::RoomKinds& kinds, Random random)
      : rooms_(rooms), laid_(laid), dwellings_(dwellings), kinds_(kinds), random_(random) {}

  void run() {
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      if (laid_[i].parent != LaidRoom::none) connect(i, laid_[i].parent);
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (is_open(i, k) && !are_joined(i, k)) add_passage(i, k);
    add_entrance();
    for (std::size_t i = 0; i < rooms_.size(); ++i) add_windows(i);
    for (auto& room : rooms_) name_openings(room);
  }

 private:
  const brief::RoomKind& kind(std::size_t room) const { return kinds_.get(rooms_[room].type); }

  bool is_open(std::size_t a, std::size_t b) const {
    const auto opens = [&](const Room& from, const Room& to) {
      const auto found = dwellings_.rooms.find(from.type);
      if (found == dwellings_.rooms.end()) return false;
      const auto& list = found->second.passage;
      return std::find(list.begin(), list.end(), to.type) != list.end();
    };
    return opens(rooms_[a], rooms_[b]) || opens(rooms_[b], rooms_[a]);
  }

  bool are_joined(std::size_t a, std::size_t b) const {
    return std::any_of(rooms_[a].openings.begin(), rooms_[a].openings.end(),
                       [&](const Opening& o) { return o.leads_to == rooms_[b].id; });
  }

  // Where the two have most wall in common.
  std::optional<WallStretch> longest_shared(std::size_t a, std::size_t b) const {
    std::optional<WallStretch> best;
    for (const auto& stretch : shared_stretches(rooms_, a))
      if (stretch.room == b && (!best || stretch.to - stretch.from > best->length()))
        best = {stretch.wall, stretch.from, stretch.to};
    return best;
  }

  // --- Between rooms --------------------------------------------------------------------------

  void connect(std::size_t room, std::size_t parent) {
    if (is_open(room, parent) && add_passage(room, parent)) return;
    const auto stretch = longest_shared(room, parent);
    if (!stretch) return;
    OpeningNeed door = usual_door(kind(room), rooms_[room].height);
    squeeze(door, {&*stretch, 1});
    // Beside a wall of the room, else in the middle; where other ways in are least disturbed.
    door.middles = {0.0, 1.0, 0.5, 0.75, 0.25};
    join(room, placed_between(room, door, *stretch, parent), parent);
  }

  // Nothing of what is there gives way to a passage.
  bool add_passage(std::size_t room, std::size_t other) {
    const auto stretch = longest_shared(room, other);
    if (!stretch || stretch->length() < least_passage + 2.0 * corner_offset) return false;
    OpeningNeed passage;
    passage.opening.type = OpeningType::passage;
    passage.opening.to = widest_passage;
    passage.opening.head = passage_head;
    passage.least = least_passage;
    passage.clear = corner_offset;
    passage.middles = {0.5};
    const Opening placed = placed_between(room, passage, *stretch, other);
    if (conflicts(rooms_[room], placed) + conflicts(rooms_[other], mirrored(room, placed, other)) > 0)
      return false;
    join(room, placed, other);
    return true;
  }

  Opening placed_between(std::size_t room, const OpeningNeed& need, const WallStretch& stretch,
                         std::size_t other) const {
    return placed_alone(rooms_[room], need, stretch, [&](const Opening& opening) {
      return conflicts(rooms_[other], mirrored(room, opening, other));
    });
  }

  // The same hole as the other room has it: its wall runs the other way.
  Opening mirrored(std::size_t room, const Opening& own, std::size_t other) const {
    const Segment line = segment(rooms_[room], own);
    Opening seen = own;
    double nearest = 1e300;
    const Polygon& polygon = rooms_[other].polygon;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Segment wall = polygon.edge(k);
      const double apart = distance(wall, line.middle());
      if (apart >= nearest || wall.direction().dot(line.direction()) > 0) continue;
      nearest = apart;
      seen.wall = k;
      seen.from = (line.b - wall.a).dot(wall.direction());
      seen.to = (line.a - wall.a).dot(wall.direction());
    }
    seen.hinge_at_from = !own.hinge_at_from;
    seen.swing = own.swing == DoorSwing::in    ? DoorSwing::out
                 : own.swing == DoorSwing::out ? DoorSwing::in
                                               : own.swing;
    return seen;
  }

  void join(std::size_t room, Opening own, std::size_t other) {
    Opening seen = mirrored(room, own, other);
    own.leads_to = rooms_[other].id;
    seen.leads_to = rooms_[room].id;
    rooms_[room].openings.push_back(std::move(own));
    rooms_[other].openings.push_back(std::move(seen));
  }

  // --- Outwards -------------------------------------------------------------------------------

  // Parts of walls behind which nobody lives and which have no opening yet.
  std::vector<WallStretch> outer_walls(std::size_t room) const {
    auto free = bare_walls(rooms_[room]);
    for (const auto& stretch : shared_stretches(rooms_, room))
      cut(free, stretch.wall, stretch.from - wall_thickness, stretch.to + wall_thickness);
    return free;
  }

  void place_outwards(std::size_t room, std::vector<OpeningNeed> needs) {
    std::vector<std::string> notes;  // nobody asked for them
    const auto placed = place_openings(rooms_[room], {outer_walls(room), nullptr}, std::move(needs),
                                       random_, notes);
    rooms_[room].openings.insert(rooms_[room].openings.end(), placed.begin(), placed.end());
  }

  // Into the hub; a hall is entered at its end.
  void add_entrance() {
    std::size_t hub = 0;
    for (std::size_t i = 0; i < laid_.size(); ++i)
      if (laid_[i].parent == LaidRoom::none) hub = i;
    OpeningNeed door = plain_door(entrance_width, least_entrance, rooms_[hub].height);
    door.middles = {0.0, 1.0};
    // Long walls are for windows and furniture.
    door.likes_length = -1.0;
    place_outwards(hub, {door});
  }

  void add_windows(std::size_t room) {
    const brief::RoomKind& known = kind(room);
    Random random = random_.fork("windows of " + rooms_[room].id);
    std::vector<OpeningNeed> windows;
    for (int left = random.integer(known.windows.low, known.windows.high); left > 0; --left)
      windows.push_back(usual_window(known, false, rooms_[room].height, random));
    place_outwards(room, std::move(windows));
  }

  std::vector<Room>& rooms_;
  const std::vector<LaidRoom>& laid_;
  const brief::DwellingKinds& dwellings_;
  const brief::RoomKinds& kinds_;
  Random random_;
};

}  // namespace

void open_up(std::vector<Room>& rooms, const std::vector<LaidRoom>& laid,
             const brief::DwellingKinds& dwellings, const brief::RoomKinds& kinds, Random random) {
  Opener(rooms, laid, dwellings, kinds, random).run();
}

}  // namespace roomgen::plan
