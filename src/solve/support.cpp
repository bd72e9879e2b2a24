#include "support.h"

#include <algorithm>

#include "ways.h"

namespace roomgen {

namespace {

// Plates and glasses begin this far from the edge of a table; a chair so far from it is not its.
constexpr double from_edge = 0.03;
constexpr double seat_reach = 0.5;
// Narrower things stand beside a plate, not in its place.
constexpr double narrow = 0.15;
// Flat enough to be stacked on its like: towels, books, plates.
constexpr double stackable_height = 0.15;
constexpr double touch = 0.005;

using Relations = std::vector<Relation>;

const Relation* find(const Relations& relations, RelationKind kind) {
  const auto found = std::find_if(relations.begin(), relations.end(),
                                  [&](const Relation& relation) { return relation.kind == kind; });
  return found == relations.end() ? nullptr : &*found;
}

bool is_free(const Layout& layout, const Object& support, const Footprint& own) {
  const auto things = layout.things();
  return std::none_of(things.begin(), things.end(), [&](const FloorThing& one) {
    return one.object->on == support.id && overlaps(own, one.footprint, touch);
  });
}

// In the middle or wherever is room.
std::optional<Pose> free_spot(const Layout& layout, const Object& self, const Object& support) {
  const Footprint area = footprint(support);
  const Vec2 room = (area.half() - 0.5 * self.size.head<2>()).cwiseMax(0.0);
  for (double y : {0.0, 0.6, -0.6})
    for (double x : {0.0, 0.5, -0.5, 0.85, -0.85}) {
      const Vec2 at = area.to_world(Vec2(x, y).cwiseProduct(room));
      if (is_free(layout, support, Footprint(at, self.size.head<2>(), area.yaw())))
        return Pose{at, top(support), area.yaw()};
    }
  return std::nullopt;
}

// At the place of who sits there: before the seat at the edge of the table, or beside what is there.
std::optional<Pose> before_seat(const Layout& layout, const Object& self, const Object& support,
                                const Object& seat) {
  const Footprint table = footprint(support), chair = footprint(seat);
  const Vec2 ahead = chair.front(), aside = chair.x_axis();
  const double edge = ray_hit(table, chair.center(), ahead);
  if (edge < 0.0 || gap(chair, table) > seat_reach) return std::nullopt;
  const double first =
      std::max(edge + from_edge + 0.5 * self.size.y(), chair.half().y() + from_edge);
  for (const Vec2& shift : {Vec2(0.0, 0.0), Vec2(-0.17, 0.2), Vec2(0.17, 0.2), Vec2(0.0, 0.24)}) {
    if (shift.isZero() && self.size.x() < narrow) continue;
    const Vec2 at = chair.center() + (first + shift.y()) * ahead + shift.x() * aside;
    const double yaw = wrap_angle(chair.yaw() + pi);
    if (contains(table, at) && is_free(layout, support, Footprint(at, self.size.head<2>(), yaw)))
      return Pose{at, top(support), yaw};
  }
  return std::nullopt;
}

// At a side of, or near, something else than what carries it: the solver finds the spot.
bool is_beside_others(const Relations& relations, const std::string& support) {
  return std::any_of(relations.begin(), relations.end(), [&](const Relation& relation) {
    switch (relation.kind) {
      case RelationKind::left_of:
      case RelationKind::right_of:
        return true;
      case RelationKind::side_of:
      case RelationKind::near:
      case RelationKind::next_to:
      case RelationKind::behind:
        return !relation.target.empty() && relation.target != support;
      default:
        return false;
    }
  });
}

// Habits first that put the thing onto what was wished for, then the wish alone, then other habits.
std::vector<Relations> ways_onto(const KindTable& categories, std::vector<Relations> ways,
                                 const std::string& wish) {
  const auto rest = std::stable_partition(ways.begin(), ways.end(), [&](const Relations& way) {
    const Relation* on = find(way, RelationKind::on);
    return on && way.size() > 1 &&
           (categories.is_a(wish, on->target) || categories.is_a(on->target, wish));
  });
  ways.insert(rest, {Relation{RelationKind::on, wish}});
  return ways;
}

/// Goes through the habits of a thing until one of them names a support that will do.
class SupportChoice {
 public:
  SupportChoice(const Layout& layout, const std::string& wanted, std::size_t refused,
                PlacementTask& task)
      : layout_(layout),
        wanted_(wanted),
        refused_(refused),
        skip_(refused),
        task_(task),
        asked_(task.object.relations) {
    if (const Relation* on = find(asked_, RelationKind::on)) told_ = *on;
  }

  std::optional<Pose> run(const Arrangement& arrangement) {
    const auto ways = wanted_.empty()
                          ? arrangement.ways
                          : ways_onto(layout_.categories(), arrangement.ways, wanted_);
    for (const auto& way : ways)
      for (const auto& habits : named(way))
        if (suits(habits) && settle(habits)) return spot_;
    if (told_) settle({});
    return spot_;
  }

 private:
  std::vector<Relations> named(const Relations& way) const {
    std::vector<Relations> result;
    for (auto& choice : name_targets(layout_, task_.object, way))
      result.push_back(std::move(choice.relations));
    if (result.empty() && !way.empty() && layout_.find(way.front().target)) result.push_back(way);
    return result;
  }

  // What is told to stand on a thing keeps the habits that say where on just that.
  bool suits(const Relations& habits) const {
    const Relation* on = find(habits, RelationKind::on);
    return !told_ || (habits.size() > 1 && on && on->target == told_->target);
  }

  bool settle(const Relations& habits) {
    const Relation* on = told_ ? &*told_ : find(habits, RelationKind::on);
    if (!on) return false;
    const Relation* seat = find(habits, RelationKind::in_front_of);
    Relations relations = asked_;
    for (const auto& habit : habits)
      if (!told_ || habit.kind != RelationKind::on) relations.push_back(habit);
    for (const Object* support : supports(on->target)) {
      for (auto& relation : relations)
        if (relation.kind == RelationKind::on) relation.target = support->id;
      std::optional<Pose> spot;
      const bool open = is_beside_others(relations, support->id);
      if (!open) spot = spot_on(*support, seat);
      // Where no place is free by boxes, the meshes may leave one for what was asked for.
      const bool firm = !seat && (told_ || !wanted_.empty());
      if (!open && !spot && !firm) continue;
      if (skip_ > 0) {
        --skip_;
        continue;
      }
      task_.object.on = support->id;
      task_.object.relations = std::move(relations);
      if (spot && seat) task_.location = spot->position, task_.facing = spot->yaw;
      spot_ = spot;
      return true;
    }
    return false;
  }

  std::optional<Pose> spot_on(const Object& support, const Relation* seat) const {
    if (!seat) return free_spot(layout_, task_.object, support);
    const Object* chair = layout_.find(seat->target);
    return chair ? before_seat(layout_, task_.object, support, *chair) : std::nullopt;
  }

  // The one that is named; when it had no room, its like that lie there already, and others of its kind.
  std::vector<const Object*> supports(const std::string& id) const {
    const Object* named = layout_.find(id);
    if (!named) return {};
    std::vector<const Object*> found = {named};
    if (!told_ || refused_ == 0) return found;
    for (const auto& object : layout_.objects())
      if (object.on == id && object.category == task_.object.category &&
          object.size.z() <= stackable_height)
        found.push_back(&object);
    for (const auto& object : layout_.objects())
      if (object.category == named->category && object.id != id) found.push_back(&object);
    return found;
  }

  const Layout& layout_;
  const std::string& wanted_;
  std::size_t refused_, skip_;
  PlacementTask& task_;
  Relations asked_;
  std::optional<Relation> told_;
  std::optional<Pose> spot_;
};

}  // namespace

std::optional<Pose> choose_support(const Layout& layout, const std::string& wanted,
                                   std::size_t refused, PlacementTask& task) {
  const Arrangement* arrangement = layout.arrangement_of(task.object);
  if (!arrangement) return std::nullopt;
  return SupportChoice(layout, wanted, refused, task).run(*arrangement);
}

}  // namespace roomgen
