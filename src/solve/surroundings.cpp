#include "surroundings.h"

#include <algorithm>

#include "scene/room_part.h"

namespace roomgen {

namespace {

bool is_partner(const Object& object, const std::string& id) {
  return std::any_of(object.relations.begin(), object.relations.end(),
                     [&](const Relation& relation) { return relation.target == id; });
}

void add_reserves(const Footprint& footprint, const Arrangement& arrangement,
                  std::vector<Surroundings::Reserve>& reserves) {
  for (std::size_t side = 0; side < arrangement.reserve.size(); ++side) {
    const double depth = arrangement.reserve[side];
    if (depth <= 0.0) continue;
    const Footprint zone = zone_footprint(footprint, {static_cast<Side>(side), depth, {}});
    Surroundings::Reserve reserve{zone.bounds(), {}};
    for (double x : {-0.8, -0.4, 0.0, 0.4, 0.8})
      for (double y : {-0.8, 0.0, 0.8})
        reserve.points.push_back(zone.to_world(Vec2(x, y).cwiseProduct(zone.half())));
    reserves.push_back(std::move(reserve));
  }
}

std::vector<Segment> sight_lines_of(const Layout& layout) {
  static const std::vector<std::string> screens = {"tv stand", "fireplace"}, seats = {"sofa"};
  std::vector<Segment> lines;
  for (const auto& screen : layout.things()) {
    if (!is_any_of(*screen.category, screens)) continue;
    for (const auto& seat : layout.things())
      if (is_any_of(*seat.category, seats))
        lines.push_back({screen.footprint.center(), seat.footprint.center()});
  }
  return lines;
}

// What stands free with seats around it needs its reserve for those, not shared with others.
bool is_spacious(const Arrangement& arrangement) {
  return arrangement.reserve[static_cast<std::size_t>(Side::front)] > 0 &&
         arrangement.reserve[static_cast<std::size_t>(Side::back)] > 0;
}

std::vector<Footprint> zones_kept_from(const Layout& layout, const Object& object) {
  const Kind& own = layout.categories().get(object.category);
  std::vector<Footprint> zones;
  for (const auto& thing : layout.things())
    for (const auto& zone : thing.category->zones)
      if (thing.object->id != object.id && !is_any_of(own, zone.partners) &&
          zone_is_free(layout.room(), layout.things(), thing, zone))
        zones.push_back(zone_footprint(thing.footprint, zone));
  return zones;
}

bool is_matter_of_degree(RelationKind kind) {
  switch (kind) {
    case RelationKind::near:
    case RelationKind::next_to:
    case RelationKind::around:
    case RelationKind::middle:
    case RelationKind::far:
    case RelationKind::gap:
    case RelationKind::face_to:
    case RelationKind::used_facing:
      return true;
    default:
      return false;
  }
}

std::vector<Surroundings::Wish> wishes_of(const Layout& layout, const PlacementTask& task) {
  const auto& relations = task.object.relations;
  std::vector<Surroundings::Wish> wishes;
  if (std::none_of(relations.begin(), relations.end(),
                   [](const Relation& one) { return is_matter_of_degree(one.kind); }))
    return wishes;
  auto resolved = resolve(task.object, layout.room(), layout.objects(), layout.categories());
  for (std::size_t i = 0; i < resolved.size(); ++i)
    if (is_matter_of_degree(resolved[i].kind))
      wishes.push_back({std::move(resolved[i]), static_cast<int>(i) < task.wishes});
  return wishes;
}

bool says_nothing_of_angles(const Arrangement& arrangement) {
  return std::none_of(arrangement.preferences.begin(), arrangement.preferences.end(), [](const auto& one) {
    return one.what == Preference::square || one.what == Preference::angle;
  });
}

}  // namespace

Vec2 middle_beneath(const Arrangement& rug, const Kind& kind, const Footprint& target) {
  for (const auto& [group, before_front] : rug.over)
    if (is_of(kind, group)) return target.to_world({0, -target.half().y() - before_front});
  return target.center();
}

Surroundings::Surroundings(const Layout& layout, const PlacementTask& task,
                           const Arrangement& kind_arrangement, int company)
    : room(layout.room()),
      inside(room.polygon),
      object(task.object),
      arrangement(kind_arrangement),
      weights(layout.weights()) {
  may_be_square = object.mount == Mount::floor && !object.traits.flat && !arrangement.seats &&
                  says_nothing_of_angles(arrangement);
  const Bounds2 box = bounds(room.polygon);
  middle = 0.5 * (box.low + box.high);
  span = box.size().norm();
  for (const auto& opening : room.openings)
    if (const auto part = part_of_room(room, opening.id))
      (opening.is_entrance() ? doors : windows).push_back(*part);
  const auto areas = layout.door_areas();
  door_areas.assign(areas.begin(), areas.end());
  const auto things = layout.things();
  const std::vector<std::string> own_kind = {layout.categories().get(object.category).name};
  for (std::size_t i = 0; i < things.size(); ++i) {
    const Object& other = *things[i].object;
    if (other.id == object.id || !other.on.empty()) continue;
    const bool partner = is_partner(object, other.id);
    neighbours.push_back({things[i].footprint, top(other), other.traits.flat,
                          other.mount == Mount::floor, is_any_of(*things[i].category, own_kind),
                          partner});
    if (partner && object.traits.flat)
      beneath.emplace_back(middle_beneath(arrangement, *things[i].category, things[i].footprint),
                           object.size.head<2>(), things[i].footprint.yaw());
    if (!partner && layout.arrangement_of(i))
      add_reserves(things[i].footprint, *layout.arrangement_of(i), reserves);
  }
  sight_lines = sight_lines_of(layout);
  wishes = wishes_of(layout, task);
  if (arrangement.seats)
    for (const auto& wish : wishes)
      if (wish.relation.kind == RelationKind::around)
        for (const auto& table : wish.relation.targets)
          for (const auto& place : seat_places(table, company)) seats.push_back(place);
  if (is_spacious(arrangement)) zones_in_use = zones_kept_from(layout, object);
}

}  // namespace roomgen
