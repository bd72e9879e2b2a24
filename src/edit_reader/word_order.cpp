#include <algorithm>

#include "clause.h"
#include "clause_parts.h"
#include "wording.h"

namespace roomgen {

namespace {

template <typename List>
void rotate_words(List& list, std::size_t first, std::size_t middle, std::size_t last) {
  const auto at = [&](std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
  std::rotate(at(first), at(middle), at(last));
}

EditText rotated_words(EditText text, std::size_t first, std::size_t middle, std::size_t last) {
  rotate_words(text.raw, first, middle, last);
  rotate_words(text.tokens, first, middle, last);
  return text;
}

// "on each table", "in the corner next to the window"
std::size_t end_of_place(const EditText& text, std::size_t at) {
  for (const bool is_small : {true, false})
    if (const auto shared = shared_places_at(text, at, is_small); shared && *shared) return (*shared)->end;
  const auto place = destination_at(text, at, {});
  return place && *place ? (*place)->end : at;
}

}  // namespace

void cut(EditText& text, std::size_t begin, std::size_t end) {
  const auto cut_from = [&](auto& list) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(begin), list.begin() + static_cast<std::ptrdiff_t>(end));
  };
  cut_from(text.raw);
  cut_from(text.tokens);
}

EditText without(const EditText& text, std::size_t begin, std::size_t end) {
  EditText shorter = text;
  cut(shorter, begin, end);
  return shorter;
}

void insert_word(EditText& text, std::size_t at, const std::string& word) {
  const auto offset = static_cast<std::ptrdiff_t>(at);
  language::Token raw;
  raw.text = word;
  if (at > 0) raw.span = text.raw[at - 1].span;
  text.raw.insert(text.raw.begin() + offset, raw);
  text.tokens.insert(text.tokens.begin() + offset,
                     brief::Token{brief::Token::Kind::word, word, 0.0, {}});
}

std::optional<EditText> with_place_last(const EditText& text, std::size_t at) {
  const std::size_t place = end_of_place(text, at);
  if (place == at) return std::nullopt;
  const std::size_t begin = text.behind_comma(place);
  std::size_t end = begin;
  while (!text.is_mark(end)) ++end;
  if (end == begin) return std::nullopt;
  EditText turned = rotated_words(text, at, begin, end);
  if (begin == place) return turned;
  // The comma behind the place is now before a mark, or the last word of all.
  cut(turned, end - 1, end);
  return turned;
}

std::optional<EditText> with_way_last(const EditText& text, std::size_t at) {
  const auto way = shifting_at(text, at, {});
  if (!way || !*way || (!text.is_word((*way)->end, "with") && !text.is_word((*way)->end, "for"))) return std::nullopt;
  const auto what = things_at(text, (*way)->end + 1, true);
  if (!what || !*what) return std::nullopt;
  return rotated_words(without(text, (*way)->end, (*way)->end + 1), at, (*way)->end, (*what)->end - 1);
}

std::optional<EditText> with_flanks(const EditText& text, std::size_t at) {
  const auto target = target_at(text, at, {});
  if (!target || !*target || !text.is_word((*target)->end, "with")) return std::nullopt;
  const std::size_t with = (*target)->end;
  const auto wanted = new_things_at(text, with + 1);
  if (wanted.empty()) return std::nullopt;
  const std::size_t end = wanted.back().end - 1, behind_things = at + end - with;
  EditText turned = rotated_words(without(text, with, with + 1), at, with, end);
  std::size_t next = behind_things;
  for (const char* word : {"on", "either", "side", "of"}) insert_word(turned, next++, word);
  return turned;
}

}  // namespace roomgen
