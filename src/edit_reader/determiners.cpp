#include <cmath>

#include "destinations.h"
#include "language/number.h"
#include "references.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;

bool is_new(const std::string& word) { return word == "a" || word == "an" || word == "another"; }

// "the one by the door": the noun is that of what was spoken of.
bool is_anaphor(const EditText& text, std::size_t at, const NamedThing& thing) {
  return !thing.bare && thing.which != Which::indefinite && !text.is_word(at + 1, "of");
}

// "half of the chairs", "half the chairs"
Read<double> share_of_things(const EditText& text, std::size_t at) {
  const auto share = brief::longest(text.edits.shares, text.tokens, at);
  if (!share) return {0.0, at};
  const std::size_t end = at + share.length + (text.is_word(at + share.length, "of") ? 1 : 0);
  const bool is_of_things = end < text.tokens.size() && text.words.definite.count(text.tokens[end].text) &&
                            !brief::longest(text.edits.measured, text.tokens, end + 1);
  return is_of_things ? Read<double>{*share.value, end} : Read<double>{0.0, at};
}

}  // namespace

std::optional<language::Measure> measure_of_thing(const EditText& text, std::size_t at) {
  const auto measure = language::measure_at(text.raw, at);
  const bool is_of_thing = measure && measure->has_unit && measure->kind != language::Measure::Kind::area &&
                           measure->side != language::Measure::Side::distance;
  return is_of_thing ? measure : std::nullopt;
}

// "all six of the", "the two", "another", "two more": up to the adjectives.
std::size_t skip_determiners(const EditText& text, std::size_t at, NamedThing& thing) {
  thing.bare = true;
  at += longest_in(text.edits.properties, text.tokens, at);
  for (bool more = true; more && at < text.tokens.size();) {
    more = false;
    const auto& token = text.tokens[at];
    if (measure_of_thing(text, at)) break;
    if (const auto share = share_of_things(text, at); share.end > at) {
      thing.share = share.value;
      thing.any = true;
      at = share.end, more = true;
    } else if (const auto counted = brief::longest(text.edits.counts, text.tokens, at)) {
      thing.count = static_cast<int>(*counted.value);
      if (thing.bare) thing.which = Which::indefinite;
      at += counted.length, more = true;
    } else if (const auto length = longest_in(text.edits.all, text.tokens, at)) {
      thing.which = Which::all;
      if (token.is_word("both")) thing.count = 2;
      at += length, more = true;
    } else if (token.kind == EditText::Token::Kind::word && is_new(token.text)) {
      thing.which = Which::indefinite;
      thing.further = thing.further || token.is_word("another");
      thing.count = 1;
      at += 1, more = true;
    } else if (text.words.definite.count(token.text) && token.kind == EditText::Token::Kind::word) {
      if (thing.which != Which::all) thing.which = Which::definite;
      at += 1, more = true;
    } else if (token.kind == EditText::Token::Kind::word && text.words.vague.count(token.text)) {
      thing.which = Which::indefinite;
      const auto few = text.words.numbers.find(token.text);
      thing.count = few == text.words.numbers.end() ? 0 : few->second;
      at += 1, more = true;
    } else if (const auto number = language::number_at(text.raw, at);
               number && !(token.is_word("one") && is_anaphor(text, at, thing)) && number->value >= 1 &&
               number->value <= 50 && number->value == std::floor(number->value)) {
      thing.count = static_cast<int>(number->value);
      if (thing.bare) thing.which = Which::indefinite;
      at += number->length, more = true;
      // "one of the armchairs"
      thing.any = text.is_word(at, "of") && at + 1 < text.tokens.size() &&
                  (text.words.definite.count(text.tokens[at + 1].text) ||
                   longest_in(text.edits.pronouns, text.tokens, at + 1) > 0);
      if (thing.any) ++at;
    }
    if (more) thing.bare = false;
  }
  return at;
}

}  // namespace roomgen
