#include "operations.h"

#include <algorithm>
#include <charconv>

#include "roomgen/base/text.h"
#include "scene/judgement.h"

namespace roomgen {

namespace {

// The number behind a category: 2 of "chair-2"; nothing for other ids.
std::optional<int> number_in(const std::string& id, const std::string& category) {
  if (id.size() <= category.size() + 1 || !id.starts_with(category) || id[category.size()] != '-') return std::nullopt;
  int number = 0;
  const char* const end = id.data() + id.size();
  const auto [last, failed] = std::from_chars(id.data() + category.size() + 1, end, number);
  if (failed != std::errc() || last != end) return std::nullopt;
  return number;
}

}  // namespace

Status carry_out(Draft& draft, const edit::Operation& operation) {
  return std::visit([&](const auto& one) { return carry_out(draft, one); }, operation);
}

// Numbers that were ever in use are not given again: the ledger may still speak of them.
std::string next_id(const Scene& scene, const std::string& category, int further) {
  const std::string base = lower(category);
  int next = 0;
  const auto see = [&](const std::string& id) {
    if (const auto number = number_in(id, base)) next = std::max(next, *number + 1);
  };
  for (const auto& object : scene.objects) see(object.id);
  for (const auto& missing : scene.unplaced) see(missing.id);
  for (const auto& verdict : scene.requirements) {
    for (const auto& id : verdict.requirement.subjects) see(id);
    for (const auto& id : verdict.requirement.targets) see(id);
  }
  return base + "-" + std::to_string(next + further);
}

Requirement wish_for(const Object& object, const std::string& clause, Requirement::Kind kind) {
  Requirement wish;
  wish.kind = kind;
  wish.source = Requirement::Source::edit;
  wish.clause = clause;
  wish.category = object.category;
  wish.subjects = {object.id};
  wish.room = object.room;
  return wish;
}

void wish_relations(Draft& draft, const Object& object, const std::vector<Relation>& relations) {
  for (const auto& relation : relations) {
    Requirement wish =
        wish_for(object, object.id + " " + std::string(name(relation.kind)), Requirement::Kind::relation);
    wish.relation = relation.kind;
    if (!relation.target.empty()) {
      wish.clause += " " + relation.target;
      wish.targets = {relation.target};
    }
    draft.wishes.push_back(std::move(wish));
  }
}

Status check_targets(const Draft& draft, const std::string& room_id, const std::vector<Relation>& relations) {
  std::vector<Object> there;
  for (const auto& object : draft.scene.objects)
    if (object.room == room_id) there.push_back(object);
  const Room& room = room_with_id(draft.scene, room_id);
  const auto known = known_relations(relations, room, there);
  for (const auto& relation : relations)
    if (takes_target(relation.kind) && std::find(known.begin(), known.end(), relation) == known.end())
      return cannot("there is no \"" + relation.target + "\" in the room");
  return {};
}

}  // namespace roomgen
