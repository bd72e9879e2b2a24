#include "references.h"

#include "brief/mention_shape.h"
#include "destinations.h"
#include "language/inflection.h"
#include "language/number.h"
#include "roomgen/base/text.h"
#include "scene_nouns.h"

namespace roomgen {

namespace {

using brief::KindMention;
using Which = NamedThing::Which;

constexpr std::size_t most_adjectives = 5;

bool may_be_adjective(const EditText& text, std::size_t at) {
  const auto& token = text.tokens[at];
  return token.kind == EditText::Token::Kind::word && !text.words.stops.count(token.text) &&
         !text.edits.verbs.count(token.text) && !text.words.numbers.count(token.text) &&
         !text.words.definite.count(token.text) && !text.words.room_parts.count(token.text);
}

std::optional<std::size_t> read_adjective(const EditText& text, std::size_t at, NamedThing& thing) {
  if (const auto measure = measure_of_thing(text, at)) {
    thing.measures.push_back(*measure);
    return at + measure->length;
  }
  if (!thing.bare && text.edits.middles.count(text.tokens[at].text)) {
    thing.middle = true;
    return at + 1;
  }
  if (const auto side = brief::longest(text.edits.sides, text.tokens, at, 2)) {
    thing.side = *side.value;
    return at + side.length;
  }
  if (text.edits.sizes.count(text.tokens[at].text)) {
    thing.size = text.edits.sizes.at(text.tokens[at].text);
    thing.looks.push_back(text.tokens[at].text);
    // "the smaller of the two tables"
    if (text.is_word(at + 1, "of")) {
      NamedThing others;
      const auto next = skip_determiners(text, at + 2, others);
      if (next > at + 2) return next;
    }
    return at + 1;
  }
  if (text.edits.more.count(text.tokens[at].text)) {
    thing.further = true;
    thing.other = text.is_word(at, "other");
    if (const auto nth = language::ordinal_at(text.raw, at)) thing.nth = nth;
    return at + 1;
  }
  if (!may_be_adjective(text, at)) return std::nullopt;
  thing.looks.push_back(text.tokens[at].text);
  return at + 1;
}

// The name of a kind that ends its phrase: of "glass table" the glass is an adjective.
KindMention head_at(const EditText& text, std::size_t at) {
  if (at >= text.tokens.size()) return {};
  KindMention mention = brief::mention_at(text.kinds, text.tokens, at);
  if (mention.length == 0) return mention;
  const std::size_t next = at + mention.length;
  const auto fits = [&](const KindMention& one) {
    NamedThing thing;
    thing.kind = one;
    return !fitting(text, thing).empty();
  };
  // "the ironing board blocks everything": the blocks are a verb.
  const auto follower = brief::mention_at(text.kinds, text.tokens, next);
  const auto deed = follower.length == 1 ? language::verb(text.tokens[next].text) : std::nullopt;
  if (deed && deed->form == language::VerbForm::third_person && fits(mention) && !fits(follower)) return mention;
  if (!mention.plural && next < text.tokens.size() &&
      !text.words.stops.count(text.tokens[next].text) &&
      longest_in(text.edits.hedges, text.tokens, next) == 0 &&
      !text.edits.verbs.count(text.tokens[next].text) &&
      brief::mention_at(text.kinds, text.tokens, next).length > 0)
    return {};
  return mention;
}

std::optional<NamedThing> pronoun_at(const EditText& text, std::size_t at) {
  NamedThing thing;
  thing.begin = at;
  if (const auto length = longest_in(text.edits.pronouns, text.tokens, at)) {
    thing.which = Which::pronoun;
    thing.plural = text.is_word(at, "them") || text.is_word(at, "these") || text.is_word(at, "those");
    thing.end = at + length;
    return thing;
  }
  if (const auto length = longest_in(text.edits.everything, text.tokens, at)) {
    thing.which = Which::everything;
    thing.plural = true;
    thing.end = at + length;
    return thing;
  }
  return std::nullopt;
}

// "chair-2" comes as two tokens.
void read_number_of_id(const EditText& text, NamedThing& thing) {
  if (thing.end >= text.raw.size()) return;
  const auto& token = text.raw[thing.end];
  if (token.kind != language::Token::Kind::number || token.joint != language::Token::Joint::hyphen) return;
  thing.number = static_cast<int>(token.value);
  ++thing.end;
}

// "two chairs more"
void read_more_behind(const EditText& text, NamedThing& thing) {
  if (thing.which != Which::indefinite || thing.bare || !text.is_word(thing.end, "more")) return;
  thing.further = true;
  ++thing.end;
}

// "one basket …, and the other one …": two that are there.
void read_one_and_other(const EditText& text, NamedThing& thing) {
  if (!text.is_word(thing.begin, "one") || thing.further || thing.any || thing.count != 1) return;
  for (std::size_t i = thing.end; i < text.tokens.size() && !thing.any; ++i)
    thing.any = longest_in(text.edits.others, text.tokens, i) > 0;
  if (thing.any) thing.which = Which::definite;
}

// "basket number two"
void read_place_in_row(const EditText& text, NamedThing& thing) {
  if (!text.is_word(thing.end, "number") && !text.is_word(thing.end, "no") && !text.is_word(thing.end, "nr")) return;
  const auto number = language::number_at(text.raw, thing.end + 1);
  if (!number || number->value < 1 || number->value > 1000) return;
  thing.place = static_cast<int>(number->value);
  thing.end += 1 + number->length;
}

// "from the left", behind "the second chair"
void read_counted_side(const EditText& text, NamedThing& thing) {
  if (!thing.nth || !text.is_word(thing.end, "from")) return;
  const std::size_t at = thing.end + (text.is_word(thing.end + 1, "the") ? 2 : 1);
  const auto side = brief::longest(text.edits.sides, text.tokens, at, 2);
  if (!side) return;
  thing.side = *side.value;
  thing.end = at + side.length;
}

// What the text spoke of last before a token: "one" is another of these.
KindMention spoken_of_before(const EditText& text, std::size_t at) {
  // "a table with drawers" speaks of a table.
  const auto is_said_of_other = [&](std::size_t i) {
    return i > 0 && (text.is_word(i - 1, "with") || text.is_word(i - 1, "of"));
  };
  for (std::size_t i = at; i-- > 0;)
    if (const KindMention mention = head_at(text, i); mention.length > 0 && !is_said_of_other(i)) return mention;
  const auto& known = !text.latest.empty() ? text.latest : text.recall.touched;
  const Object* object = known.empty() ? nullptr : text.object(known.front());
  if (!object) return {};
  const Kind* kind = text.kinds.by_name(object->category);
  return {kind, 0, false, object->category, NounBasis::name, ""};
}

// "the left one", "the ones by the door"
bool is_one(const EditText& text, std::size_t at, const NamedThing& thing) {
  if (text.is_word(at, "ones")) return !thing.bare;
  return text.is_word(at, "one") && !thing.bare && thing.which != Which::indefinite;
}

// "the two on the left": nothing but a number stands for the noun.
bool stands_for_noun(const EditText& text, std::size_t at, const NamedThing& thing) {
  const bool is_told = brief::longest(text.edits.side_tails, text.tokens, at) ||
                       longest_in(text.edits.nearest, text.tokens, at) > 0 ||
                       longest_in(text.edits.farthest, text.tokens, at) > 0;
  return !thing.bare && thing.count > 1 && thing.which == Which::definite && thing.looks.empty() && is_told;
}

bool ends_noun_phrase(const EditText& text, std::size_t at) {
  return text.ends(at) || text.words.stops.count(text.tokens[at].text) ||
         text.edits.verbs.count(text.tokens[at].text) || longest_in(text.edits.auxiliaries, text.tokens, at) > 0 ||
         longest_in(text.edits.closers, text.tokens, at) > 0;
}

// "the settee", which no kind is called.
KindMention noun_by_meaning(const EditText& text, std::size_t at) {
  if (at >= text.tokens.size() || !may_be_adjective(text, at) || !ends_noun_phrase(text, at + 1)) return {};
  const std::string noun = language::singular(text.tokens[at].text);
  const auto ids = things_by_meaning(text, noun);
  if (ids.empty()) return {};
  const Kind* kind = text.kinds.by_name(text.object(ids.front())->category);
  return {kind, kind ? 1u : 0u, noun != text.tokens[at].text, noun, NounBasis::name, ""};
}

bool read_head(const EditText& text, std::size_t at, NamedThing& thing) {
  thing.kind = head_at(text, at);
  if (thing.kind.length > 0) return true;
  // "beside the first"
  const bool is_other =
      thing.which == Which::definite && !thing.bare && thing.further && thing.looks.empty() && text.ends(at);
  if (is_other || is_one(text, at, thing) || stands_for_noun(text, at, thing)) {
    thing.kind = spoken_of_before(text, thing.begin);
    thing.kind.plural = !text.is_word(at, "one");
    thing.kind.length = text.is_word(at, "one") || text.is_word(at, "ones") ? 1 : 0;
    return thing.kind.category != nullptr;
  }
  if (thing.which == Which::indefinite || thing.bare) return false;
  thing.kind = noun_by_meaning(text, at);
  thing.by_meaning = thing.kind.length > 0;
  return thing.by_meaning;
}

std::optional<NamedThing> noun_phrase_at(const EditText& text, std::size_t at) {
  NamedThing thing;
  thing.begin = at;
  at = skip_determiners(text, at, thing);
  for (std::size_t n = 0; n <= most_adjectives && at <= text.tokens.size(); ++n) {
    if (read_head(text, at, thing)) {
      thing.plural = thing.kind.plural || thing.count > 1;
      thing.end = at + thing.kind.length;
      read_more_behind(text, thing);
      read_one_and_other(text, thing);
      read_number_of_id(text, thing);
      read_place_in_row(text, thing);
      read_counted_side(text, thing);
      if (thing.further && thing.which == Which::definite && !thing.bare && !(thing.nth && thing.side))
        thing.further = false;
      return thing;
    }
    const auto next = at < text.tokens.size() ? read_adjective(text, at, thing) : std::nullopt;
    if (!next) return std::nullopt;
    at = *next;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vec3> measured_size(const Kind& kind, const std::vector<language::Measure>& measures) {
  if (measures.empty()) return std::nullopt;
  brief::Mention like;
  like.size = kind.size;
  for (const auto& measure : measures) brief::set_length(like, measure);
  return like.size;
}

std::optional<Vec3> NamedThing::told_size() const {
  return kind.category ? measured_size(*kind.category, measures) : std::nullopt;
}

std::string NamedThing::description() const {
  std::vector<std::string> all = looks;
  all.push_back(kind.name);
  if (!tail.empty()) all.push_back(tail);
  return join(all, " ");
}

std::optional<NamedThing> named_thing_at(const EditText& text, std::size_t at) {
  if (at >= text.tokens.size()) return std::nullopt;
  auto named = noun_phrase_at(text, at);
  // "that chair", "all six chairs" are no pronouns.
  const auto pronoun = pronoun_at(text, at);
  return named || !pronoun ? named : pronoun;
}

}  // namespace roomgen
