#include <algorithm>

#include "grouping.h"
#include "operations.h"
#include "placing.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr int most_attempts = 6;
constexpr double same_place = 0.05;  // metres: nearer than that is no other arrangement

// What is told to be set out anew, first what the others stand to.
std::vector<Cluster> things_to_set_out(const Draft& draft, const std::vector<std::string>& ids) {
  std::vector<Cluster> things;
  // One of a group stands for it.
  for (const auto& id : ids) things.push_back(whole_of(draft.scene, anchor_of(draft.scene, *find_object(draft.scene, id))));
  if (ids.size() == 1 && things.front().root.group.empty())
    things = related_group_of(draft.scene, things.front().root);
  std::erase_if(things, [&](const Cluster& one) {
    return std::any_of(things.begin(), things.end(), [&](const Cluster& other) {
      return other.root.id != one.root.id && other.ids().count(one.root.id) > 0;
    });
  });
  order_by_relations(things);
  return things;
}

// Relations that held before, of which those to things that have no place yet wait.
Aim aim_for(const Scene& before, const Draft& draft, const Cluster& thing, const std::set<std::string>& away,
            std::vector<Pose> except) {
  Aim aim;
  const auto held = held_relations(thing.root, thing.root.relations, before, draft.shop.kinds());
  for (const auto& relation : thing.root.relations) {
    const bool is_held = std::find(held.begin(), held.end(), relation) != held.end();
    (is_held && !away.count(relation.target) ? aim.asked : aim.kept).push_back(relation);
  }
  aim.except = std::move(except);
  aim.usual = true;
  return aim;
}

// One after the other; the first of them stands elsewhere than before.
Status set_out(const Scene& before, Draft& draft, const std::vector<Cluster>& things, const std::vector<Pose>& except) {
  std::set<std::string> away = ids_of(things);
  for (std::size_t i = 0; i < things.size(); ++i) {
    const Cluster& thing = things[i];
    Aim aim = aim_for(before, draft, thing, away, i == 0 ? except : std::vector<Pose>());
    Layout& layout = draft.shop.layout(draft.scene, thing.root.room, away);
    auto place = find_place(draft, layout, thing, aim);
    if (!place) {
      aim.kept.insert(aim.kept.end(), aim.asked.begin(), aim.asked.end());
      aim.asked.clear();
      place = find_place(draft, layout, thing, aim);
    }
    if (!place) return place.error();
    place->root.relations = thing.root.relations;
    draft.put(*place);
    for (const auto& id : thing.ids()) away.erase(id);
  }
  return {};
}

// Relations that held and do not any more, in words.
std::vector<std::string> lost_by(const Scene& before, const Draft& draft, const std::vector<Cluster>& things) {
  std::vector<std::string> lost;
  for (const auto& thing : things) {
    const auto held = held_relations(thing.root, thing.root.relations, before, draft.shop.kinds());
    const Object& now = *find_object(draft.scene, thing.root.id);
    for (const auto& relation : lost_relations(now, held, draft.scene, draft.shop.kinds()))
      lost.push_back(now.id + " " + to_text(relation));
  }
  return lost;
}

bool is_elsewhere(const Draft& draft, const Cluster& thing) {
  return (find_object(draft.scene, thing.root.id)->position - thing.root.position).norm() > same_place;
}

}  // namespace

Status carry_out(Draft& draft, const edit::Rearrange& rearrange) {
  for (const auto& id : rearrange.objects)
    if (const auto object = object_to_change(draft, id); !object) return object.error();
  const auto things = things_to_set_out(draft, rearrange.objects);
  for (const auto& thing : things) {
    if (thing.root.locked) return cannot(thing.root.id + " belongs to it, and is locked; unlock it first");
    draft.named.merge(thing.ids());
  }
  if (std::any_of(things.begin(), things.end(),
                  [&](const Cluster& one) { return one.root.room != things.front().root.room; }))
    return cannot("they stand in different rooms");
  std::optional<Draft> best;
  std::vector<Pose> except = {pose_of(things.front().root)};
  const Scene before = draft.scene;
  std::string why;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    Draft trial = draft;
    const auto status = set_out(before, trial, things, except);
    if (!status) why = status.error().message;
    if (const Object* first = find_object(trial.scene, things.front().root.id)) except.push_back(pose_of(*first));
    if (!status || !is_elsewhere(trial, things.front())) continue;
    if (!best || lost_by(before, trial, things).size() < lost_by(before, *best, things).size())
      best.emplace(std::move(trial));
    if (lost_by(before, *best, things).empty()) break;
  }
  if (!best) return cannot("there is no other arrangement of " + things.front().root.id + " and what belongs to it" +
                           (why.empty() ? "" : ": " + why));
  if (const auto lost = lost_by(before, *best, things); !lost.empty())
    return cannot("no other arrangement of " + things.front().root.id +
                  " and what belongs to it was found in which all stand to each other as they do: at best it would no "
                  "longer be so that " + join(lost, ", ") + "; move or remove some of them first");
  draft.take_over(std::move(*best));
  return {};
}

}  // namespace roomgen
