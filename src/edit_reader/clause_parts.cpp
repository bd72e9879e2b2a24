#include "clause_parts.h"

#include <algorithm>

#include "create/finish_look.h"
#include "language/inflection.h"
#include "room_names.h"
#include "roomgen/base/text.h"
#include "scene/finish_words.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;

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

// "the smaller of the coffee table and the dining table": one of those that are listed.
MayRead<Ids> one_of_list(const EditText& text, std::size_t at) {
  while (at < text.tokens.size() && text.words.definite.count(text.tokens[at].text)) ++at;
  if (at >= text.tokens.size() || !text.is_word(at + 1, "of")) return std::nullopt;
  const auto size = text.edits.sizes.find(text.tokens[at].text);
  const auto first = size == text.edits.sizes.end() ? std::nullopt : named_thing_at(text, at + 2);
  if (!first) return std::nullopt;
  const auto all = things_at(text, at + 2, false);
  if (!all || !*all || (*all)->value.size() < 2 || (*all)->end <= first->end) return std::nullopt;
  NamedThing one;
  one.which = Which::everything;
  one.size = size->second;
  one.begin = at, one.end = (*all)->end;
  const auto ids = meant(text, one, &(*all)->value);
  if (!ids) return ids.error();
  return Read<Ids>{*ids, (*all)->end};
}

MayRead<Ids> one_reference_at(const EditText& text, std::size_t at, bool with_places) {
  if (auto one = one_of_list(text, at)) return one;
  const auto thing = named_thing_at(text, at);
  if (!thing) return std::nullopt;
  if (thing->which == Which::indefinite && thing->further) return std::nullopt;
  if (with_places)
    if (auto told = told_by_tail(text, *thing)) return *told ? all_but(text, **told) : MayRead<Ids>(told->error());
  const auto ids = meant(text, *thing);
  if (!ids) return ids.error();
  return all_but(text, {*ids, thing->end});
}

bool begins_clause(const EditText& text, std::size_t at) {
  return longest(text.edits.verbs, text.tokens, at).length > 0;
}

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

// "darker" is a darker shade of what is there: "dark".
std::string plain_look(const std::string& word, bool of_room) {
  const auto positive = describes(word, of_room) ? std::nullopt : language::positive(word);
  return positive && describes(*positive, of_room) ? *positive : word;
}

// No verb of editing, and nothing that stands for a thing.
bool may_be_of_look(const EditText& text, std::size_t at, std::size_t begin, bool of_room) {
  const auto& token = text.tokens[at];
  if (is_filler(text, at)) return true;
  if (text.words.stops.count(token.text) || token.is_word("one") || token.is_word("ones") || token.is_word("same"))
    return false;
  if (describes(token.text, of_room) || token.kind != EditText::Token::Kind::word) return true;
  const auto deed = language::verb(token.text);
  return at > begin ? !(deed && deed->form == language::VerbForm::past) : text.edits.verbs.count(token.text) == 0;
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
    // "remove the rug, it is ugly": no second thing.
    if (text.is_comma(next - 1) && longest_in(text.edits.pronouns, text.tokens, next) > 0) break;
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
  while ((!text.ends(end) || goes_on_with_look(text, end, of_room)) &&
         longest_in(text.edits.except, text.tokens, end) == 0 && !in_room_at(text, end))
    ++end;
  while (end > at && longest_in(text.edits.closers, text.tokens, end - 1) == 1) --end;
  if (end == at) return std::nullopt;
  // "stand at its head", "try a slimmer one in oak" are no looks, whatever else stands there.
  for (std::size_t i = at; i < end; ++i)
    if (!may_be_of_look(text, i, at, of_room)) return std::nullopt;
  std::string words;
  for (std::size_t i = at; i < end; ++i)
    if (text.tokens[i].kind == EditText::Token::Kind::word)
      words += (words.empty() ? "" : " ") + plain_look(text.tokens[i].text, of_room);
  if (!describes(words, of_room)) return std::nullopt;
  return Read<std::string>{words, end};
}

namespace {

constexpr std::size_t most_adjectives = 5;

// "a light blue one", "taller ones with backs", "a three-seater in mustard", "something in brown leather": of the same kind.
std::optional<Read<Substitute>> another_of_kind(const EditText& text, std::size_t at) {
  std::size_t end = at + (text.is_word(at, "a") || text.is_word(at, "an") ? 1 : 0);
  std::vector<language::Measure> measures;
  while (const auto measure = measure_of_thing(text, end)) measures.push_back(*measure), end += measure->length;
  const std::size_t begin = end;
  const bool is_vague = longest_in(text.edits.something, text.tokens, begin) > 0;
  while (!is_vague && !text.ends(end) && !text.is_word(end, "one") && !text.is_word(end, "ones") &&
         !text.is_word(end, "seater") && !text.words.stops.count(text.tokens[end].text))
    ++end;
  const bool is_seater = text.is_word(end, "seater");
  if (end >= text.tokens.size() || end - begin > most_adjectives ||
      (!is_vague && !is_seater && !text.is_word(end, "one") && !text.is_word(end, "ones")))
    return std::nullopt;
  const auto behind = description_behind(text, end + 1);
  std::size_t last = behind.end;
  // "something softer"
  if (is_vague && last == end + 1)
    while (!text.ends(last) && !text.words.stops.count(text.tokens[last].text)) ++last;
  std::string description = text.words_from(begin, is_seater ? end + 1 : is_vague ? begin : end);
  const std::string tail = text.words_from(end + 1, last);
  if (!tail.empty()) description += (description.empty() ? "" : " ") + tail;
  if (description.empty() && measures.empty()) return std::nullopt;
  return Read<Substitute>{{"", description, std::move(measures)}, last};
}

}  // namespace

MayRead<Substitute> substitute_at(const EditText& text, std::size_t at) {
  if (const auto same = another_of_kind(text, at)) return *same;
  const auto thing = new_thing_at(text, at);
  if (thing)
    return Read<Substitute>{{thing->kind.category->name, thing->description(), thing->measures}, thing->end};
  const auto bare = named_thing_at(text, at);
  if (!bare || !bare->bare || bare->which == Which::pronoun || !bare->kind.category) return std::nullopt;
  return Read<Substitute>{{bare->kind.category->name, bare->description()}, bare->end};
}

}  // namespace roomgen
