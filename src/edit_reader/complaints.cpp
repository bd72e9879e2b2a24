#include "clause.h"
#include "size_phrases.h"
#include "spoken_clause.h"
#include "wording.h"

namespace roomgen {

namespace {

// "too close to the TV" is away from it, "too far from the sofa" is near it.
std::optional<ReadClause> too_near_or_far(const EditText& text, const Read<Ids>& what) {
  const auto place = destination_at(text, what.end, what.value);
  if (!place) return std::nullopt;
  if (!*place) return place->error();
  std::vector<Relation> wanted;
  for (const auto& relation : (*place)->relations) {
    const bool is_far = relation.kind == RelationKind::far;
    if (!is_far && relation.kind != RelationKind::near && relation.kind != RelationKind::next_to) return std::nullopt;
    const Relation opposite{is_far ? RelationKind::near : RelationKind::far, relation.target};
    if (std::find(wanted.begin(), wanted.end(), opposite) == wanted.end()) wanted.push_back(opposite);
  }
  return of_each(what, (*place)->end, [&](const std::string& id) { return edit::Move{id, wanted}; });
}

bool hangs(const EditText& text, const std::string& id) {
  const Object* object = text.object(id);
  return object && (object->mount == Mount::wall || object->mount == Mount::ceiling);
}

// "too small" is to be bigger; what hangs too high is to hang lower.
std::optional<ReadClause> too_large_or_small(const EditText& text, const Read<Ids>& what) {
  if (what.end >= text.tokens.size()) return std::nullopt;
  const auto growth = growth_of_adjective(text, text.tokens[what.end].text);
  if (!growth) return std::nullopt;
  const bool is_of_height = text.is_word(what.end, "high") || text.is_word(what.end, "low");
  return of_each(what, what.end + 1, [&](const std::string& id) -> edit::Operation {
    if (is_of_height && hangs(text, id))
      return edit::Shift{id, Vec3(0.0, 0.0, growth->factor > 1.0 ? -usual_lift : usual_lift)};
    return edit::Resize{id, resized(text.object(id)->size, {growth->side, 1.0 / growth->factor, {}, {}})};
  });
}

std::optional<ReadClause> too_much(const EditText& text, const Read<Ids>& what) {
  const auto too = longest_in(text.edits.too, text.tokens, what.end);
  if (too == 0) return std::nullopt;
  const Read<Ids> subject{what.value, what.end + too};
  if (auto size = too_large_or_small(text, subject)) return size;
  return too_near_or_far(text, subject);
}

std::optional<ReadClause> in_the_way(const EditText& text, const Read<Ids>& what) {
  const auto length = longest_in(text.edits.in_the_way_of, text.tokens, what.end);
  const auto target = length > 0 ? target_at(text, what.end + length, what.value) : std::nullopt;
  if (!target) return std::nullopt;
  if (!*target) return target->error();
  return of_each(what, (*target)->end, [&](const std::string& id) {
    return edit::Move{id, {{RelationKind::far, (*target)->id}}};
  });
}

std::optional<ReadClause> facing_wrongly(const EditText& text, const Read<Ids>& what) {
  const auto length = longest_in(text.edits.wrong_way, text.tokens, what.end);
  if (length == 0) return std::nullopt;
  return of_each(what, what.end + length, [](const std::string& id) { return edit::Turn{id, pi}; });
}

}  // namespace

std::optional<ReadClause> complaint_at(const EditText& text, std::size_t at) {
  for (const bool with_places : {false, true}) {
    const auto what = things(text, at, with_places);
    if (!what) continue;
    for (const auto& id : what->value)
      if (!find_object(text.scene, id)) return std::nullopt;
    for (const auto& read : {too_much, in_the_way, facing_wrongly})
      if (auto complaint = read(text, *what); complaint && goes_to_its_end(text, *complaint)) return complaint;
  }
  return std::nullopt;
}

}  // namespace roomgen
