#include <algorithm>

#include "moves.h"

namespace roomgen::lab::annealing {

namespace {

bool has_level(std::span<const Attachment> attachments) {
  return std::ranges::any_of(attachments, [](const Attachment& a) { return is_level(a.parent); });
}

bool has_wall(std::span<const Attachment> attachments) {
  return std::ranges::any_of(attachments, [](const Attachment& a) { return a.parent == Face::wall; });
}

}  // namespace

bool Moves::choose_faces(Attachment& attachment, const Kind& kind) {
  const PutUp& how = world_.relation(attachment.relation);
  const bool to_room = attachment.target == room_slot;
  std::vector<Face> parents;
  for (const Face face : how.parent)
    if ((face == Face::floor || face == Face::ceiling || face == Face::wall) == to_room) parents.push_back(face);
  if (parents.empty()) return false;
  attachment.parent = random_.pick(parents);
  attachment.child = random_.pick(how.child);
  // A thing without a front is as good from all sides.
  if (!kind.traits.front && is_upright(attachment.parent) && is_upright(attachment.child)) {
    const std::vector<Face> sides{Face::front, Face::back, Face::left, Face::right};
    if (attachment.parent != Face::wall) attachment.child = random_.pick(sides);
  }
  if (attachment.parent == Face::wall)
    attachment.wall = random_.integer(0, static_cast<int>(world_.room().polygon.size()) - 1);
  if (!to_room && is_upright(attachment.parent)) {
    const Item& target = world_.item(attachment.target);
    if (target.object.traits.round) attachment.direction = radians(15.0 * random_.integer(0, 23));
    else if (!target.object.traits.front && parents.size() > 1)
      attachment.parent = random_.pick(std::vector<Face>{Face::front, Face::back, Face::left, Face::right});
  }
  return true;
}

std::optional<Attachment> Moves::attach(int relation, int target_set, const std::vector<Slot>& variables,
                                        const Kind& kind, std::optional<Slot> self) {
  const SlotSet targets = evaluator_.members(target_set, variables);
  const SlotSet own = self ? world_.cluster(*self) : SlotSet{};
  std::vector<Slot> possible;
  targets.each([&](Slot slot) {
    if (slot <= room_slot && !own.has(slot)) possible.push_back(slot);
  });
  if (possible.empty()) return std::nullopt;
  Attachment attachment;
  attachment.relation = relation;
  attachment.target = random_.pick(possible);
  if (!choose_faces(attachment, kind)) return std::nullopt;
  return attachment;
}

// Where things of the kind usually are; nothing if nothing could carry them.
std::optional<Attachment> Moves::usual_attachment(const Kind& kind) {
  const auto as = [&](std::string_view relation, Face child, Face parent) {
    Attachment attachment;
    attachment.relation = language_.number_of(relation);
    attachment.child = child, attachment.parent = parent;
    return attachment;
  };
  if (kind.mount == Mount::floor) return as("on_floor", Face::bottom, Face::floor);
  if (kind.mount == Mount::ceiling) return as("hanging", Face::top, Face::ceiling);
  if (kind.mount == Mount::wall) {
    Attachment attachment = as("flush_wall", Face::back, Face::wall);
    attachment.wall = random_.integer(0, static_cast<int>(world_.room().polygon.size()) - 1);
    return attachment;
  }
  std::vector<Slot> carriers;
  world_.things().each([&](Slot slot) {
    if (world_.item(slot).kind->supports) carriers.push_back(slot);
  });
  if (carriers.empty()) return std::nullopt;
  Attachment attachment = as("on", Face::bottom, Face::support);
  attachment.target = random_.pick(carriers);
  return attachment;
}

std::optional<std::vector<Attachment>> Moves::attach_all(const Recipe& recipe, const std::vector<Slot>& variables,
                                                         const Kind& kind, std::optional<Slot> self) {
  std::vector<Attachment> all;
  for (const auto& relation : recipe.relations) {
    if (std::ranges::any_of(all, [&](const Attachment& a) { return a.relation == relation.relation; })) continue;
    auto attachment = attach(relation.relation, relation.target, variables, kind, self);
    if (!attachment) return std::nullopt;
    all.push_back(*attachment);
  }
  // What the program leaves open is as such things usually are.
  if (!has_level(all) && !(kind.mount == Mount::wall && has_wall(all))) {
    const auto usual = usual_attachment(kind);
    if (!usual) return std::nullopt;
    all.push_back(*usual);
  }
  if (all.size() > most_attachments) return std::nullopt;
  return all;
}

}  // namespace roomgen::lab::annealing
