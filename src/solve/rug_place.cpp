#include "rug_place.h"

#include <algorithm>
#include <array>

#include "rug_cuts.h"
#include "scene/judgement.h"

namespace roomgen {

namespace {

// By how much a rug may be larger or smaller than planned, and if nothing else will do.
constexpr std::array<RugRange, 2> free_ranges = {{{0.5, 1.8}, {0.35, 2.5}}};
constexpr std::array<RugRange, 2> told_ranges = {{{0.9, 1.1}, {0.65, 1.25}}};
constexpr double within = 1e-3;      // a part may reach this far over the edge of a rug that it is on
constexpr double clear = 0.01;       // between a rug and what is not on it
constexpr double room_slack = 5e-4;  // as the layout has it

// What is lost, in metres of change.
constexpr double asked_relation = 3.0;
constexpr double usual_relation = 0.3;
constexpr double laid_under = 0.4;  // a thing is beside the rug that was laid under it
constexpr double slid_under = 0.25;  // a thing is on the rug that has nothing to do with it

/// A relation of the rug, or of another thing to it.
struct Tie {
  ResolvedRelation relation;
  std::optional<Subject> other;  ///< whose relation it is, if it is not the rug's
  double weight = 0.0;           ///< what its loss costs; 0 if it did not hold before
};

bool holds(const Tie& tie, const Footprint& rug, const Object& object, const Room& room) {
  if (!tie.other) return judge(tie.relation, {rug, bottom(object), top(object)}, room).held;
  ResolvedRelation relation = tie.relation;
  relation.targets = {rug};
  return judge(relation, *tie.other, room).held;
}

std::vector<Tie> ties_of(const Object& rug, const RugWish& wish, const Room& room,
                         std::span<const Object> objects, const KindTable& kinds) {
  std::vector<Tie> ties;
  const auto own = resolve(rug, room, objects, kinds);
  for (std::size_t i = 0; i < own.size(); ++i)
    ties.push_back({own[i], {}, static_cast<int>(i) < wish.wishes ? asked_relation : usual_relation});
  for (const auto& other : objects) {
    if (other.id == rug.id || !depends_on(other, rug.id)) continue;
    const auto relations = resolve(other, room, objects, kinds);
    for (std::size_t i = 0; i < relations.size(); ++i)
      if (other.relations[i].target == rug.id)
        ties.push_back({relations[i], Subject{footprint(other), bottom(other), top(other)}, asked_relation});
  }
  std::erase_if(ties, [&](const Tie& tie) { return !holds(tie, footprint(rug), rug, room); });
  return ties;
}

// Where people come in: the clearance, and at least as deep as the door is wide.
Footprint area_before(const Room& room, const Opening& door) {
  const Segment line = segment(room, door);
  const Vec2 normal = inward(room, door);
  const double depth = std::max(door.width(), 2.0 * door_clearance(room, door).half().y());
  return Footprint(line.middle() + 0.5 * depth * normal, {door.width(), depth}, yaw_facing(normal));
}

/// The search for the place of one rug.
class RugPlace {
 public:
  RugPlace(const Object& rug, const RugWish& wish, const Room& room, std::span<const Object> objects,
           std::span<const LowThing> things, const KindTable& kinds)
      : rug_(rug), room_(room), own_(footprint(rug)), ties_(ties_of(rug, wish, room, objects, kinds)) {
    for (const auto& thing : things) add(thing);
    find_its_group(things);
    for (const auto& opening : room.openings)
      if (opening.is_entrance() && !overlaps(own_, area_before(room, opening), within))
        kept_clear_.push_back(area_before(room, opening));
  }

  std::optional<Object> best(const RugRange& range) const {
    std::optional<Object> best;
    double least = 1e300;
    for (const auto& cut : cuts(range)) {
      if (cut.change >= least) break;
      const Object object = cut_to(cut);
      const auto lost = loss(footprint(object));
      if (lost && cut.change + *lost < least) best = object, least = cut.change + *lost;
    }
    return best;
  }

 private:
  struct Standing {
    std::vector<Footprint> parts;
    bool may_be_on = true;
    bool belongs = false;  ///< the rug was laid under it
  };

  void add(const LowThing& thing) {
    Standing standing;
    standing.parts = thing.parts;
    standing.may_be_on = thing.may_be_lifted;
    standing.belongs = contains(own_, footprint(*thing.object).center());
    for (const auto& part : thing.parts) {
      Bounds2 box;
      for (const auto& corner : part.outline()) box.add(own_.to_local(corner));
      boxes_.push_back(box);
    }
    things_.push_back(std::move(standing));
  }

  // What is partly over the rug goes with what is over it: chairs with their table.
  void find_its_group(std::span<const LowThing> things) {
    std::vector<std::string> over;
    for (std::size_t i = 0; i < things.size(); ++i)
      if (things_[i].belongs) over.push_back(things[i].object->id);
    for (std::size_t i = 0; i < things.size(); ++i)
      if (overlaps(footprint(*things[i].object), own_))
        things_[i].belongs |= std::any_of(over.begin(), over.end(), [&](const std::string& id) {
          return depends_on(*things[i].object, id);
        });
  }

  std::vector<RugCut> cuts(const RugRange& range) const {
    std::vector<Vec2> corners;
    for (const auto& point : room_.polygon.points) corners.push_back(own_.to_local(point));
    return rug_cuts(2.0 * own_.half(), own_.round(), range, boxes_, corners);
  }

  Object cut_to(const RugCut& cut) const {
    Object object = rug_;
    object.position.head<2>() = own_.to_world(0.5 * (cut.area.low + cut.area.high));
    object.size.head<2>() = cut.area.size();
    return with_rounded_pose(std::move(object));
  }

  // Nothing if something would stand partly on it, or it may not lie there.
  std::optional<double> loss(const Footprint& rug) const {
    double sum = 0.0;
    for (const auto& thing : things_) {
      const RugStand stand = stand_of(thing.parts, rug, clear);
      const bool on = stand == RugStand::on;
      if (stand == RugStand::partly || (on && !thing.may_be_on)) return std::nullopt;
      if (on != thing.belongs) sum += on ? slid_under : laid_under;
    }
    if (!contains(room_.polygon, rug, room_slack)) return std::nullopt;
    for (const auto& area : kept_clear_)
      if (overlaps(rug, area, within)) return std::nullopt;
    for (const auto& tie : ties_)
      if (!holds(tie, rug, rug_, room_)) sum += tie.weight;
    return sum;
  }

  const Object& rug_;
  const Room& room_;
  Footprint own_;
  std::vector<Tie> ties_;
  std::vector<Standing> things_;
  std::vector<Bounds2> boxes_;          // of all their parts, in the rug's frame
  std::vector<Footprint> kept_clear_;
};

}  // namespace

RugStand stand_of(std::span<const Footprint> parts, const Footprint& rug, double distance) {
  const bool beside = std::none_of(parts.begin(), parts.end(), [&](const Footprint& part) {
    return overlaps(part, rug, -distance);
  });
  if (beside) return RugStand::beside;
  const Footprint wider(rug.center(), 2.0 * (rug.half().array() + within).matrix(), rug.yaw(), rug.round());
  const bool on = std::all_of(parts.begin(), parts.end(), [&](const Footprint& part) {
    const auto corners = part.outline();
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Vec2& corner) { return contains(wider, corner); });
  });
  return on ? RugStand::on : RugStand::partly;
}

std::optional<Object> rug_place(const Object& rug, const RugWish& wish, const Room& room,
                                std::span<const Object> objects, std::span<const LowThing> things,
                                const KindTable& kinds) {
  const RugPlace place(rug, wish, room, objects, things, kinds);
  for (const auto& range : wish.size_told ? told_ranges : free_ranges)
    if (auto best = place.best(range)) return best;
  return std::nullopt;
}

}  // namespace roomgen
