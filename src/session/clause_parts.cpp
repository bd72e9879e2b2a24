#include "clause_parts.h"

#include <algorithm>

#include "create/finish_look.h"
#include "language/measure.h"
#include "placing.h"
#include "roomgen/base/text.h"
#include "scene/finish_words.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;

Ids those_where(const EditText& text, Ids ids, const std::vector<Relation>& relations) {
  std::erase_if(ids, [&](const std::string& id) {
    const Object* object = find_object(text.scene, id);
    return !object || !lost_relations(*object, relations, text.scene, text.kinds).empty();
  });
  return ids;
}

double distance_to(const EditText& text, const Object& object, const std::string& target) {
  if (const Object* other = find_object(text.scene, target)) return gap(footprint(object), footprint(*other));
  const Room& room = room_of(text.scene, object);
  if (const Opening* opening = find_opening(room, target)) return gap(footprint(object), segment(room, *opening));
  return 1e9;
}

// "nearest the door": the one of them.
MayRead<Ids> nearest_of(const EditText& text, const Ids& ids, std::size_t at) {
  if (!text.is_word(at, "nearest") && !text.is_word(at, "closest")) return std::nullopt;
  const auto target = target_at(text, at + longest_in(text.edits.nearest, text.tokens, at), ids);
  if (!target) return std::nullopt;
  if (!*target) return target->error();
  const auto nearest = std::min_element(ids.begin(), ids.end(), [&](const std::string& a, const std::string& b) {
    return distance_to(text, *text.object(a), (*target)->id) < distance_to(text, *text.object(b), (*target)->id);
  });
  if (nearest == ids.end()) return std::nullopt;
  return Read<Ids>{{*nearest}, (*target)->end};
}

// "off the desk", "from the desk": what is cleared was on it.
std::optional<Result<Whereabouts>> place_of_reference(const EditText& text, std::size_t at, const NamedThing& thing,
                                                      const Ids& ids) {
  if (text.is_word(at, "off") || text.is_word(at, "from")) {
    const auto target = target_at(text, at + 1, {});
    if (!target) return std::nullopt;
    if (!*target) return target->error();
    return Whereabouts{{{RelationKind::on, (*target)->id}}, (*target)->end};
  }
  const auto place = destination_at(text, at, thing.which == Which::everything ? Ids() : ids);
  return place;
}

MayRead<Ids> all_but(const EditText& text, Read<Ids> all) {
  const auto length = longest_in(text.edits.except, text.tokens, all.end);
  if (length == 0) return all;
  const auto others = things_at(text, all.end + length, true);
  if (!others) return all;
  if (!*others) return others->error();
  std::erase_if(all.value, [&](const std::string& id) {
    return std::count((*others)->value.begin(), (*others)->value.end(), id) > 0;
  });
  all.end = (*others)->end;
  return all;
}

MayRead<Ids> just_added(const EditText& text, const NamedThing& thing) {
  const auto length = longest_in(text.edits.just_added, text.tokens, thing.end);
  if (length == 0) return std::nullopt;
  Ids ids = fitting(text, thing);
  std::erase_if(ids, [&](const std::string& id) {
    return std::find(text.recall.added.begin(), text.recall.added.end(), id) == text.recall.added.end();
  });
  if (ids.empty()) return not_understood("no \"" + thing.kind.name + "\" was added just now");
  return Read<Ids>{ids, thing.end + length};
}

MayRead<Ids> one_reference_at(const EditText& text, std::size_t at, bool with_places) {
  const auto thing = named_thing_at(text, at);
  if (!thing) return std::nullopt;
  if (thing->which == Which::indefinite && thing->further) return std::nullopt;
  if (auto added = just_added(text, *thing)) return added;
  if (thing->which != Which::pronoun && with_places) {
    const Ids all = fitting(text, *thing);
    if (auto nearest = nearest_of(text, all, thing->end)) return nearest;
    const auto place = place_of_reference(text, thing->end, *thing, all);
    if (place && !*place) return place->error();
    if (place) {
      const Ids among = those_where(text, all, (*place)->relations);
      const auto ids = meant(text, *thing, &among);
      if (!ids) return ids.error();
      return all_but(text, {*ids, (*place)->end});
    }
  }
  const auto ids = meant(text, *thing);
  if (!ids) return ids.error();
  return all_but(text, {*ids, thing->end});
}

bool begins_clause(const EditText& text, std::size_t at) { return longest(text.edits.verbs, text.tokens, at).length > 0; }

bool is_filler(const EditText& text, std::size_t at) {
  return at < text.tokens.size() && text.edits.words_of_looks.count(text.tokens[at].text) > 0;
}

bool describes(const std::string& words, bool of_room) {
  if (!of_room) return !create::read_look(words).empty();
  const auto all = split(words, ' ');
  return std::any_of(all.begin(), all.end(), [](const std::string& word) { return finish_words().describes(word); });
}

// "black and white": what follows belongs to it if it is a look and no thing.
bool goes_on_with_look(const EditText& text, std::size_t at, bool of_room) {
  return text.is_word(at, "and") && at + 1 < text.tokens.size() && describes(text.tokens[at + 1].text, of_room) &&
         text.ends(at + 2);
}

double& side_of_size(Vec3& size, const std::string& side) {
  if (side == "height") return size.z();
  if (side == "depth") return size.y();
  if (side == "width") return size.x();
  if (side == "shorter" && size.z() > std::max(size.x(), size.y())) return size.z();
  return size.x() >= size.y() ? size.x() : size.y();
}

std::optional<Read<NewSize>> measured_size(const EditText& text, std::size_t at) {
  const auto measure = language::measure_at(text.raw, at);
  if (!measure || measure->kind != language::Measure::Kind::length || !measure->has_unit) return std::nullopt;
  const std::size_t end = at + measure->length;
  NewSize size;
  if (const auto growth = longest(text.edits.growth, text.tokens, end)) {
    size.side = growth.value->side;
    size.more = growth.value->factor > 1.0 ? measure->values[0] : -measure->values[0];
    return Read<NewSize>{size, end + growth.length};
  }
  size.exact = measure->values[0];
  using Side = language::Measure::Side;
  switch (measure->side) {
    case Side::width: case Side::diameter: size.side = "width"; break;
    case Side::depth: size.side = "depth"; break;
    case Side::height: size.side = "height"; break;
    case Side::length: size.side = "long"; break;
    default: {
      const auto said = longest(text.edits.measured, text.tokens, end, 1);
      if (!said) return std::nullopt;
      size.side = *said.value;
      return Read<NewSize>{size, end + said.length};
    }
  }
  return Read<NewSize>{size, end};
}

// "narrower, say 30 cm deep"
std::size_t behind_say(const EditText& text, std::size_t at) {
  if (at < text.tokens.size() && text.tokens[at].kind == EditText::Token::Kind::comma) ++at;
  return at + longest_in(text.edits.hedges, text.tokens, at);
}

}  // namespace

MayRead<Ids> things_at(const EditText& text, std::size_t at, bool with_places) {
  auto all = one_reference_at(text, at, with_places);
  if (!all || !*all) return all;
  while ((*all)->end < text.tokens.size() &&
         (text.is_word((*all)->end, "and") || text.tokens[(*all)->end].kind == EditText::Token::Kind::comma)) {
    std::size_t next = (*all)->end + 1;
    if (text.is_word(next, "and")) ++next;
    if (begins_clause(text, next)) break;
    const auto more = one_reference_at(text, next, with_places);
    if (!more || !*more) break;
    for (const auto& id : (*more)->value)
      if (!std::count((*all)->value.begin(), (*all)->value.end(), id)) (*all)->value.push_back(id);
    (*all)->end = (*more)->end;
  }
  return all;
}

MayRead<std::string> looks_at(const EditText& text, std::size_t at, bool of_room) {
  while (is_filler(text, at)) ++at;
  std::size_t end = at;
  while (!text.ends(end) || goes_on_with_look(text, end, of_room)) ++end;
  while (end > at && longest_in(text.edits.closers, text.tokens, end - 1) == 1) --end;
  if (end == at) return std::nullopt;
  std::string words;
  for (std::size_t i = at; i < end; ++i)
    if (text.tokens[i].kind == EditText::Token::Kind::word) words += (words.empty() ? "" : " ") + text.tokens[i].text;
  if (!describes(words, of_room)) return std::nullopt;
  return Read<std::string>{words, end};
}

MayRead<NewSize> size_at(const EditText& text, std::size_t at) {
  if (auto measured = measured_size(text, at)) return *measured;
  const auto growth = longest(text.edits.growth, text.tokens, at);
  if (!growth) return std::nullopt;
  const std::size_t end = at + growth.length;
  if (const auto exact = measured_size(text, behind_say(text, end)); exact && exact->value.exact) return *exact;
  return Read<NewSize>{{growth.value->side, growth.value->factor, {}, {}}, end};
}

Vec3 resized(const Vec3& size, const NewSize& change) {
  Vec3 now = size;
  if (change.side == "all") return change.factor > 0.0 ? Vec3(change.factor * size) : now;
  double& side = side_of_size(now, change.side);
  if (change.exact) side = *change.exact;
  else if (change.more) side += *change.more;
  else side *= change.factor;
  return now;
}

MayRead<Substitute> substitute_at(const EditText& text, std::size_t at) {
  const auto thing = named_thing_at(text, at);
  if (thing && thing->which != Which::pronoun && thing->kind.category &&
      (thing->which == Which::indefinite || thing->bare))
    return Read<Substitute>{{thing->kind.category->name, thing->description()}, thing->end};
  // "a smaller one", "taller ones with backs"
  std::size_t end = at;
  std::string description;
  if (text.is_word(end, "a") || text.is_word(end, "an")) ++end;
  for (; !text.ends(end) && !text.is_word(end, "one") && !text.is_word(end, "ones"); ++end)
    description += (description.empty() ? "" : " ") + text.tokens[end].text;
  if (text.ends(end) || end - at > 5) return std::nullopt;
  ++end;
  for (; !text.ends(end); ++end) description += " " + text.tokens[end].text;
  return Read<Substitute>{{"", description}, end};
}

}  // namespace roomgen
