#include "dwelling_openings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "scene/dwelling.h"
#include "usual_openings.h"

namespace roomgen::design {

namespace {

constexpr double between_openings = 0.1;  // of wall
constexpr double widest_passage = 1.5, least_passage = 0.9, passage_head = 2.2;
constexpr double entrance_width = 0.95, least_entrance = 0.7;

class Opener {
 public:
  Opener(std::vector<Room>& rooms, const std::vector<LaidRoom>& laid,
         const DwellingKinds& dwellings, const RoomKinds& kinds, Random random)
      : rooms_(rooms), laid_(laid), dwellings_(dwellings), kinds_(kinds), random_(random) {}

  void run() {
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      if (laid_[i].parent != LaidRoom::none) connect(i, laid_[i].parent);
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (is_open(i, k) && !are_joined(i, k)) add_passage(i, k);
    add_entrance();
    for (std::size_t i = 0; i < rooms_.size(); ++i) add_windows(i);
    number();
  }

 private:
  const RoomKind& kind(std::size_t room) const { return kinds_.get(rooms_[room].type); }

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

  std::optional<SharedStretch> longest_shared(std::size_t a, std::size_t b) const {
    std::optional<SharedStretch> best;
    for (const auto& stretch : shared_stretches(rooms_, a))
      if (stretch.room == b && (!best || stretch.to - stretch.from > best->to - best->from))
        best = stretch;
    return best;
  }

  // --- Between rooms --------------------------------------------------------------------------

  void connect(std::size_t room, std::size_t parent) {
    if (is_open(room, parent) && add_passage(room, parent)) return;
    const auto stretch = longest_shared(room, parent);
    if (!stretch) return;
    // Beside a wall of the room, else in the middle; where other ways in are least disturbed.
    const WallStretch free{stretch->wall, stretch->from, stretch->to};
    Opening door = usual_door(kind(room), free, rooms_[room].height, true);
    const auto [low, high] = ends_for(free, door.width());
    std::optional<Opening> best;
    int fewest = 0;
    for (const double part : {0.0, 1.0, 0.5, 0.75, 0.25}) {
      move_to(door, (1.0 - part) * low + part * high);
      door.hinge_at_from = part <= 0.5;
      const int conflicts = conflicts_of(room, door) + conflicts_of(parent, mirrored(room, door, parent));
      if (!best || conflicts < fewest) best = door, fewest = conflicts;
    }
    join(room, *best, parent);
  }

  bool add_passage(std::size_t room, std::size_t other) {
    const auto stretch = longest_shared(room, other);
    if (!stretch) return false;
    const double length = stretch->to - stretch->from;
    const double width = std::min(widest_passage, length - 2.0 * corner_offset);
    if (width < least_passage) return false;
    Opening passage = opening_at(OpeningType::passage, stretch->wall,
                                 stretch->from + 0.5 * (length - width), width, passage_head);
    if (conflicts_of(room, passage) + conflicts_of(other, mirrored(room, passage, other)) > 0)
      return false;
    join(room, passage, other);
    return true;
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

  int conflicts_of(std::size_t room, const Opening& made) const {
    int conflicts = 0;
    for (const auto& other : rooms_[room].openings) {
      if (other.wall == made.wall && made.from < other.to + between_openings &&
          other.from < made.to + between_openings)
        conflicts += 10;
      else if (other.is_entrance() && overlaps(door_clearance(rooms_[room], made),
                                               door_clearance(rooms_[room], other)))
        ++conflicts;
    }
    return conflicts;
  }

  // --- Outwards -------------------------------------------------------------------------------

  // Parts of walls behind which nobody lives and which have no opening yet.
  std::vector<WallStretch> outer_walls(std::size_t room) const {
    std::vector<WallStretch> free;
    const auto shared = shared_stretches(rooms_, room);
    for (std::size_t k = 0; k < rooms_[room].polygon.size(); ++k) {
      std::vector<WallStretch> parts = {whole_wall(rooms_[room], k)};
      for (const auto& stretch : shared)
        if (stretch.wall == k)
          cut(parts, stretch.from - wall_thickness, stretch.to + wall_thickness);
      for (const auto& other : rooms_[room].openings)
        if (other.wall == k) cut(parts, other.from - between_openings, other.to + between_openings);
      free.insert(free.end(), parts.begin(), parts.end());
    }
    return free;
  }

  // Into the hub; a hall is entered at its end.
  void add_entrance() {
    std::size_t hub = 0;
    for (std::size_t i = 0; i < laid_.size(); ++i)
      if (laid_[i].parent == LaidRoom::none) hub = i;
    std::optional<Opening> best;
    double least = 1e300;
    for (const auto& part : outer_walls(hub)) {
      const double width = door_width(entrance_width, part);
      if (width < least_entrance) continue;
      const auto [low, high] = ends_for(part, width);
      for (const double from : {low, high}) {
        Opening door = opening_at(OpeningType::door, part.wall, from, width, default_door_head);
        door.hinge_at_from = from <= 0.5 * (part.from + part.to);
        // Long walls are for windows and furniture.
        const double cost = 10.0 * conflicts_of(hub, door) + part.length();
        if (cost < least - 1e-9) best = door, least = cost;
      }
    }
    if (best) rooms_[hub].openings.push_back(*best);
  }

  void add_windows(std::size_t room) {
    const RoomKind& known = kind(room);
    Random random = random_.fork("windows of " + rooms_[room].id);
    int count = random.integer(known.windows.low, known.windows.high);
    auto free = outer_walls(room);
    std::stable_sort(free.begin(), free.end(),
                     [](const WallStretch& a, const WallStretch& b) { return a.length() > b.length() + 1e-6; });
    std::vector<std::size_t> used;
    for (const auto& part : free) {
      if (count <= 0) return;
      const double width = std::min(usual_window_width(known, false, random),
                                    part.length() - 2.0 * window_margin);
      if (width < least_window || std::find(used.begin(), used.end(), part.wall) != used.end())
        continue;
      const Opening window = usual_window(known, part.wall, middle_for(part, width), width,
                                          rooms_[room].height);
      rooms_[room].openings.push_back(window);
      used.push_back(part.wall);
      --count;
    }
  }

  void number() {
    for (auto& room : rooms_) {
      std::size_t doors = 0, windows = 0, passages = 0;
      for (auto& made : room.openings) {
        std::size_t& next = made.type == OpeningType::door     ? doors
                            : made.type == OpeningType::window ? windows
                                                               : passages;
        made.id = std::string(name(made.type)) + "-" + std::to_string(next++);
      }
    }
  }

  std::vector<Room>& rooms_;
  const std::vector<LaidRoom>& laid_;
  const DwellingKinds& dwellings_;
  const RoomKinds& kinds_;
  Random random_;
};

}  // namespace

void open_up(std::vector<Room>& rooms, const std::vector<LaidRoom>& laid,
             const DwellingKinds& dwellings, const RoomKinds& kinds, Random random) {
  Opener(rooms, laid, dwellings, kinds, random).run();
}

}  // namespace roomgen::design
