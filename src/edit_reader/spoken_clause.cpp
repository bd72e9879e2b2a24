#include "spoken_clause.h"

#include <algorithm>

#include "language/inflection.h"
#include "language/lexicon.h"
#include "wording.h"

namespace roomgen {

namespace {

using Token = brief::Token;

constexpr std::size_t longest_verb = 7;  // tokens

}  // namespace

std::vector<std::size_t> ends_of_subject(const EditText& text, std::size_t at) {
  std::vector<std::size_t> ends;
  if (const auto opening = target_at(text, at, {}); opening && *opening && !find_object(text.scene, (*opening)->id))
    ends.push_back((*opening)->end);
  if (const auto room = longest_in(text.edits.whole_room, text.tokens, at)) ends.push_back(at + room);
  if (const auto part = room_part_at(text, at)) ends.push_back(part->end);
  if (const auto thing = named_thing_at(text, at)) ends.push_back(thing->end);
  for (const bool with_places : {false, true})
    if (const auto all = things_at(text, at, with_places); all && *all) ends.push_back((*all)->end);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

namespace {

// "the desk needs to be moved" is moved, but "the desk needs a lamp" is given one.
std::size_t begin_of_verb(const EditText& text, std::size_t subject) {
  for (std::size_t at = subject;;) {
    if (const auto verb = verb_at(text, at);
        verb && (verb->meaning == "give" || verb->meaning == "want") && !text.is_word(at + verb->length, "to"))
      return at;
    const auto length = longest_in(text.edits.auxiliaries, text.tokens, at);
    if (length == 0) return at;
    at += text.tokens[at].text == "should" || text.tokens[at].text == "must" ? 1 : length;
  }
}

// "could the bed and the desk trade places"
bool follows_question(const EditText& text, std::size_t at) {
  return at > 0 && text.edits.questions.count(text.tokens[at - 1].text) > 0;
}

// "desk: move it", "desk move left"
bool is_heading(const EditText& text, std::size_t at, std::size_t end) {
  const auto thing = named_thing_at(text, at);
  return thing && thing->bare && thing->end == end && thing->kind.category && !fitting(text, *thing).empty();
}

}  // namespace

std::optional<SaidVerb> verb_at(const EditText& text, std::size_t at) {
  if (at >= text.tokens.size() || text.tokens[at].kind != Token::Kind::word) return std::nullopt;
  if (const auto said = longest(text.edits.verbs, text.tokens, at, longest_verb))
    return SaidVerb{*said.value, text.words_from(at, at + said.length), said.length, false};
  const auto form = language::verb(text.tokens[at].text);
  if (!form || form->base == text.tokens[at].text) return std::nullopt;
  std::vector<Token> tokens(
      text.tokens.begin() + static_cast<std::ptrdiff_t>(at),
      text.tokens.begin() + static_cast<std::ptrdiff_t>(std::min(at + longest_verb, text.tokens.size())));
  tokens.front().text = form->base;
  const auto said = longest(text.edits.verbs, std::span<const Token>(tokens), 0);
  if (!said) return std::nullopt;
  return SaidVerb{*said.value, form->base, said.length, true};
}

std::optional<ReadClause> clause_with_subject(const EditText& text, std::size_t at, const ReadOrder& read) {
  std::optional<ReadClause> failed;
  for (const std::size_t subject : ends_of_subject(text, at)) {
    const std::size_t begin = begin_of_verb(text, subject);
    const auto verb = verb_at(text, begin);
    if (!verb) continue;
    std::size_t end = begin + verb->length;
    // "the hamper: lose it"
    const bool takes_it_up = end < text.tokens.size() && longest_in(text.edits.pronouns, text.tokens, end) == 1;
    if (begin == subject && takes_it_up) ++end;
    else if (begin == subject && !verb->inflected && verb->meaning != "give" && verb->meaning != "want" &&
             !brings_something(text, at) && !is_heading(text, at, subject) && !follows_question(text, at))
      continue;
    auto clause = read(without(text, subject, end), *verb, at);
    if (clause) clause->end += end - subject;
    if (goes_to_its_end(text, clause)) return clause;
    failed = std::move(clause);
  }
  return failed;
}

std::size_t wish_of_somebody(const EditText& text, std::size_t at) {
  bool is_somebody = false;
  for (std::size_t i = at; i < std::min(at + longest_somebody, text.tokens.size()); ++i) {
    if (is_somebody)
      if (const auto wish = longest_in(text.edits.wishes, text.tokens, i)) return i + wish - at;
    is_somebody = is_somebody ||
                  language::lexicon().is(language::singular(text.tokens[i].text), language::WordClass::person) ||
                  text.is_word(i, "he") || text.is_word(i, "she") || text.is_word(i, "they");
  }
  return 0;
}

}  // namespace roomgen
