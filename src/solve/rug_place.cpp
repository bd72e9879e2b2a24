#include "rug_place.h"

#include <algorithm>
#include <array>

#include "scene/judgement.h"

namespace roomgen {

namespace {

// By how much a rug may be larger or smaller than planned, and if nothing else will do.
constexpr std::array<RugRange, 2> free_ranges = {{{0.5, 1.8}, {0.35, 2.5}}};
constexpr RugRange told_range = {0.65, 1.25};
constexpr double within = 1e-3;      // a part may reach this far over the edge of a rug that it is on
constexpr double clear = 0.01;       // between a rug and what is not on it
constexpr double room_slack = 5e-4;  // as the layout has it

// What is lost, in metres of change.
constexpr double asked_relation = 3.0;
constexpr double usual_relation = 0.3;
constexpr double laid_under = 0.8;  // a thing is beside the rug that was laid under it
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
    for (const auto& point : room.polygon.points) about_.corners.push_back(own_.to_local(point));
    for (const auto& opening : room.openings)
      if (opening.is_entrance() && !overlaps(own_, area_before(room, opening), within))
        kept_clear_.push_back(area_before(room, opening));
  }

  /// May it stay as it lies?
  bool lies_well() const { return loss({-own_.half(), own_.half()}) && loss(own_); }

  std::optional<Object> best(const RugRange& range) const {
    std::optional<Object> best;
    double least = 1e300;
    for (const auto& cut : rug_cuts(2.0 * own_.half(), own_.round(), range, about_)) {
      if (cut.change >= least) break;
      const auto uneasy = loss(cut.area);
      if (!uneasy || cut.change + *uneasy >= least) continue;
      Object object = cut_to(cut);
      const auto untied = loss(footprint(object));
      if (untied && cut.change + *uneasy + *untied < least)
        best = std::move(object), least = cut.change + *uneasy + *untied;
    }
    return best;
  }

 private:
  // In the rug's frame.
  struct Standing {
    std::vector<Footprint> parts;
    Bounds2 box;
    bool may_be_on = true;
    bool belongs = false;  ///< the rug was laid under it
  };

  void add(const LowThing& thing) {
    Standing standing;
    standing.may_be_on = thing.may_be_lifted;
    standing.belongs = contains(own_, footprint(*thing.object).center());
    for (const auto& part : thing.parts) {
      standing.parts.emplace_back(own_.to_local(part.center()), 2.0 * part.half(),
                                  part.yaw() - own_.yaw(), part.round());
      about_.parts.push_back(standing.parts.back().bounds());
      standing.box.add(about_.parts.back().low);
      standing.box.add(about_.parts.back().high);
    }
    if (!thing.parts.empty()) about_.things.push_back(standing.box);
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

  Object cut_to(const RugCut& cut) const {
    Object object = rug_;
    object.position.head<2>() = own_.to_world(0.5 * (cut.area.low + cut.area.high));
    object.size.head<2>() = cut.area.size();
    return with_rounded_pose(std::move(object));
  }

  // What stands otherwise than it should; nothing if something would stand partly on the rug.
  std::optional<double> loss(const Bounds2& area) const {
    const Footprint rug(0.5 * (area.low + area.high), area.size(), 0.0, own_.round());
    double sum = 0.0;
    for (const auto& thing : things_) {
      const bool apart = !thing.box.overlaps(area, clear);
      const RugStand stand = apart ? RugStand::beside : stand_of(thing.parts, rug, clear);
      const bool on = stand == RugStand::on;
      if (stand == RugStand::partly || (on && !thing.may_be_on)) return std::nullopt;
      if (on != thing.belongs) sum += on ? slid_under : laid_under;
    }
    return sum;
  }

  // Relations that no longer hold; nothing if the rug may not lie there.
  std::optional<double> loss(const Footprint& rug) const {
    if (!contains(room_.polygon, rug, room_slack)) return std::nullopt;
    for (const auto& area : kept_clear_)
      if (overlaps(rug, area, within)) return std::nullopt;
    double sum = 0.0;
    for (const auto& tie : ties_)
      if (!holds(tie, rug, rug_, room_)) sum += tie.weight;
    return sum;
  }

  const Object& rug_;
  const Room& room_;
  Footprint own_;
  std::vector<Tie> ties_;
  std::vector<Standing> things_;
  AboutRug about_;
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
  if (wish.place_told && place.lies_well()) return rug;
  if (wish.size_told) return place.best(told_range);
  for (const auto& range : free_ranges)
    if (auto best = place.best(range)) return best;
  return std::nullopt;
}

}  // namespace roomgen
