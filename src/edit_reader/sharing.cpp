#include "clause_parts.h"

namespace roomgen {

namespace {

// ", one each": says only that it is shared.
std::size_t skip_one_each(const EditText& text, std::size_t at) {
  if (text.is_word(at, "out") || text.is_word(at, "around")) ++at;
  const std::size_t begin = text.behind_comma(at);
  auto length = longest_in(text.edits.one_each, text.tokens, begin);
  if (length > 1 && (text.is_word(begin + length, "side") || text.is_word(begin + length, "end"))) --length;
  return length > 0 ? begin + length : at;
}

std::vector<Relation> in_corner(const char* quarter) {
  return {{RelationKind::corner, ""}, {RelationKind::in_part, quarter}};
}

std::optional<Read<SharedPlaces>> corners_at(const EditText& text, std::size_t at) {
  const auto length = longest_in(text.edits.each_corner, text.tokens, at);
  if (length == 0) return std::nullopt;
  SharedPlaces shared;
  for (const char* quarter : {"south-west-quarter", "south-east-quarter", "north-east-quarter", "north-west-quarter"})
    shared.places.push_back(in_corner(quarter));
  return Read<SharedPlaces>{shared, at + length};
}

// On a table that carries small things, else to its left and to its right.
std::vector<std::vector<Relation>> both_sides(const EditText& text, const std::string& id, bool is_small) {
  const Object* target = text.object(id);
  const bool carries =
      target && is_small && target->mount != Mount::surface && text.kinds.get(target->category).supports;
  if (carries) return {{{RelationKind::on, id}}, {{RelationKind::on, id}}};
  return {{{RelationKind::left_of, id}}, {{RelationKind::right_of, id}}};
}

MayRead<SharedPlaces> sides_at(const EditText& text, std::size_t at, bool is_small) {
  const std::size_t before = text.is_word(at, "each") || text.is_word(at, "either") ? 0 : 1;
  const auto said = brief::longest(text.words.placements, text.tokens, at);
  std::size_t end = at + said.length;
  const bool is_flank = said && said.value->flank && !said.value->inverse && !said.value->pronoun;
  // "one each side of the TV"
  const bool is_bare = !is_flank && before == 0 && (text.is_word(at + 1, "side") || text.is_word(at + 1, "end")) &&
                       text.is_word(at + 2, "of");
  if (!is_flank && !is_bare) return std::nullopt;
  if (is_bare) end = at + 3;
  const auto target = target_at(text, end, {});
  if (!target) return std::nullopt;
  if (!*target) return target->error();
  bool is_each = false;
  for (std::size_t i = at; i < end; ++i) is_each = is_each || text.is_word(i, "each") || text.is_word(i, "every");
  return Read<SharedPlaces>{{both_sides(text, (*target)->id, is_small), true, is_each}, (*target)->end};
}

// "on each desk": what stands there is said of all.
MayRead<SharedPlaces> each_thing_at(const EditText& text, std::size_t at) {
  const auto said = brief::longest(text.words.placements, text.tokens, at);
  if (!said || said.value->relations.empty() || said.value->flank || said.value->inverse) return std::nullopt;
  const auto thing = named_thing_at(text, at + said.length);
  if (!thing || thing->which != NamedThing::Which::all) return std::nullopt;
  const auto all = things_at(text, at + said.length, false);
  if (!all) return std::nullopt;
  if (!*all) return all->error();
  SharedPlaces shared;
  for (const auto& id : (*all)->value) shared.places.push_back({{said.value->relations.front(), id}});
  return Read<SharedPlaces>{shared, (*all)->end};
}

// "to the windows", "at every window": one at each of them.
MayRead<SharedPlaces> openings_at(const EditText& text, std::size_t at) {
  const auto kinds = placed_by(text, at);
  if (!kinds || kinds->value.size() != 1) return std::nullopt;
  const auto place = place_named_at(text, kinds->end);
  if (!place || (place->place != brief::Place::window && place->place != brief::Place::door))
    return std::nullopt;
  const std::size_t end = kinds->end + place->length;
  bool is_all = text.tokens[end - 1].text.ends_with("s");
  for (std::size_t i = kinds->end; i < end; ++i) is_all = is_all || text.edits.all.count(text.tokens[i].text) > 0;
  if (!is_all) return std::nullopt;
  SharedPlaces shared;
  for (const auto& id : openings_at_place(text, *place)) shared.places.push_back({{kinds->value.front(), id}});
  if (shared.places.empty()) return std::nullopt;
  return Read<SharedPlaces>{shared, end};
}

}  // namespace

MayRead<SharedPlaces> shared_places_at(const EditText& text, std::size_t at, bool is_small) {
  at = skip_one_each(text, at);
  if (const auto corners = corners_at(text, at)) return *corners;
  if (auto sides = sides_at(text, at, is_small)) return sides;
  if (auto openings = openings_at(text, at)) return openings;
  return each_thing_at(text, at);
}

}  // namespace roomgen
