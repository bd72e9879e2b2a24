#include <algorithm>

#include "clause.h"
#include "language/inflection.h"
#include "language/lexicon.h"
#include "spoken_clause.h"
#include "wording.h"

namespace roomgen {

namespace {

using Token = brief::Token;

// "we need", "I suggest", "please": what is asked for begins here.
bool is_wish(const EditText& text, std::size_t at) {
  const auto verb = verb_at(text, at);
  return (verb && verb->length > 1 && (text.is_word(at, "i") || text.is_word(at, "we"))) || text.is_word(at, "please");
}

// A mark, or a word with which what is asked for begins behind a reason.
std::size_t end_of_remark(const EditText& text, std::size_t at) {
  for (std::size_t i = at; i < text.tokens.size(); ++i)
    if (text.is_mark(i) || (i > at && ((text.is_word(i, "so") && !text.says_how_much(i)) ||
                                       text.is_word(i, "because") || is_wish(text, i))))
      return i;
  return text.tokens.size();
}

bool is_order(const EditText& text, std::size_t begin, std::size_t at) {
  const auto verb = verb_at(text, at);
  if (!verb || verb->inflected) return false;
  return at == begin || text.is_word(at - 1, "to") || text.is_word(at - 1, "and") || text.is_word(at - 1, "then");
}

// "more space", "some room"
bool wants_space(const EditText& text, std::size_t at) {
  while (at < text.tokens.size() && (text.edits.more.count(text.tokens[at].text) ||
                                     text.words.vague.count(text.tokens[at].text) || text.is_word(at, "enough")))
    ++at;
  return longest_in(text.edits.space, text.tokens, at) > 0;
}

bool asks_for_something(const EditText& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    // "we need the floor", "we need more space" bring nothing, and "I am not fond of it" takes nothing away.
    const auto verb = verb_at(text, i);
    if (text.is_word(i, "not") && i > begin && longest_in(text.edits.being, text.tokens, i - 1) == 1) continue;
    if (verb && verb->meaning == "add" && wants_space(text, i + verb->length)) {
      i += verb->length;
      continue;
    }
    const bool wants_nothing = verb && verb->meaning == "add" && verb->length > 1 &&
                               named_thing_at(text, i + verb->length) == std::nullopt &&
                               room_part_at(text, i + verb->length);
    if (wants_nothing) {
      i += verb->length - 1;
      continue;
    }
    if (longest_in(text.edits.requests, text.tokens, i) > 0 || longest_in(text.edits.modals, text.tokens, i) > 1 ||
        is_order(text, begin, i))
      return true;
  }
  return false;
}

// "my neighbours", "we", "granny"
bool begins_with_somebody(const EditText& text, std::size_t begin, std::size_t end) {
  if (longest_in(text.edits.explanations, text.tokens, begin) > 0) return true;
  for (std::size_t i = begin; i < std::min(end, begin + longest_somebody); ++i) {
    const std::string word = language::singular(text.tokens[i].text);
    if (language::lexicon().is(word, language::WordClass::person)) return true;
    if (named_thing_at(text, i) || longest_in(text.edits.auxiliaries, text.tokens, i) > 0) return false;
  }
  return false;
}

// "I don't use it in winter anyway": nothing is named that could change.
bool is_mere_talk(const EditText& text, std::size_t begin, std::size_t end) {
  if (verb_at(text, begin) || !begins_with_somebody(text, begin, end)) return false;
  for (std::size_t i = begin; i < end; ++i) {
    const auto thing = named_thing_at(text, i);
    const bool is_named =
        thing && thing->which != NamedThing::Which::pronoun && thing->kind.category && !fitting(text, *thing).empty();
    const auto verb = verb_at(text, i);
    if (is_named || (verb && (is_order(text, begin, i) || verb->length > 1)) || room_part_at(text, i) ||
        text.tokens[i].kind == Token::Kind::number || longest_in(text.edits.modals, text.tokens, i) > 1)
      return false;
  }
  return !text.is_word(begin, "it") && !text.is_word(begin, "they") && !text.is_word(begin, "that") &&
         !text.is_word(begin, "you");
}

// "not the stove", behind what was asked for
bool is_contrast(const EditText& text, std::size_t begin, std::size_t end) {
  if (!text.is_word(begin, "not")) return false;
  const auto thing = named_thing_at(text, begin + 1);
  return thing && thing->end == end;
}

// "I need to tell the test subject's seat from the rest": no verb of editing.
bool is_other_need(const EditText& text, std::size_t begin) {
  for (std::size_t i = begin; i + 2 < std::min(begin + longest_somebody, text.tokens.size()); ++i)
    if (longest_in(text.edits.wishes, text.tokens, i) == 1 && text.is_word(i + 1, "to") && !verb_at(text, i + 2) &&
        language::verb(text.tokens[i + 2].text) && !text.is_word(i + 2, "be") && !text.is_word(i + 2, "have"))
      return true;
  const auto verb = verb_at(text, begin);
  if (!verb || verb->length < 2 || !text.is_word(begin + verb->length, "to")) return false;
  const std::size_t at = begin + verb->length + 1;
  return at < text.tokens.size() && !verb_at(text, at) && language::verb(text.tokens[at].text) &&
         !text.is_word(at, "be") && !text.is_word(at, "have");
}

// "is", "looks", "bores"
bool is_told(const std::string& word) {
  const auto verb = language::verb(word);
  return verb && verb->form != language::VerbForm::gerund && verb->form != language::VerbForm::base;
}

// "this table is ridiculous": the thing does something, or is somehow, and nobody wants anything.
bool tells_of_thing(const EditText& text, std::size_t begin, std::size_t end) {
  const auto thing = named_thing_at(text, begin);
  if (!thing || thing->which == NamedThing::Which::indefinite || thing->end >= end) return false;
  // "the lamp we bought is too tall"
  std::size_t at = thing->end;
  if (longest_in(text.edits.explanations, text.tokens, at) > 0)
    while (at + 1 < end && !is_told(text.tokens[at].text)) ++at;
  return is_told(text.tokens[at].text);
}

// ---- Statements --------------------------------------------------------------------------------

// "blocks", "was"; "land" behind "keys", "sleep" behind "we"
bool is_finite_at(const EditText& text, std::size_t begin, std::size_t i) {
  const auto verb = language::verb(text.tokens[i].text);
  if (!verb || i == begin) return false;
  if (is_told(text.tokens[i].text)) return true;
  if (verb->form != language::VerbForm::base) return false;
  std::size_t subject = i - 1;
  while (subject > begin && text.edits.told_how.count(text.tokens[subject].text) > 0) --subject;
  const std::string& word = text.tokens[subject].text;
  return text.edits.tellers.count(word) > 0 || language::singular(word) != word;
}

// What is to be done may be told as well: "the plant goes by the window", "the rug stays".
bool tells_of_deed(const EditText& text, std::size_t i) {
  const auto verb = verb_at(text, i);
  return (verb && (verb->inflected || verb->length > 1)) || longest_in(text.edits.stays, text.tokens, i) > 0 ||
         longest_in(text.edits.goes_away, text.tokens, i) > 0 || text.edits.told_deeds.count(text.tokens[i].text) > 0;
}

bool asks_within(const EditText& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const bool is_denied = i > begin && text.edits.negations.count(text.tokens[i].text) > 0;
    if (!is_denied && longest_in(text.edits.requests, text.tokens, i) > 0) return true;
    if (longest_in(text.edits.modals, text.tokens, i) > 1 || is_order(text, begin, i) || tells_of_deed(text, i)) return true;
  }
  return longest_in(text.edits.questions, text.tokens, begin) > 0;
}

// "keys never land in it", "the queue blocks everything": somebody or something does something, or is somehow, and
// nothing of it asks for a change. Of what is in the room more may be meant: complaints are read elsewhere.
bool is_statement(const EditText& text, std::size_t begin, std::size_t end) {
  const auto subject = named_thing_at(text, begin);
  const bool is_of_room = subject && subject->which != NamedThing::Which::pronoun && subject->kind.category &&
                          !fitting(text, *subject).empty();
  if (is_of_room || verb_at(text, begin) || asks_within(text, begin, end)) return false;
  for (std::size_t i = begin; i < end; ++i)
    if (is_finite_at(text, begin, i)) return true;
  return false;
}

// Of a sentence that begins with it; a statement may go on behind a comma.
std::size_t end_of_statement(const EditText& text, std::size_t at) {
  if (at > 0 && text.tokens[at - 1].kind != Token::Kind::stop) return at;
  for (std::size_t end = at + 1; end <= text.tokens.size(); ++end) {
    const bool is_last = end == text.tokens.size();
    if (!is_last && !text.is_mark(end) && !(text.is_word(end, "so") && !text.says_how_much(end))) continue;
    const bool is_whole = is_last || text.is_word(end, "so") || text.tokens[end].kind == Token::Kind::stop;
    const bool goes_over = is_whole || is_order(text, end + 1, end + 1) || text.is_word(end + 1, "so") || is_wish(text, end + 1);
    if (goes_over && is_statement(text, at, end)) return end;
    if (is_whole) break;
  }
  return at;
}

bool names_nothing(const EditText& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i)
    if (named_thing_at(text, i) || room_part_at(text, i) || verb_at(text, i) || looks_at(text, i, true) ||
        text.tokens[i].kind == Token::Kind::number)
      return false;
  return true;
}

}  // namespace

std::size_t end_of_remark(const EditText& text, std::size_t at, bool at_first) {
  const std::size_t end = end_of_remark(text, at);
  if (end == at) return at;
  if (is_mere_talk(text, at, end) || is_other_need(text, at) || (!at_first && is_contrast(text, at, end))) return end;
  if (const std::size_t statement = end_of_statement(text, at); statement > at) return statement;
  if (asks_for_something(text, at, end)) return at;
  const bool is_remark = begins_with_somebody(text, at, end) || tells_of_thing(text, at, end) ||
                         (at_first && names_nothing(text, at, end));
  return is_remark ? end : at;
}

}  // namespace roomgen
