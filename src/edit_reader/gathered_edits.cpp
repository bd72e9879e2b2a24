#include "gathered_edits.h"

#include <algorithm>

namespace roomgen {

void GatheredEdits::add(const Clause& clause) {
  drop_superseded(clause);
  for (const auto& operation : clause.operations)
    if (std::find(operations.begin(), operations.end(), operation) == operations.end() ||
        !std::holds_alternative<edit::Remove>(operation))
      operations.push_back(operation);
  if (!clause.in_place_of.empty()) taken_over_[clause.about.front()] = clause.in_place_of;
}

// "take it off the stool and put it on the shelf" is one way.
void GatheredEdits::drop_superseded(const Clause& clause) {
  for (const auto& later : clause.operations) {
    const auto* to = std::get_if<edit::Move>(&later);
    if (!to) continue;
    for (auto& earlier : operations)
      if (auto* gone = std::get_if<edit::Remove>(&earlier)) std::erase(gone->objects, to->object);
    std::erase_if(operations, [&](const edit::Operation& earlier) {
      if (const auto* gone = std::get_if<edit::Remove>(&earlier)) return gone->objects.empty();
      const auto* from = std::get_if<edit::Move>(&earlier);
      return from && from->object == to->object && from->relations.size() == 1 &&
             from->relations.front().kind == RelationKind::far;
    });
  }
}

bool GatheredEdits::fold_looks(const Clause& clause, const EditText& text) {
  if (operations.empty() || clause.operations.empty() || clause.about != text.latest) return false;
  for (const auto& operation : clause.operations)
    if (!std::holds_alternative<edit::Recolor>(operation)) return false;
  const auto is_latest = [&](const std::string& id) {
    return std::count(text.latest.begin(), text.latest.end(), id) > 0;
  };
  const std::string looks = std::get<edit::Recolor>(clause.operations.front()).looks;
  std::size_t folded = 0;
  for (auto& operation : operations) {
    std::string* words = nullptr;
    if (auto* replace = std::get_if<edit::Replace>(&operation); replace && is_latest(replace->object))
      words = &replace->description;
    if (auto* add = std::get_if<edit::Add>(&operation); add && &operation == &operations.back())
      words = &add->description;
    if (auto* recolor = std::get_if<edit::Recolor>(&operation); recolor && is_latest(recolor->object))
      words = &recolor->looks;
    if (words) *words += " in " + looks, ++folded;
  }
  return folded > 0;
}

bool GatheredEdits::fold_place(const Clause& clause, const EditText& text) {
  auto* add = operations.empty() ? nullptr : std::get_if<edit::Add>(&operations.back());
  const bool is_of_it = clause.operations.size() == 1 && clause.about == text.latest && clause.about.size() == 1 &&
                        find_object(text.coming, clause.about.front());
  const auto* move = is_of_it ? std::get_if<edit::Move>(&clause.operations.front()) : nullptr;
  if (!add || !move || add->count != 1 || !add->relations.empty() || !add->room.empty()) return false;
  add->relations = move->relations;
  add->room = move->room;
  return true;
}

ReadClause GatheredEdits::likewise(const EditText& text, const Read<Ids>& what) const {
  if (operations.empty()) return what_at(text, what.end, "not understood");
  const auto& last = operations.back();
  if (const auto* move = std::get_if<edit::Move>(&last))
    return of_each(what, what.end, [&](const std::string& id) { return edit::Move{id, move->relations}; });
  if (const auto* recolor = std::get_if<edit::Recolor>(&last))
    return of_each(what, what.end, [&](const std::string& id) { return edit::Recolor{id, recolor->looks}; });
  if (const auto* face = std::get_if<edit::Face>(&last))
    return of_each(what, what.end, [&](const std::string& id) { return edit::Face{id, face->target}; });
  if (std::holds_alternative<edit::Remove>(last))
    return Clause{{edit::Remove{what.value, false}}, {}, {}, what.end, what.value};
  return what_at(text, what.end, "not understood");
}

ReadClause GatheredEdits::vice_versa(const EditText& text, std::size_t end) const {
  if (taken_over_.size() != 1) return not_understood("it is not clear what shall be the other way around");
  const auto [object, of] = *taken_over_.begin();
  const Object* there = text.object(object);
  if (!there) return not_understood(object + " has no place yet");
  Clause clause{{edit::Put{of, there->position.head<2>(), {}, there->on}}, {of}, {}, end};
  clause.in_place_of = object;
  return clause;
}

std::vector<edit::Operation> GatheredEdits::settled() const {
  std::vector<edit::Operation> all = operations;
  for (const auto& taken : taken_over_) {
    const std::string &object = taken.first, &of = taken.second;
    const bool is_mutual = taken_over_.count(of) && taken_over_.at(of) == object;
    std::erase_if(all, [&](const edit::Operation& operation) {
      const auto* put = std::get_if<edit::Put>(&operation);
      return is_mutual && put && (put->object == object || put->object == of);
    });
    if (is_mutual && object < of) all.push_back(edit::Swap{object, of});
  }
  std::stable_partition(all.begin(), all.end(), [&](const edit::Operation& operation) {
    const auto* put = std::get_if<edit::Put>(&operation);
    return !put || !taken_over_.count(put->object);
  });
  return all;
}

}  // namespace roomgen
