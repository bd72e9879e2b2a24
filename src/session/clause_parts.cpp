#include "clause_parts.h"

#include <algorithm>

#include "create/finish_look.h"
#include "language/measure.h"
#include "language/number.h"
#include "new_things.h"
#include "reference_tails.h"
#include "roomgen/base/text.h"
#include "scene/finish_words.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;

constexpr double below_ceiling = 0.01;  // metres left above what reaches up to it

MayRead<Ids> all_but(const EditText& text, Read<Ids> all) {
  const bool is_comma = text.is_comma(all.end);
  const std::size_t begin = text.behind_comma(all.end);
  const auto length = longest_in(is_comma ? text.edits.besides : text.edits.except, text.tokens, begin);
  if (length == 0) return all;
  const auto others = things_at(text, begin + length, true);
  if (!others) return all;
  if (!*others) return others->error();
  std::erase_if(all.value, [&](const std::string& id) {
    return std::count((*others)->value.begin(), (*others)->value.end(), id) > 0;
  });
  all.end = (*others)->end;
  if (is_comma && text.ends(all.end) && all.end < text.tokens.size() && !text.is_word(all.end, "and")) ++all.end;
  return all;
}

MayRead<Ids> one_reference_at(const EditText& text, std::size_t at, bool with_places) {
  const auto thing = named_thing_at(text, at);
  if (!thing) return std::nullopt;
  if (thing->which == Which::indefinite && thing->further) return std::nullopt;
  if (with_places)
    if (auto told = told_by_tail(text, *thing)) return *told ? all_but(text, **told) : MayRead<Ids>(told->error());
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
  if ((side == "shorter" || side == "longest") && size.z() > std::max(size.x(), size.y())) return size.z();
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

// "20 %", "a quarter", "three quarters": a share of one.
std::optional<Read<double>> share_at(const EditText& text, std::size_t at) {
  if (const auto named = longest(text.edits.shares, text.tokens, at)) return Read<double>{*named.value, at + named.length};
  const auto number = language::number_at(text.raw, at);
  if (!number) return std::nullopt;
  const std::size_t end = at + number->length;
  for (const char* percent : {"%", "percent", "pct"})
    if (text.is_word(end, percent)) return Read<double>{number->value / 100.0, end + 1};
  return std::nullopt;
}

// "20 % bigger", "smaller by a quarter", "three quarters of its length"
std::optional<Read<NewSize>> shared_size(const EditText& text, std::size_t at) {
  if (const auto share = share_at(text, at)) {
    if (const auto growth = longest(text.edits.growth, text.tokens, share->end))
      return Read<NewSize>{{growth.value->side, growth.value->factor > 1.0 ? 1.0 + share->value : 1.0 - share->value, {}, {}},
                           share->end + growth.length};
    if (!text.is_word(share->end, "of")) return std::nullopt;
    std::size_t side = share->end + 1;
    if (text.is_word(side, "its") || text.is_word(side, "their") || text.is_word(side, "the")) ++side;
    const auto measured = longest(text.edits.measured, text.tokens, side);
    if (!measured) return std::nullopt;
    return Read<NewSize>{{*measured.value, share->value, {}, {}}, side + measured.length};
  }
  const auto growth = longest(text.edits.growth, text.tokens, at);
  if (!growth || !text.is_word(at + growth.length, "by")) return std::nullopt;
  const auto share = share_at(text, at + growth.length + 1);
  if (!share) return std::nullopt;
  return Read<NewSize>{{growth.value->side, growth.value->factor > 1.0 ? 1.0 + share->value : 1.0 - share->value, {}, {}}, share->end};
}

// "taller by 20 cm"
std::optional<Read<NewSize>> grown_by_length(const EditText& text, std::size_t at) {
  const auto growth = longest(text.edits.growth, text.tokens, at);
  if (!growth || !text.is_word(at + growth.length, "by") || growth.value->side == "all") return std::nullopt;
  const auto measure = language::measure_at(text.raw, at + growth.length + 1);
  if (!measure || measure->kind != language::Measure::Kind::length || !measure->has_unit) return std::nullopt;
  NewSize size{growth.value->side, 0.0, {}, {}};
  size.more = growth.value->factor > 1.0 ? measure->values[0] : -measure->values[0];
  return Read<NewSize>{size, at + growth.length + 1 + measure->length};
}

// "narrower, say 30 cm deep"
std::size_t behind_say(const EditText& text, std::size_t at) {
  at = text.behind_comma(at);
  return at + longest_in(text.edits.hedges, text.tokens, at);
}

}  // namespace

MayRead<Ids> things_at(const EditText& text, std::size_t at, bool with_places) {
  auto all = one_reference_at(text, at, with_places);
  if (!all || !*all) return all;
  while ((*all)->end < text.tokens.size() &&
         (text.is_word((*all)->end, "and") || text.is_comma((*all)->end))) {
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

bool describes_looks(const std::string& words) { return describes(words, false) || describes(words, true); }

MayRead<std::string> looks_at(const EditText& text, std::size_t at, bool of_room) {
  while (is_filler(text, at)) ++at;
  std::size_t end = at;
  while (!text.ends(end) || goes_on_with_look(text, end, of_room)) ++end;
  while (end > at && longest_in(text.edits.closers, text.tokens, end - 1) == 1) --end;
  if (end == at) return std::nullopt;
  // "stand at its head" is no look, whatever else stands there.
  for (std::size_t i = at; i < end; ++i)
    if (text.words.stops.count(text.tokens[i].text) && !is_filler(text, i)) return std::nullopt;
  std::string words;
  for (std::size_t i = at; i < end; ++i)
    if (text.tokens[i].kind == EditText::Token::Kind::word) words += (words.empty() ? "" : " ") + text.tokens[i].text;
  if (!describes(words, of_room)) return std::nullopt;
  return Read<std::string>{words, end};
}

namespace {

// "as wide as the dresser", "as tall as the ceiling"
std::optional<Read<NewSize>> size_of_other(const EditText& text, std::size_t at) {
  const auto length = longest_in(text.edits.up_to_ceiling, text.tokens, at);
  if (length > 0) {
    NewSize size{"height", 0.0, {}, {}};
    size.exact = rooms_of(text.scene).front().height - below_ceiling;
    return Read<NewSize>{size, at + length};
  }
  if (!text.is_word(at, "as")) return std::nullopt;
  const auto side = longest(text.edits.measured, text.tokens, at + 1, 1);
  if (!side || !text.is_word(at + 2, "as")) return std::nullopt;
  const auto other = things_at(text, at + 3, false);
  if (!other || !*other || (*other)->value.size() != 1) return std::nullopt;
  const Object* object = find_object(text.scene, (*other)->value.front());
  if (!object) return std::nullopt;
  Vec3 theirs = object->size;
  NewSize size{*side.value, 0.0, {}, {}};
  size.exact = side_of_size(theirs, *side.value);
  return Read<NewSize>{size, (*other)->end};
}

}  // namespace

MayRead<NewSize> size_at(const EditText& text, std::size_t at) {
  at += longest_in(text.edits.hedges, text.tokens, at);
  if (const auto other = size_of_other(text, at)) return *other;
  for (const auto& read : {shared_size(text, at), grown_by_length(text, at), measured_size(text, at)})
    if (read) return *read;
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

namespace {

constexpr std::size_t most_adjectives = 5;

// "a light blue one", "taller ones with backs", "a three-seater in mustard", "something in brown leather": of the same kind.
std::optional<Read<Substitute>> another_of_kind(const EditText& text, std::size_t at) {
  std::size_t end = at + (text.is_word(at, "a") || text.is_word(at, "an") ? 1 : 0);
  const std::size_t begin = end;
  const bool is_vague = longest_in(text.edits.something, text.tokens, begin) > 0;
  while (!is_vague && !text.ends(end) && !text.is_word(end, "one") && !text.is_word(end, "ones") && !text.is_word(end, "seater") &&
         !text.words.stops.count(text.tokens[end].text))
    ++end;
  const bool is_seater = text.is_word(end, "seater");
  if (end >= text.tokens.size() || end - begin > most_adjectives || (!is_vague && !is_seater && !text.is_word(end, "one") && !text.is_word(end, "ones")))
    return std::nullopt;
  const auto behind = description_behind(text, end + 1);
  std::size_t last = behind.end;
  // "something softer"
  if (is_vague && last == end + 1)
    while (!text.ends(last) && !text.words.stops.count(text.tokens[last].text)) ++last;
  std::string description = text.words_from(begin, is_seater ? end + 1 : is_vague ? begin : end);
  const std::string tail = text.words_from(end + 1, last);
  if (!tail.empty()) description += (description.empty() ? "" : " ") + tail;
  if (description.empty()) return std::nullopt;
  return Read<Substitute>{{"", description}, last};
}

}  // namespace

MayRead<Substitute> substitute_at(const EditText& text, std::size_t at) {
  if (const auto same = another_of_kind(text, at)) return *same;
  const auto thing = new_thing_at(text, at);
  if (thing) return Read<Substitute>{{thing->kind.category->name, thing->description()}, thing->end};
  const auto bare = named_thing_at(text, at);
  if (!bare || !bare->bare || bare->which == Which::pronoun || !bare->kind.category) return std::nullopt;
  return Read<Substitute>{{bare->kind.category->name, bare->description()}, bare->end};
}

}  // namespace roomgen
