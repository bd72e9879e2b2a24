#include <algorithm>

#include "draft_changes.h"
#include "placing.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double slack_of_change = 0.5;  // metres that a changed thing may give way
constexpr double slack_on_top = 1.0;     // and what stands on it

constexpr double least_size = 0.005, greatest_size = 12.0;  // metres

// Its back, its middle, or a side stays where it was.
std::vector<Pose> poses_for_size(const Object& before, const Vec3& size) {
  const Pose pose = pose_of(before);
  const Vec2 more = 0.5 * (size.head<2>() - before.size.head<2>());
  std::vector<Pose> poses;
  for (const Vec2& side : {Vec2(0, -1), Vec2(0, 0), Vec2(1, -1), Vec2(-1, -1), Vec2(1, 0), Vec2(-1, 0)}) {
    Pose moved = pose;
    moved.position += rotated(Vec2(side.cwiseProduct(more)), before.yaw);
    poses.push_back(moved);
  }
  return poses;
}

Status reload_one(Draft& draft, const Cluster& before, const Object& carrier, const Object& object) {
  Cluster small{object, {}};
  for (const auto& other : before.carried)
    if (other.on == object.id) small.carried.push_back(other);
  Aim aim;
  aim.near_to = pose_of(object);
  aim.near_to->position += carrier.position.head<2>() - before.root.position.head<2>();
  aim.most_off = slack_on_top;
  aim.turns_freely = true;
  aim.kept = object.relations;
  auto place = find_place(draft, draft.layout_without(small), small, aim);
  if (!place) return cannot(object.id + " finds no place on it any more: " + place.error().message);
  draft.put(*place);
  return {};
}

// What stood on it stands on it again, as near as can be to where it did; what finds no place chooses before the
// others then.
Status reload(Draft& draft, const Cluster& before, const Object& carrier) {
  std::vector<Object> order;  // others come with what carries them
  for (const auto& object : before.carried)
    if (object.on == carrier.id) order.push_back(object);
  Status status;
  for (std::size_t round = 0; round <= order.size(); ++round) {
    Draft trial = draft;
    std::size_t done = 0;
    for (status = {}; status && done < order.size(); done += status ? 1 : 0)
      status = reload_one(trial, before, carrier, order[done]);
    if (status) return draft.take_over(std::move(trial)), status;
    if (done == 0) return status;
    std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(done),
                order.begin() + static_cast<std::ptrdiff_t>(done) + 1);
  }
  return status;
}

/// The place at which the fewest relations are lost, of those that were looked at so far.
struct BestPlace {
  const Draft& draft;
  std::optional<Cluster> cluster;
  std::size_t lost = 0;
  std::string why;  ///< the first was none

  void look_at(const Result<Cluster>& place) {
    if (!place) {
      if (why.empty()) why = place.error().message;
      return;
    }
    const auto loses =
        lost_relations(place->root, place->root.relations, draft.scene, draft.shop.kinds()).size();
    if (cluster && loses >= lost) return;
    cluster = *place;
    lost = loses;
  }
  bool is_good() const { return cluster && lost == 0; }
};

// Where it was, or a little aside, or else where it was on the edge of a rug; so that it stands to others as before
// if that can be.
Result<Cluster> place_of_changed(Draft& draft, Layout& layout, const Object& before, Object changed) {
  changed.relations = held_relations(before, changed.relations, draft.scene, draft.shop.kinds());
  BestPlace best{draft, {}, 0, ""};
  const auto look_in_place = [&](RugEdges edges) {
    for (const auto& pose : poses_for_size(before, changed.size))
      if (!best.is_good()) best.look_at(settled(draft, layout, moved_to(Cluster{changed, {}}, pose), edges));
  };
  look_in_place(RugEdges::kept_free);
  if (best.is_good()) return *best.cluster;
  Aim aim;
  aim.near_to = pose_of(before);
  aim.most_off = slack_of_change;
  aim.kept = changed.relations;
  best.look_at(find_place(draft, layout, Cluster{changed, {}}, aim));
  look_in_place(RugEdges::stood_on);
  if (!best.cluster) return cannot(best.why);
  return *best.cluster;
}

}  // namespace

Result<Object> with_size(const Draft& draft, Object object, const Vec3& size) {
  if (size.minCoeff() < least_size || size.maxCoeff() > greatest_size)
    return cannot("a size of " + size_text(size) + " m is not possible for " + object.id);
  object.size = size;
  if (const auto model = draft.shop.models().find(asset_key(object.asset)); model && object.traits.round)
    object.traits.round = keeps_to_ellipse(*model, object.size);
  return object;
}

Status put_changed(Draft& draft, const Cluster& before, Object changed) {
  const auto order = draft.scene.objects;
  auto away = before.ids();
  Layout& layout = draft.shop.layout(draft.scene, changed.room, away);
  auto place = place_of_changed(draft, layout, before.root, changed);
  if (!place) return place.error();
  place->root.relations = changed.relations;
  draft.take_out([&] {
    auto carried = away;
    carried.erase(before.root.id);
    return carried;
  }());
  draft.put(*place);
  for (const auto& object : before.carried) draft.named.insert(object.id);
  if (auto status = reload(draft, before, place->root); !status) return status;
  if (changed.traits.flat) settle_heights(draft, changed.room);
  restore_order(order, draft.scene.objects);
  return {};
}

}  // namespace roomgen
