#include "grouping.h"
#include "operations.h"
#include "placing.h"

namespace roomgen {

namespace {

std::set<std::string> with_what_goes_along(const Draft& draft, const Object& object, bool group) {
  return group ? ids_of(group_of(draft.scene, object)) : whole_of(draft.scene, object).ids();
}

}  // namespace

Status carry_out(Draft& draft, const edit::Remove& remove) {
  std::set<std::string> gone;
  for (const auto& id : remove.objects) {
    const auto object = object_to_change(draft, id, true);
    if (!object) return object.error();
    gone.merge(with_what_goes_along(draft, *object, remove.group));
  }
  std::set<std::string> rooms_of_rugs;
  for (const auto& id : gone) {
    const Object& object = *find_object(draft.scene, id);
    if (!may_go(draft, object))
      return cannot(id + " would go along, and is locked; unlock it first");
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
