#include "on_top.h"

#include <algorithm>

#include "targets.h"

namespace roomgen::design {

namespace {

// Plates and glasses begin this far from the edge of a table; a chair so far from it is not its.
constexpr double from_edge = 0.03;
constexpr double seat_reach = 0.5;
// Narrower things stand beside a plate, not in its place.
constexpr double narrow = 0.15;

bool is_free(const Sketch& sketch, const Object& self, const Target& carrier, const Pose& pose) {
  const Footprint own = footprint_at(self, pose);
  return std::none_of(sketch.standing().begin(), sketch.standing().end(), [&](const Standing& one) {
    return one.object->on == carrier.id && overlaps(own, one.footprint, 0.005);
  });
}

// Where on its carrier a small thing stands: the middle, or wherever is still free.
std::optional<Pose> on_top(const Sketch& sketch, const Object& self, const Target& carrier) {
  const Footprint& fp = carrier.footprint;
  const Vec2 room = (fp.half() - 0.5 * self.size.head<2>()).cwiseMax(0.0);
  for (double y : {0.0, 0.6, -0.6})
    for (double x : {0.0, 0.5, -0.5, 0.85, -0.85}) {
      const Pose pose{fp.to_world({x * room.x(), y * room.y()}), fp.yaw()};
      if (is_free(sketch, self, carrier, pose)) return pose;
    }
  return std::nullopt;
}

// At the place of who sits there: before the seat at the edge of the table, or beside what is there.
std::optional<Pose> before_seat(const Sketch& sketch, const Object& self, const Target& carrier,
                                const Target& seat) {
  const Vec2 ahead = seat.footprint.front(), aside = seat.footprint.x_axis();
  const double edge = ray_hit(carrier.footprint, seat.footprint.center(), ahead);
  if (edge < 0.0 || gap(seat.footprint, carrier.footprint) > seat_reach) return std::nullopt;
  const double first = std::max(edge + from_edge + 0.5 * self.size.y(),
                                seat.footprint.half().y() + from_edge);
  for (const Vec2& shift : {Vec2(0.0, 0.0), Vec2(-0.17, 0.2), Vec2(0.17, 0.2), Vec2(0.0, 0.24)}) {
    if (shift.isZero() && self.size.x() < narrow) continue;
    const Pose pose{seat.footprint.center() + (first + shift.y()) * ahead + shift.x() * aside,
                    wrap_angle(seat.footprint.yaw() + pi)};
    if (contains(carrier.footprint, pose.position) && is_free(sketch, self, carrier, pose))
      return pose;
  }
  return std::nullopt;
}

const Relation* find(const std::vector<Relation>& relations, RelationKind kind) {
  const auto found = std::find_if(relations.begin(), relations.end(),
                                  [&](const Relation& relation) { return relation.kind == kind; });
  return found == relations.end() ? nullptr : &*found;
}

// At a side of, or near, something else than what carries it: the solver finds the spot.
bool beside_others(const std::vector<Relation>& relations, const std::string& carrier) {
  return std::any_of(relations.begin(), relations.end(), [&](const Relation& relation) {
    switch (relation.kind) {
      case RelationKind::left_of:
      case RelationKind::right_of:
        return true;
      case RelationKind::side_of:
      case RelationKind::near:
      case RelationKind::next_to:
      case RelationKind::behind:
        return !relation.target.empty() && relation.target != carrier;
      default:
        return false;
    }
  });
}

// Habits first that put the thing onto what was wished for, then the wish alone, then other habits.
std::vector<std::vector<Relation>> ways_onto(const KindTable& categories,
                                             std::vector<std::vector<Relation>> ways,
                                             const std::string& wish) {
  const auto rest = std::stable_partition(ways.begin(), ways.end(), [&](const auto& way) {
    const Relation* on = find(way, RelationKind::on);
    return on && way.size() > 1 &&
           (categories.is_a(wish, on->target) || categories.is_a(on->target, wish));
  });
  ways.insert(rest, {Relation{RelationKind::on, wish}});
  return ways;
}

// Flat enough to be stacked on its like: towels, books, plates.
constexpr double stackable_height = 0.15;

// The one that is named; when it had no room, its like that lie there already, and others of its kind.
std::vector<Target> carriers(const Sketch& sketch, const Object& self, const std::string& id,
                             bool others) {
  auto found = sketch.find(id);
  if (!others || found.empty() || !found.front().object) return found;
  const std::string category = found.front().object->category;
  const auto add = [&](const Object& object) {
    for (auto& target : sketch.find(object.id)) found.push_back(std::move(target));
  };
  for (const auto& object : sketch.objects())
    if (object.on == id && object.category == self.category && object.size.z() <= stackable_height)
      add(object);
  for (const auto& object : sketch.objects())
    if (object.category == category && object.id != id) add(object);
  return found;
}

}  // namespace

PlaceAdvice advise_on(const Sketch& sketch, const Object& self, const Arrangement& arrangement,
                      std::vector<Relation> asked, const std::string& on, std::size_t refused) {
  const Relation* told = find(asked, RelationKind::on);
  const auto ways =
      on.empty() ? arrangement.ways : ways_onto(sketch.categories(), arrangement.ways, on);
  std::size_t skip = refused;
  // Every habit about what carries the thing, or about anything if nothing was told.
  const auto advice = [&](const std::vector<Relation>& habits) -> std::optional<PlaceAdvice> {
    const Relation* carrier_wish = told ? told : find(habits, RelationKind::on);
    if (!carrier_wish) return std::nullopt;
    const Relation* seat_wish = find(habits, RelationKind::in_front_of);
    auto relations = asked;
    for (const auto& habit : habits)
      if (!told || habit.kind != RelationKind::on) relations.push_back(habit);
    for (const auto& carrier : carriers(sketch, self, carrier_wish->target, told && refused > 0)) {
      std::optional<Pose> pose;
      for (auto& relation : relations)
        if (relation.kind == RelationKind::on) relation.target = carrier.id;
      if (beside_others(relations, carrier.id)) {
        if (skip-- > 0) continue;
        return PlaceAdvice{relations, std::nullopt, std::nullopt, "on " + carrier.id};
      }
      if (seat_wish) {
        for (const auto& seat : sketch.find(seat_wish->target))
          if (!pose) pose = before_seat(sketch, self, carrier, seat);
      } else {
        pose = on_top(sketch, self, carrier);
      }
      // Where no place is free by boxes, the solver may find one that was asked for.
      const bool firm = !seat_wish && (told || !on.empty());
      if ((!pose && !firm) || skip-- > 0) continue;
      if (!pose) return PlaceAdvice{relations, std::nullopt, std::nullopt, "on " + carrier.id};
      return PlaceAdvice{relations, pose->position, pose->yaw, "on " + carrier.id};
    }
    return std::nullopt;
  };
  for (const auto& way : ways) {
    auto choices = resolve(sketch, self, way);
    if (choices.empty() && !way.empty() && !sketch.find(way.front().target).empty())
      choices.push_back({way, 0.0});
    for (const auto& choice : choices) {
      const Relation* onto = find(choice.relations, RelationKind::on);
      if (told && (choice.relations.size() < 2 || !onto || onto->target != told->target)) continue;
      if (auto found = advice(choice.relations)) return *found;
    }
  }
  if (told)
    if (auto found = advice({})) return *found;
  return {asked, std::nullopt, std::nullopt, "nothing is there to carry it"};
}

}  // namespace roomgen::design
