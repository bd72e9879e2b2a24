#include <algorithm>

#include "evaluator.h"
#include "nothing.h"

namespace roomgen::lab::annealing {

namespace {

constexpr Version alignment_to_walls = 100;  // beyond the faces of the room
// No less than that are two things apart whose boxes along the axes these are.
double box_distance(const Bounds2& a, const Bounds2& b) {
  return (b.low - a.high).cwiseMax(a.low - b.high).cwiseMax(0.0).norm();
}

}  // namespace

double Evaluator::pair_distance(Slot a, Slot b) {
  if (b < a) std::swap(a, b);
  return distances_.get(world_.version(a), world_.version(b),
                        [&] { return annealing::distance(world_.body(a), world_.body(b)); });
}

double Evaluator::distance_to_face_of_room(Slot slot, Face face) {
  return to_room_.get(world_.version(slot), static_cast<Version>(face),
                      [&] { return distance_to_room(world_.body(slot), face, world_.room()); });
}

double Evaluator::nearest(Slot slot, const TermNode& node, const SlotSet& others, bool is_room) {
  const Body& body = world_.body(slot);
  if (is_room) return distance_to_face_of_room(slot, node.face.value_or(Face::wall));
  double least = nothing;
  others.each([&](Slot other) {
    if (other == slot) return;
    if (least <= box_distance(body.footprint.bounds(), world_.body(other).footprint.bounds())) return;
    const double way =
        node.face ? distance_to_face(body, world_.body(other), *node.face) : pair_distance(slot, other);
    if (is_nothing(least) || way < least) least = way;
  });
  return least;
}

double Evaluator::distance(const TermNode& node) {
  const SlotSet from = members(node.sets[0]), to = members(node.sets[1]);
  const bool is_room = to.has(room_slot);
  double least = nothing;
  from.each([&](Slot slot) {
    if (slot == room_slot) return;
    const double way = nearest(slot, node, to, is_room);
    if (!is_nothing(way) && (is_nothing(least) || way < least)) least = way;
  });
  return least;
}

double Evaluator::access(const TermNode& node) {
  const SlotSet from = members(node.sets[0]), to = members(node.sets[1]);
  if (from.empty() || to.empty()) return nothing;
  auto& memo = accesses_[static_cast<std::size_t>(node.memo)];
  double deepest = 0.0;
  from.each([&](Slot slot) {
    const auto reaches = [&](const Body& other) {
      double depth = 0.0;
      for (const Face face : node.directions)
        depth = std::max(depth, penetration(access_space(world_.body(slot), face, node.depth), other));
      return depth;
    };
    to.each([&](Slot other) {
      if (other == slot) return;
      if (other == room_slot) {  // the room's walls: how much of the space is beyond them
        for (const Face face : node.directions) {
          const Body space = access_space(world_.body(slot), face, node.depth);
          for (std::size_t k = 0; k < world_.room().polygon.size(); ++k) {
            const Vec2 in = world_.room().polygon.inward(k);
            const double inside = in.dot(space.footprint.center() - world_.room().polygon.points[k]);
            const double beyond = reach_along(space.footprint, in) - inside;
            if (!is_nothing(beyond)) deepest = std::max(deepest, std::min(beyond, node.depth));
          }
        }
        return;
      }
      deepest = std::max(deepest, memo.get(world_.version(slot), world_.version(other),
                                           [&] { return reaches(world_.body(other)); }));
    });
  });
  return deepest;
}

double Evaluator::angle(const TermNode& node) {
  const SlotSet from = members(node.sets[0]), to = members(node.sets[1]);
  if (from.empty() || to.empty()) return nothing;
  double sum = 0.0;
  from.each([&](Slot slot) {
    const Footprint& own = world_.body(slot).footprint;
    if (to.has(room_slot)) {
      sum += to_room_.get(world_.version(slot), alignment_to_walls,
                          [&] { return misalignment_to_walls(own, world_.room().polygon); });
      return;
    }
    Slot nearest_one = -1;
    double least = 0.0;
    to.each([&](Slot other) {
      if (other == slot) return;
      if (nearest_one >= 0 && least <= box_distance(own.bounds(), world_.body(other).footprint.bounds())) return;
      const double way = pair_distance(slot, other);
      if (nearest_one < 0 || way < least) nearest_one = other, least = way;
    });
    if (nearest_one >= 0) sum += misalignment(own, world_.body(nearest_one).footprint);
  });
  return sum;
}

double Evaluator::focus(const TermNode& node) {
  const SlotSet from = members(node.sets[0]), to = members(node.sets[1]);
  if (from.empty() || to.empty()) return nothing;
  Vec2 middle = Vec2::Zero();
  to.each([&](Slot slot) { middle += world_.body(slot).footprint.center() / to.size(); });
  double sum = 0.0;
  from.each([&](Slot slot) { sum += unfocused(world_.body(slot).footprint, middle); });
  return sum;
}

// How far things are from the middle of what carries them, along it: the floor, the ceiling, a wall, a thing.
double Evaluator::center(const TermNode& node) {
  const SlotSet set = members(node.sets[0]);
  if (set.empty()) return nothing;
  const Polygon& floor = world_.room().polygon;
  const Vec2 middle_of_floor = [&] {
    const Bounds2 box = bounds(floor);
    return Vec2(0.5 * (box.low + box.high));
  }();
  double sum = 0.0;
  set.each([&](Slot slot) {
    const Item& item = world_.item(slot);
    for (const auto& attachment : item.stance.held()) {
      if (attachment.parent == Face::wall && is_upright(attachment.parent)) continue;
      if (!is_level(attachment.parent)) continue;
      const Vec2 target = attachment.target == room_slot ? middle_of_floor
                                                         : world_.body(attachment.target).footprint.center();
      sum += (item.stance.position - target).norm();
    }
  });
  return sum;
}

double Evaluator::gap(const TermNode& node) {
  const SlotSet set = members(node.sets[0]);
  double least = nothing;
  set.each([&](Slot a) {
    set.each([&](Slot b) {
      if (b <= a) return;
      if (least <= box_distance(world_.body(a).footprint.bounds(), world_.body(b).footprint.bounds())) return;
      const double way = pair_distance(a, b);
      if (is_nothing(least) || way < least) least = way;
    });
  });
  return least;
}

double Evaluator::seats(const TermNode& node) {
  double sum = 0.0;
  members(node.sets[0]).each([&](Slot slot) {
    if (slot < most_things) sum += world_.articles()[static_cast<std::size_t>(world_.item(slot).article)].seats;
  });
  return sum;
}

double Evaluator::floor_area(const SlotSet& set, bool on_floor_only) {
  std::array<Slot, most_things> counted;
  std::size_t count = 0;
  double sum = 0.0;
  set.each([&](Slot slot) {
    if (slot >= most_things) return;
    const Item& item = world_.item(slot);
    if (on_floor_only && (item.object.mount != Mount::floor || item.object.traits.flat)) return;
    sum += item.body.footprint.area();
    counted[count++] = slot;
  });
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j) {
      const Slot a = counted[i], b = counted[j];
      sum -= shared_.get(world_.version(a), world_.version(b), [&] {
        return shared_area(world_.body(a).footprint, world_.body(b).footprint);
      });
    }
  return sum;
}

double Evaluator::occupancy() { return floor_area(world_.things(), true) / area_; }

std::vector<Footprint> Evaluator::footprints(int set) {
  std::vector<Footprint> result;
  members(set).each([&](Slot slot) {
    if (slot != room_slot) result.push_back(world_.body(slot).footprint);
  });
  return result;
}

}  // namespace roomgen::lab::annealing
