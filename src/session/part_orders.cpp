#include "part_orders.h"

#include <algorithm>

#include "moving_clauses.h"
#include "spoken_parts.h"

namespace roomgen {

namespace {

const RoleStretch* part_of(const SpokenOrder& order, EditRole role) {
  const auto found = std::find_if(order.parts.begin(), order.parts.end(),
                                  [&](const RoleStretch& part) { return part.role == role; });
  return found == order.parts.end() ? nullptr : &*found;
}

bool says_any(const EditText& text, const SpokenOrder& order, std::initializer_list<const char*> words) {
  for (const auto& part : order.parts)
    for (std::size_t i = part.begin; i < part.end; ++i)
      for (const char* word : words)
        if (text.is_word(i, word) && part.role != EditRole::thing && part.role != EditRole::target) return true;
  return false;
}

ReadClause each(const Ids& things, const std::function<edit::Operation(const std::string&)>& make) {
  return of_each({things, 0}, 0, make);
}

ReadClause turned(const EditText& text, const SpokenOrder& order, const Ids& things) {
  const auto degrees = turn_within(text, order);
  if (!degrees || order.has(EditRole::target)) return not_understood("it is not clear how far to turn");
  return each(things, [&](const std::string& id) { return edit::Turn{id, radians(*degrees)}; });
}

// Towards what is named, or away from it: "look away from the window", "with its back to it".
ReadClause faced(const EditText& text, const SpokenOrder& order, const Ids& things) {
  const auto* part = part_of(order, EditRole::target);
  const auto target = part ? target_at(text, part->begin, things) : std::nullopt;
  if (!target || !*target) return not_understood("it is not clear what to face");
  for (std::size_t i = (*target)->end; i < part->end; ++i)
    if (!text.is_mark(i)) return what_at(text, i, "not understood");
  if (!says_any(text, order, {"away", "back", "backs"}))
    return each(things, [&](const std::string& id) { return edit::Face{id, (*target)->id}; });
  Clause away{{}, things, {}, 0};
  for (const auto& id : things) {
    const Object* object = find_object(text.scene, id);
    if (!object) return not_understood(id + " has no place yet");
    const Vec2 way = Vec2(object->position.head<2>()) - middle_of_target(text, *object, (*target)->id);
    if (way.norm() < 1e-6) return not_understood("it is not clear which way " + id + " shall face");
    away.operations.push_back(edit::Turn{id, std::remainder(std::atan2(way.x(), -way.y()) - object->yaw, 2.0 * pi)});
  }
  return away;
}

ReadClause resized(const EditText& text, const SpokenOrder& order, const Ids& things) {
  const auto* part = part_of(order, EditRole::amount);
  const auto sides = part ? sides_within(text, *part) : std::nullopt;
  if (!sides) return not_understood("it is not clear how large");
  return each(things, [&](const std::string& id) {
    const Object* object = text.object(id);
    Vec3 size = object ? object->size : Vec3(Vec3::Ones());
    const bool hangs = object && object->mount == Mount::wall;
    size.x() = (*sides)[0];
    (hangs ? size.z() : size.y()) = (*sides)[1];
    if (sides->size() > 2) size.z() = (*sides)[2];
    return edit::Resize{id, size};
  });
}

ReadClause replaced(const EditText& text, const SpokenOrder& order, const Ids& things) {
  const auto* part = part_of(order, EditRole::look);
  const std::string looks = part ? plain_look_of(text, *part) : "";
  if (looks.empty()) return not_understood("it is not clear by what");
  std::string category;
  for (std::size_t i = part->begin; i < part->end && category.empty(); ++i)
    if (const auto thing = named_thing_at(text, i); thing && thing->kind.category && thing->end <= part->end)
      category = thing->kind.category->name;
  return each(things, [&](const std::string& id) {
    const Object* object = text.object(id);
    const bool is_other = !category.empty() && object && !text.kinds.is_a(object->category, category);
    return edit::Replace{id, is_other ? category : "", category.empty() && object ? looks + " " + object->category : looks};
  });
}

ReadClause recoloured(const EditText& text, const SpokenOrder& order, const Ids& things) {
  const auto* part = part_of(order, EditRole::look);
  const std::string looks = part ? plain_look_of(text, *part) : "";
  if (looks.empty() || !describes_looks(looks)) return not_understood("no colour or material is known");
  return each(things, [&](const std::string& id) { return edit::Recolor{id, looks}; });
}

}  // namespace

ReadClause read_order_of(const EditText& text, const SpokenOrder& order, EditDeed deed, const Ids& things) {
  switch (deed) {
    case EditDeed::turn: return turned(text, order, things);
    case EditDeed::face: return faced(text, order, things);
    case EditDeed::resize: return resized(text, order, things);
    case EditDeed::replace: return replaced(text, order, things);
    case EditDeed::recolour: return recoloured(text, order, things);
    default: return not_understood("it is not clear what shall be done");
  }
}

ReadClause read_cover(const EditText& text, const SpokenOrder& order) {
  const auto* thing = part_of(order, EditRole::thing);
  const auto* look = part_of(order, EditRole::look);
  const auto part = thing ? room_part_at(text, thing->begin) : std::nullopt;
  const std::string looks = look ? plain_look_of(text, *look) : "";
  if (!part || looks.empty() || !describes_looks(looks)) return not_understood("it is not clear how the room shall change");
  for (std::size_t i = part->end; i < thing->end; ++i)
    if (!text.is_mark(i)) return what_at(text, i, "it is not clear which part of the room is meant");
  return Clause{{edit::Cover{part->value, looks, ""}}, {}, {}, 0};
}

std::string looks_apart(const EditText& text, const SpokenOrder& order) {
  std::string all;
  for (const auto& part : order.parts)
    if (part.role == EditRole::look || part.role == EditRole::amount)
      if (const std::string look = plain_look_of(text, part); !look.empty()) all += (all.empty() ? "" : " ") + look;
  return all;
}

}  // namespace roomgen
