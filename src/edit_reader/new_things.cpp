#include <algorithm>

#include "clause.h"
#include "clause_parts.h"
#include "kinds/noun_kind.h"
#include "language/inflection.h"
#include "roomgen/base/text.h"
#include "spoken_clause.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;

bool is_article(const EditText& text, std::size_t at) { return text.is_word(at, "a") || text.is_word(at, "an"); }

// Up to a word that begins something else.
std::size_t end_of_words(const EditText& text, std::size_t at) {
  const auto begins_other = [&](std::size_t i) {
    for (const auto* set : {&text.edits.closers, &text.edits.substitutes, &text.edits.welcome, &text.edits.auxiliaries})
      if (longest_in(*set, text.tokens, i) > 0) return true;
    return text.words.stops.count(text.tokens[i].text) > 0;
  };
  while (!text.ends(at) && !begins_other(at)) ++at;
  return at;
}

bool is_known(const EditText& text, std::size_t at) {
  const auto thing = named_thing_at(text, at);
  return (thing && thing->which != Which::indefinite && !fitting(text, *thing).empty()) || room_part_at(text, at);
}

// "in bottle-green leather", "of tulips"
std::size_t end_of_matter(const EditText& text, std::size_t at) {
  const auto length = longest_in(text.edits.made_of, text.tokens, at);
  if (length == 0) return at;
  const std::size_t begin = at + length + (is_article(text, at + length) ? 1 : 0);
  const std::size_t end = end_of_words(text, begin);
  if (end == begin) return at;
  if (describes_looks(text.words_from(begin, end))) return end;
  const bool is_content = text.is_word(at, "of") && length == 1 && !is_known(text, begin);
  return is_content ? end : at;
}

bool is_part(const EditText& text, const brief::KindMention& kind) {
  return text.words.parts.count(kind.name) > 0 || kind.length == 0;
}

// "with a gold frame": but a thing of its own stands on it, or at it.
std::size_t end_of_with(const EditText& text, std::size_t at, const Kind* kind) {
  if (!text.is_word(at, "with") && !text.is_word(at, "without")) return at;
  const auto thing = named_thing_at(text, at + 1);
  // A vase holds its flowers, but a table has its lamp on it.
  const bool is_own = thing && kind && kind->mount == Mount::surface && !kind->supports;
  if (thing && !is_own && !is_part(text, thing->kind)) return at;
  std::size_t begin = at + 1;
  if (is_article(text, begin) || (begin < text.tokens.size() && text.words.vague.count(text.tokens[begin].text)))
    ++begin;
  const std::size_t end = end_of_words(text, begin);
  return end > begin ? end : at;
}

// "that seats six", "for four"
std::size_t end_of_clause(const EditText& text, std::size_t at) {
  // "a hook for my bathrobe", which is not here
  if (text.is_word(at, "for") && !is_known(text, at + 1) && at + 1 < text.tokens.size() &&
      text.words.definite.count(text.tokens[at + 1].text)) {
    const std::size_t end = end_of_words(text, at + 2);
    return end > at + 2 ? end : at;
  }
  if (text.is_word(at, "for") && at + 1 < text.tokens.size() && text.words.numbers.count(text.tokens[at + 1].text))
    return end_of_words(text, at + 2);
  if (!text.is_word(at, "that") && !text.is_word(at, "which")) return at;
  if (at + 1 >= text.tokens.size() || !language::verb(text.tokens[at + 1].text)) return at;
  std::size_t end = at + 2;
  for (; !text.ends(end); ++end)
    if (is_known(text, end)) return at;
  return end;
}

// "identical to the first", "like the existing one": `like` is what such a thing is described by.
std::size_t end_of_likeness(const EditText& text, const NamedThing& thing, std::size_t at) {
  const std::size_t begin = text.behind_comma(at);
  const auto length = longest_in(text.edits.like_it, text.tokens, begin);
  if (length == 0) return at;
  std::size_t end = begin + length;
  if (const auto other = named_thing_at(text, end); other && other->which == Which::pronoun) return other->end;
  if (end >= text.tokens.size() || !text.words.definite.count(text.tokens[end].text)) return at;
  for (++end; !text.ends(end) && text.edits.existing.count(text.tokens[end].text);) ++end;
  if (text.is_word(end, "one") || text.is_word(end, "ones")) return end + 1;
  const auto named = named_thing_at(text, end);
  return named && named->kind.category == thing.kind.category ? named->end : end;
}

bool has_article(const NamedThing& thing) { return thing.which == Which::indefinite || thing.further; }

// Without an article only what is put to a place that there is: "put detergent on the shelf", but not "buy milk".
bool is_clearly_a_thing(const EditText& text, const NamedThing& thing) {
  if (thing.kind.is_stand_in() || thing.looks.size() > 1) return false;
  for (std::size_t i = thing.begin; i < thing.end; ++i)
    if (verb_at(text, i) || longest_in(text.edits.hedges, text.tokens, i) > 0) return false;
  const auto place = destination_at(text, thing.end, {});
  return place && *place;
}

// "a webcam", "two tumblers": names that no kind has by itself.
std::optional<NamedThing> inferred_thing_at(const EditText& text, std::size_t at, bool may_be_bare) {
  NamedThing thing;
  thing.begin = at;
  at = skip_determiners(text, at, thing);
  if (thing.bare ? !may_be_bare : !has_article(thing)) return std::nullopt;
  thing.which = Which::indefinite;
  const std::size_t end = end_of_words(text, at);
  if (end == at || end - at > 4) return std::nullopt;
  for (std::size_t i = at; i < end; ++i)
    if (text.tokens[i].kind != brief::Token::Kind::word) return std::nullopt;
  for (std::size_t first = end - std::min<std::size_t>(end - at, 2); first < end; ++first) {
    const std::string noun = language::singular(text.words_from(first, end));
    const auto known = inferred_kind(text.kinds, noun);
    if (!known.kind) continue;
    thing.kind = {known.kind, end - first, noun != text.words_from(first, end), noun, known.basis, ""};
    for (std::size_t i = at; i < first; ++i) thing.looks.push_back(text.tokens[i].text);
    thing.plural = thing.kind.plural || thing.count > 1;
    thing.end = end;
    if (thing.bare && !is_clearly_a_thing(text, thing)) return std::nullopt;
    return thing;
  }
  return std::nullopt;
}

// "a sofa 3 m wide", "a rug of 2 x 3 m"; but "a lamp 30 cm to the left" is at a place.
void read_measures_behind(const EditText& text, NamedThing& thing) {
  for (;;) {
    std::size_t at = text.behind_comma(thing.end);
    const bool is_of = text.is_word(at, "of");
    if (is_of) ++at;
    const auto measure = measure_of_thing(text, at);
    if (!measure || (!is_of && measure->side == language::Measure::Side::unsaid &&
                     measure->kind != language::Measure::Kind::sides))
      return;
    thing.measures.push_back(*measure);
    thing.end = at + measure->length;
  }
}

bool is_new(const EditText& text, const NamedThing& thing) {
  return thing.kind.category && (has_article(thing) || (thing.bare && !thing.number && fitting(text, thing).empty()));
}

}  // namespace

Read<std::string> description_behind(const EditText& text, std::size_t at, const Kind* kind) {
  std::size_t end = at;
  for (bool more = true; more;) {
    const std::size_t next =
        std::max({end_of_matter(text, end), end_of_with(text, end, kind), end_of_clause(text, end)});
    more = next > end;
    end = next;
  }
  return {text.words_from(at, end), end};
}

std::optional<NamedThing> new_thing_at(const EditText& text, std::size_t at, bool may_be_bare) {
  const auto own = longest_in(text.edits.own, text.tokens, at);
  auto thing = named_thing_at(text, at + own);
  if (own > 0 && thing) thing->which = Which::indefinite;
  if (!thing || !thing->kind.category) thing = inferred_thing_at(text, at + own, may_be_bare);
  if (!thing || !is_new(text, *thing)) return std::nullopt;
  read_measures_behind(text, *thing);
  auto tail = description_behind(text, thing->end, thing->kind.category);
  thing->tail = tail.value;
  thing->end = end_of_likeness(text, *thing, tail.end);
  return thing;
}

std::vector<NamedThing> new_things_at(const EditText& text, std::size_t at, bool may_be_bare) {
  std::vector<NamedThing> all;
  for (std::size_t next = at;;) {
    const auto thing = new_thing_at(text, next, may_be_bare);
    if (!thing) break;
    all.push_back(*thing);
    next = thing->end;
    if (!text.is_word(next, "and") && !text.is_comma(next)) break;
    ++next;
    if (text.is_word(next, "and")) ++next;
  }
  return all;
}

}  // namespace roomgen
