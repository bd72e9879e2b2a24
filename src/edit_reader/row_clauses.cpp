#include "clause.h"

namespace roomgen {

namespace {

constexpr double usual_pull = 0.3;  // metres, of a chair from its table

// What its chair is to a table.
std::string host_of(const EditText& text, const Object& object) {
  for (const auto kind : {RelationKind::around, RelationKind::face_to, RelationKind::in_front_of, RelationKind::near})
    for (const auto& relation : object.relations)
      if (relation.kind == kind && find_object(text.scene, relation.target)) return relation.target;
  return "";
}

}  // namespace

ReadClause read_tuck(const EditText& text, std::size_t at) {
  const auto what = things(text, at, true);
  if (!what) return what.error();
  Clause clause{{}, what->value, {}, what->end};
  for (const auto& id : what->value) {
    const Object* object = find_object(text.scene, id);
    const std::string host = object ? host_of(text, *object) : "";
    if (host.empty()) return not_understood("it is not clear under what " + id + " shall be pushed");
    clause.operations.push_back(edit::Move{id, {{RelationKind::around, host}, {RelationKind::face_to, host}}});
  }
  return clause;
}

ReadClause read_untuck(const EditText& text, std::size_t at) {
  const auto what = things(text, at, true);
  if (!what) return what.error();
  Shifting away{{}, 0.0, {}, {}, usual_pull, what->end};
  if (const auto metres = amount_at(text, away.end)) away.metres = *metres;
  Clause clause{{}, what->value, {}, away.end};
  for (const auto& id : what->value) {
    const Object* object = find_object(text.scene, id);
    away.from = {object ? host_of(text, *object) : ""};
    if (away.from.front().empty()) return not_understood("it is not clear from what " + id + " shall be pulled");
    auto pulled = read_shift(text, {id}, away, false);
    if (!pulled) return pulled;
    clause.operations.push_back(pulled->operations.front());
  }
  return clause;
}

ReadClause read_line(const EditText& text, std::size_t at) {
  const auto what = things(text, at, false);
  if (!what) return what.error();
  const auto target = text.is_word(what->end, "with") ? target_at(text, what->end + 1, what->value) : std::nullopt;
  if (target && *target)
    return of_each(*what, (*target)->end, [&](const std::string& id) {
      return edit::Move{id, {{RelationKind::aligned, (*target)->id}}};
    });
  const std::size_t up = what->end + (text.is_word(what->end, "up") ? 1 : 0);
  const auto place = destination_at(text, up, what->value);
  if (!place) return what_at(text, up, "it is not clear along what");
  if (!*place) return place->error();
  if ((*place)->spot) return what_at(text, up, "it is not clear along what");
  return of_each(*what, (*place)->end, [&](const std::string& id) { return edit::Move{id, (*place)->relations}; });
}

}  // namespace roomgen
