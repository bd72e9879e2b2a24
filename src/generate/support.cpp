#include "support.h"

#include "sizing.h"

namespace roomgen {

namespace {

// After how many refusals a small thing goes elsewhere.
constexpr std::size_t patience_with_support = 2;

template <typename Test>
const Object* roomiest(const Layout& layout, const Object& object, Test could) {
  const Object* best = nullptr;
  std::size_t best_room = 0;
  for (const auto& other : layout.objects()) {
    if (!could(other) || layout.support_poses().surfaces(other).empty()) continue;
    const std::size_t room = layout.free_support_poses(object, other).size();
    if (!best || room > best_room) best = &other, best_room = room;
  }
  return best;
}

const Object* find_support(const Work& work, const std::string& wanted, const Object& object) {
  const Object* usual = roomiest(work.layout(), object, [&](const Object& other) {
    return other.id == wanted || could_carry(work.place.categories, other.category, wanted);
  });
  if (usual || !wanted.empty()) return usual;
  return roomiest(work.layout(), object, [](const Object&) { return true; });
}

}  // namespace

bool could_carry(const KindTable& categories, const std::string& category,
                 const std::string& wanted) {
  return wanted.empty() ? categories.is_any_of(category, {"table", "storage"})
                        : categories.is_a(category, wanted);
}

Status put_on_support(const Work& work, const PlanItem& item, std::size_t refused, Object& object) {
  const Layout& layout = work.layout();
  const Object* support = nullptr;
  for (const auto& relation : object.relations)
    if (relation.kind == RelationKind::on && !support) support = layout.find(relation.target);
  if (support && item.asked && refused >= patience_with_support) support = nullptr;
  if (!support) support = find_support(work, item.on, object);
  if (!support)
    return Error{Error::Kind::not_found,
                 "nothing in the room can carry it" +
                     (item.on.empty() ? std::string() : " (wanted: " + item.on + ")")};
  object.on = support->id;
  if (item.asked)
    object.size *= shrink_factor(object, layout.support_poses().surfaces(*support), refused);
  return {};
}

}  // namespace roomgen
