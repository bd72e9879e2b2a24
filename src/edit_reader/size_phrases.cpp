#include "size_phrases.h"

#include <algorithm>
#include <cmath>

#include "language/inflection.h"
#include "language/measure.h"
#include "language/number.h"

namespace roomgen {

std::optional<double> length_at(const EditText& text, std::size_t& at) {
  const auto measure = language::bounded_measure_at(text.raw, at);
  if (!measure || measure->kind != language::Measure::Kind::length || !measure->has_unit) return std::nullopt;
  at += measure->length;
  return measure->values[0];
}

namespace {

constexpr double below_ceiling = 0.01;  // metres left above what reaches up to it

bool is_article(const EditText& text, std::size_t at) {
  return text.is_word(at, "a") || text.is_word(at, "an") ||
         (at < text.tokens.size() && text.words.definite.count(text.tokens[at].text) > 0);
}

// ---- Growth ------------------------------------------------------------------------------------

// "bigger", "much wider", "a bit more wide", "less tall"
std::optional<Read<Growth>> compared_at(const EditText& text, std::size_t at) {
  const auto degree = brief::longest(text.edits.degrees, text.tokens, at);
  const double power = degree ? *degree.value : 1.0;
  const std::size_t next = at + degree.length;
  if (const auto growth = brief::longest(text.edits.growth, text.tokens, next))
    return Read<Growth>{{growth.value->side, std::pow(growth.value->factor, power)}, next + growth.length};
  const bool is_less = text.is_word(next, "less");
  if ((!is_less && !text.is_word(next, "more")) || next + 1 >= text.tokens.size()) return std::nullopt;
  const auto growth = growth_of_adjective(text, text.tokens[next + 1].text);
  if (!growth) return std::nullopt;
  return Read<Growth>{{growth->side, std::pow(growth->factor, is_less ? -power : power)}, next + 2};
}

// "twice", "three times", "1.5 times"
std::optional<Read<double>> multiple_at(const EditText& text, std::size_t at) {
  if (const auto named = brief::longest(text.edits.multiples, text.tokens, at))
    return Read<double>{*named.value, at + named.length};
  const auto number = language::number_at(text.raw, at);
  if (!number || (!text.is_word(at + number->length, "times") && !text.is_word(at + number->length, "x")))
    return std::nullopt;
  return Read<double>{number->value, at + number->length + 1};
}

// "as it is now", behind "twice as wide"
std::size_t behind_now(const EditText& text, std::size_t at) {
  if (!text.is_word(at, "as")) return at;
  const auto now = std::max(longest_in(text.edits.where_they_are, text.tokens, at),
                            longest_in(text.edits.presently, text.tokens, at + 1) + 1);
  return now > 1 ? at + now + longest_in(text.edits.presently, text.tokens, at + now) : at;
}

// "twice as wide", "half the height", "three times wider"
std::optional<Read<Growth>> multiplied_at(const EditText& text, std::size_t at) {
  const auto multiple = multiple_at(text, at);
  if (!multiple || multiple->end >= text.tokens.size()) return std::nullopt;
  const std::size_t next = multiple->end;
  if (text.is_word(next, "as") && next + 1 < text.tokens.size()) {
    const auto growth = growth_of_adjective(text, text.tokens[next + 1].text);
    if (!growth) return std::nullopt;
    return Read<Growth>{
        {growth->side, growth->factor > 1.0 || multiple->value < 1.0 ? multiple->value : 1.0 / multiple->value},
        behind_now(text, next + 2)};
  }
  if (is_article(text, next))
    if (const auto side = brief::longest(text.edits.measured, text.tokens, next + 1))
      return Read<Growth>{{*side.value, multiple->value}, next + 1 + side.length};
  const auto growth = brief::longest(text.edits.growth, text.tokens, next);
  if (!growth || multiple->value <= 1.0) return std::nullopt;
  return Read<Growth>{{growth.value->side, growth.value->factor > 1.0 ? multiple->value : 1.0 / multiple->value},
                      next + growth.length};
}

// "20 %", "a quarter", "three quarters": a share of one.
std::optional<Read<double>> share_at(const EditText& text, std::size_t at) {
  if (const auto named = brief::longest(text.edits.shares, text.tokens, at))
    return Read<double>{*named.value, at + named.length};
  const auto number = language::number_at(text.raw, at);
  if (!number) return std::nullopt;
  const std::size_t end = at + number->length;
  for (const char* percent : {"%", "percent", "pct"})
    if (text.is_word(end, percent)) return Read<double>{number->value / 100.0, end + 1};
  return std::nullopt;
}

NewSize changed_by(const Growth& way, double share) {
  return {way.side, way.factor > 1.0 ? 1.0 + share : 1.0 - share, {}, {}};
}

NewSize longer_by(const Growth& way, double metres) {
  NewSize size{way.side == "all" ? "long" : way.side, 0.0, {}, {}};
  size.more = way.factor > 1.0 ? metres : -metres;
  return size;
}

NewSize exactly(const std::string& side, double metres) {
  NewSize size{side, 0.0, {}, {}};
  size.exact = metres;
  return size;
}

// ---- Sizes -------------------------------------------------------------------------------------

std::string side_of(language::Measure::Side side) {
  using Side = language::Measure::Side;
  switch (side) {
    case Side::width: case Side::diameter: return "width";
    case Side::depth: return "depth";
    case Side::height: return "height";
    case Side::length: return "long";
    default: return "";
  }
}

// "20 cm wider", "30 cm deep"
std::optional<Read<NewSize>> measured_size(const EditText& text, std::size_t at) {
  const auto measure = language::bounded_measure_at(text.raw, at);
  if (!measure || measure->kind != language::Measure::Kind::length || !measure->has_unit) return std::nullopt;
  const std::size_t end = at + measure->length;
  if (const auto growth = compared_at(text, end))
    return Read<NewSize>{longer_by(growth->value, measure->values[0]), growth->end};
  if (const std::string side = side_of(measure->side); !side.empty())
    return Read<NewSize>{exactly(side, measure->values[0]), end};
  const auto said = brief::longest(text.edits.measured, text.tokens, end, 2);
  if (!said || *said.value == "all") return std::nullopt;
  return Read<NewSize>{exactly(*said.value, measure->values[0]), end + said.length};
}

// "a height of 75 cm", "the same height 1.8 m"
std::optional<Read<NewSize>> named_size(const EditText& text, std::size_t at) {
  while (is_article(text, at) || text.is_word(at, "same") || text.is_word(at, "to")) ++at;
  const auto side = brief::longest(text.edits.measured, text.tokens, at, 1);
  if (!side || *side.value == "all") return std::nullopt;
  std::size_t end = at + side.length;
  while (text.is_word(end, "of") || text.is_word(end, "to") || (end < text.tokens.size() && text.is_mark(end))) ++end;
  const auto metres = length_at(text, end);
  if (!metres) return std::nullopt;
  return Read<NewSize>{exactly(*side.value, *metres), end};
}

// "20 % bigger", "three quarters of its length"
std::optional<Read<NewSize>> shared_size(const EditText& text, std::size_t at) {
  const auto share = share_at(text, at);
  if (!share) return std::nullopt;
  if (const auto growth = compared_at(text, share->end))
    return Read<NewSize>{changed_by(growth->value, share->value), growth->end};
  if (!text.is_word(share->end, "of")) return std::nullopt;
  const std::size_t next = share->end + (is_article(text, share->end + 1) ? 2 : 1);
  const auto side = brief::longest(text.edits.measured, text.tokens, next);
  if (!side) return std::nullopt;
  return Read<NewSize>{{*side.value, share->value, {}, {}}, next + side.length};
}

// "taller by 20 cm", "smaller by a quarter"
std::optional<Read<NewSize>> grown_by(const EditText& text, std::size_t at) {
  const auto growth = compared_at(text, at);
  if (!growth || !text.is_word(growth->end, "by")) return std::nullopt;
  std::size_t end = growth->end + 1;
  if (const auto metres = length_at(text, end)) return Read<NewSize>{longer_by(growth->value, *metres), end};
  const auto share = share_at(text, end);
  return share ? std::optional(Read<NewSize>{changed_by(growth->value, share->value), share->end}) : std::nullopt;
}

// "narrower, say 30 cm deep"
std::size_t behind_say(const EditText& text, std::size_t at) {
  at = text.behind_comma(at);
  return at + longest_in(text.edits.hedges, text.tokens, at);
}

// "wider, at least 90 cm"
std::optional<Read<NewSize>> grown_to(const EditText& text, std::size_t at) {
  const auto growth = compared_at(text, at);
  if (!growth) return std::nullopt;
  std::size_t end = behind_say(text, growth->end);
  if (const auto exact = measured_size(text, end); exact && exact->value.exact) return exact;
  const bool is_said = end > text.behind_comma(growth->end) || text.is_comma(growth->end);
  const auto metres = is_said ? length_at(text, end) : std::nullopt;
  if (!metres || growth->value.side == "all") return std::nullopt;
  return Read<NewSize>{exactly(growth->value.side, *metres), end};
}

// "as wide as the dresser", "as tall as the ceiling"
std::optional<Read<NewSize>> size_of_other(const EditText& text, std::size_t at) {
  if (const auto length = longest_in(text.edits.up_to_ceiling, text.tokens, at); length > 0)
    return Read<NewSize>{exactly("height", rooms_of(text.scene).front().height - below_ceiling), at + length};
  if (!text.is_word(at, "as")) return std::nullopt;
  const auto side = brief::longest(text.edits.measured, text.tokens, at + 1, 1);
  if (!side || !text.is_word(at + 2, "as")) return std::nullopt;
  const auto other = things_at(text, at + 3, false);
  if (!other || !*other || (*other)->value.size() != 1) return std::nullopt;
  const Object* object = find_object(text.scene, (*other)->value.front());
  if (!object) return std::nullopt;
  Vec3 theirs = object->size;
  return Read<NewSize>{exactly(*side.value, side_of_size(theirs, *side.value)), (*other)->end};
}

}  // namespace

std::optional<Growth> growth_of_adjective(const EditText& text, const std::string& adjective) {
  for (const auto& [word, growth] : text.edits.growth)
    if (const auto plain = language::positive(word); plain && *plain == adjective) return growth;
  return std::nullopt;
}

std::optional<Read<Growth>> growth_at(const EditText& text, std::size_t at) {
  if (auto multiplied = multiplied_at(text, at)) return multiplied;
  return compared_at(text, at);
}

MayRead<NewSize> size_at(const EditText& text, std::size_t at) {
  at += longest_in(text.edits.hedges, text.tokens, at);
  for (const auto& read : {size_of_other, shared_size, grown_by, measured_size, named_size, grown_to})
    if (const auto size = read(text, at)) return *size;
  const auto growth = growth_at(text, at);
  if (!growth) return std::nullopt;
  return Read<NewSize>{{growth->value.side, growth->value.factor, {}, {}}, growth->end};
}

namespace {

// "by a factor of 1.5", "by 1.5"
std::optional<Read<double>> factor_at(const EditText& text, std::size_t at) {
  if (text.is_word(at, "a") && text.is_word(at + 1, "factor") && text.is_word(at + 2, "of")) at += 3;
  const auto number = language::number_at(text.raw, at);
  if (!number || number->value <= 0.0 || !text.ends(at + number->length)) return std::nullopt;
  return Read<double>{number->value, at + number->length};
}

// "of its size", behind "to half"
std::size_t behind_of_its_size(const EditText& text, std::size_t at) {
  std::size_t end = at + (text.is_word(at, "of") ? 1 : 0);
  if (!is_article(text, end)) return at;
  const auto side = brief::longest(text.edits.measured, text.tokens, end + 1);
  return side ? end + 1 + side.length : at;
}

}  // namespace

MayRead<NewSize> size_behind_verb(const EditText& text, std::size_t at, const Growth& verb) {
  Growth way = verb;
  if (const auto vague = brief::longest(text.edits.degrees, text.tokens, at))
    way.factor = std::pow(way.factor, *vague.value), at += vague.length;
  at += longest_in(text.edits.emphasis, text.tokens, at);
  // "grow it till it is 2 m across"
  if (const auto till = longest_in(text.edits.hedges, text.tokens, at); till > 1)
    if (const auto size = measured_size(text, at + till)) return *size;
  const bool is_by = text.is_word(at, "by");
  if (!is_by && !text.is_word(at, "to")) return Read<NewSize>{{way.side, way.factor, {}, {}}, at};
  std::size_t end = at + 1;
  if (const auto metres = length_at(text, end)) {
    if (way.side == "all") return not_understood("it is not clear which side shall be so long");
    return Read<NewSize>{is_by ? longer_by(way, *metres) : exactly(way.side, *metres), end};
  }
  if (!is_by)
    if (const auto multiple = multiplied_at(text, end))
      return Read<NewSize>{{way.side, multiple->value.factor, {}, {}}, multiple->end};
  if (const auto share = share_at(text, end))
    return Read<NewSize>{is_by ? changed_by(way, share->value) : NewSize{way.side, share->value, {}, {}},
                         behind_of_its_size(text, share->end)};
  if (const auto factor = is_by ? factor_at(text, end) : std::nullopt)
    return Read<NewSize>{
        {way.side, way.factor < 1.0 && factor->value > 1.0 ? 1.0 / factor->value : factor->value, {}, {}}, factor->end};
  return std::nullopt;
}

std::optional<Read<SizedThings>> sized_things_at(const EditText& text, std::size_t at) {
  const bool is_own = text.is_word(at, "its") || text.is_word(at, "their");
  const std::size_t noun = at + (is_article(text, at) ? 1 : 0);
  const auto side = brief::longest(text.edits.measured, text.tokens, noun, 1);
  if (side && is_own && !text.latest.empty()) return Read<SizedThings>{{text.latest, *side.value}, noun + side.length};
  if (side && text.is_word(noun + side.length, "of")) {
    const auto owner = things_at(text, noun + side.length + 1, true);
    if (owner && *owner) return Read<SizedThings>{{(*owner)->value, *side.value}, (*owner)->end};
  }
  const auto owner = things_at(text, at, false);
  if (!owner || !*owner) return std::nullopt;
  const auto behind = brief::longest(text.edits.measured, text.tokens, (*owner)->end, 1);
  const std::size_t end = (*owner)->end + behind.length;
  if (!behind || (!text.is_word(end, "to") && !text.is_word(end, "by") && !language::measure_at(text.raw, end)))
    return std::nullopt;
  return Read<SizedThings>{{(*owner)->value, *behind.value}, end};
}

}  // namespace roomgen
