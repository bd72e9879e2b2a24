#include <algorithm>

#include "draft_changes.h"
#include "operations.h"
#include "placing.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double same_spot = 0.05;   // metres by which a thing may be put aside, so that it stands well
constexpr double on_surface = 0.06;  // metres over the top of what carries it
constexpr double beside = 1.0;       // metres within which things stand to each other

/// Things with their spots, taken out of the room.
struct Taken {
  Cluster cluster;  ///< with what stands on it and has no spot of its own
  Pose pose;
};

Result<std::vector<Taken>> take_all(Draft& draft, const edit::Arrange& arrange) {
  std::set<std::string> own_spot;
  for (const auto& spot : arrange.spots)
    if (!own_spot.insert(spot.object).second) return cannot(spot.object + " has two spots");
  std::vector<Taken> taken;
  for (const auto& spot : arrange.spots) {
    auto object = object_to_change(draft, spot.object);
    if (!object) return object.error();
    Cluster cluster = cluster_of(draft.scene, *object);
    std::erase_if(cluster.carried, [&](const Object& carried) { return own_spot.count(carried.id) > 0; });
    if (spot.size) {
      auto sized = with_size(draft, *object, *spot.size);
      if (!sized) return sized.error();
      cluster.root = *std::move(sized);
    }
    taken.push_back({std::move(cluster), {spot.position.head<2>(), spot.position.z(), spot.yaw}});
  }
  std::stable_sort(taken.begin(), taken.end(),
                   [](const Taken& a, const Taken& b) { return a.pose.bottom < b.pose.bottom; });
  for (const auto& one : taken) draft.take_out(one.cluster.ids());
  return taken;
}

// What carries it there: the same as before if it is below, else the highest thing below.
std::string carrier_at(const Draft& draft, const Taken& thing) {
  const auto is_below = [&](const Object& other) {
    return other.room == thing.cluster.root.room && contains(footprint(other), thing.pose.position) &&
           bottom(other) < thing.pose.bottom + on_surface;
  };
  if (const Object* before = find_object(draft.scene, thing.cluster.root.on); before && is_below(*before))
    return before->id;
  const Object* best = nullptr;
  for (const auto& other : draft.scene.objects)
    if (!other.traits.flat && is_below(other) && (!best || top(other) > top(*best))) best = &other;
  return best ? best->id : "";
}

Result<Cluster> put_on_carrier(Draft& draft, Taken& thing) {
  thing.cluster.root.on = carrier_at(draft, thing);
  if (thing.cluster.root.on.empty()) return cannot(thing.cluster.root.id + " would hang in the air");
  Aim aim;
  aim.near_to = thing.pose;
  aim.most_off = same_spot;
  return find_place(draft, draft.layout_without(thing.cluster), thing.cluster, aim);
}

Result<Cluster> put_down(Draft& draft, Taken& thing) {
  if (thing.cluster.root.mount == Mount::surface) return put_on_carrier(draft, thing);
  if (thing.cluster.root.mount == Mount::floor) thing.pose.bottom = 0.0;
  return there_or_near(draft, thing.cluster, thing.pose, same_spot);
}

// What may be said of how it stands, the nearest things first; of these what holds.
std::vector<Relation> relations_there(const Draft& draft, const Object& object) {
  std::vector<Relation> candidates = {{RelationKind::edge, ""}, {RelationKind::corner, ""}};
  if (!object.on.empty()) candidates = {{RelationKind::on, object.on}};
  std::vector<std::pair<double, const Object*>> near;
  for (const auto& other : draft.scene.objects)
    if (other.room == object.room && other.id != object.id && other.on == object.on && !other.traits.flat)
      if (const double away = gap(footprint(object), footprint(other)); away < beside) near.emplace_back(away, &other);
  std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  if (!near.empty())
    for (const auto kind : {RelationKind::next_to, RelationKind::near, RelationKind::face_to})
      candidates.push_back({kind, near.front().second->id});
  return held_relations(object, candidates, draft.scene, draft.shop.kinds());
}

// Those that it had and that hold still, or else what holds now.
void renew_relations(Draft& draft, const std::string& id) {
  Object object = *find_object(draft.scene, id);
  auto held = held_relations(object, object.relations, draft.scene, draft.shop.kinds());
  const bool has_lost_some = held.size() < object.relations.size();
  object.relations = std::move(held);
  if (has_lost_some)
    for (const auto& relation : relations_there(draft, object))
      if (std::find(object.relations.begin(), object.relations.end(), relation) == object.relations.end())
        object.relations.push_back(relation);
  draft.put(Cluster{object, {}});
}

}  // namespace

Status carry_out(Draft& draft, const edit::Arrange& arrange) {
  const std::vector<Object> order = draft.scene.objects;
  auto taken = take_all(draft, arrange);
  if (!taken) return taken.error();
  for (auto& thing : *taken) {
    auto place = put_down(draft, thing);
    if (!place) return place.error();
    place->root.relations = thing.cluster.root.relations;
    draft.put(*place);
  }
  restore_order(order, draft.scene.objects);
  for (const auto& thing : *taken) {
    if (thing.cluster.root.traits.flat) settle_heights(draft, thing.cluster.root.room);
    renew_relations(draft, thing.cluster.root.id);
  }
  return {};
}

}  // namespace roomgen
