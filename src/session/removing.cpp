#include <algorithm>

#include "operations.h"
#include "placing.h"

namespace roomgen {

namespace {

// Does it stand around the other one, as chairs around their table?
bool belongs_to(const Object& object, const std::string& id) {
  const auto has = [&](RelationKind kind) {
    return std::find(object.relations.begin(), object.relations.end(), Relation{kind, id}) != object.relations.end();
  };
  return has(RelationKind::around) || has(RelationKind::face_to);
}

std::set<std::string> with_what_goes_along(const Draft& draft, const Object& object, bool group) {
  auto gone = cluster_of(draft.scene, object).ids();
  if (!group) return gone;
  for (const auto& other : draft.scene.objects)
    if (belongs_to(other, object.id)) gone.merge(cluster_of(draft.scene, other).ids());
  return gone;
}

}  // namespace

Status carry_out(Draft& draft, const edit::Remove& remove) {
  std::set<std::string> gone;
  for (const auto& id : remove.objects) {
    const auto object = object_to_change(draft, id);
    if (!object) return object.error();
    gone.merge(with_what_goes_along(draft, *object, remove.group));
  }
  std::set<std::string> rooms_of_rugs;
  for (const auto& id : gone) {
    const Object& object = *find_object(draft.scene, id);
    if (object.locked) return cannot(id + " would go along, and is locked; unlock it first");
    draft.named.insert(id);
    draft.new_categories.insert(object.category);
    if (object.traits.flat) rooms_of_rugs.insert(object.room);
  }
  draft.take_out(gone);
  for (auto& object : draft.scene.objects)
    std::erase_if(object.relations, [&](const Relation& one) { return gone.count(one.target) > 0; });
  for (const auto& room : rooms_of_rugs) settle_heights(draft, room);
  return {};
}

}  // namespace roomgen
