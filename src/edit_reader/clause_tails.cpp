#include <algorithm>

#include "clause.h"
#include "room_names.h"
#include "wording.h"

namespace roomgen {

namespace {

std::size_t next_mark(const EditText& text, std::size_t at) {
  while (!text.is_mark(at)) ++at;
  return at;
}

bool closes(const EditText& text, std::size_t at) {
  return text.ends(at) || longest_in(text.edits.closers, text.tokens, at) > 0;
}

// "now" ends a clause, but "now that" begins a reason.
std::size_t end_of_closer(const EditText& text, std::size_t at) {
  const auto closer = longest_in(text.edits.closers, text.tokens, at);
  const auto other =
      std::max(longest_in(text.edits.reasons, text.tokens, at), longest_in(text.edits.substitutes, text.tokens, at));
  return closer > 0 && closer >= other ? at + closer : at;
}

// "… because the kids break it": why, to the end of the sentence's part.
std::size_t end_of_reason(const EditText& text, std::size_t at) {
  return longest_in(text.edits.reasons, text.tokens, at) > 0 ? next_mark(text, at) : at;
}

// "not the desk", "rather than in the corner"
std::size_t end_of_contrast(const EditText& text, std::size_t at) {
  const std::size_t begin = text.behind_comma(at) + (text.is_word(text.behind_comma(at), "and") ? 1 : 0);
  const std::size_t length = text.is_word(begin, "not") ? 1 : longest_in(text.edits.substitutes, text.tokens, begin);
  if (length == 0) return at;
  const auto place = destination_at(text, begin + length, {});
  if (place && *place && closes(text, (*place)->end)) return (*place)->end;
  const auto thing = named_thing_at(text, begin + length);
  return thing && closes(text, thing->end) ? thing->end : at;
}

// "for my daughter", "for reading": for whom or what, where that is nothing of the room.
std::size_t end_of_purpose(const EditText& text, std::size_t at) {
  if (!text.is_word(at, "for")) return at;
  std::size_t end = at + 1;
  for (; !closes(text, end); ++end) {
    const auto thing = named_thing_at(text, end);
    const bool is_there = thing && thing->kind.category && thing->which != NamedThing::Which::indefinite &&
                          !fitting(text, *thing).empty();
    if (is_there || text.tokens[end].kind == brief::Token::Kind::number ||
        room_part_at(text, end) || rooms_named_at(text, end))
      return at;
    if (const auto place = destination_at(text, end, {}); place && *place) return at;
  }
  return end;
}

}  // namespace

std::size_t end_of_tail(const EditText& text, std::size_t at) {
  for (std::size_t before = at + 1; before != at;) {
    before = at;
    for (const auto& read : {end_of_closer, end_of_reason, end_of_contrast, end_of_purpose})
      if (at < text.tokens.size()) at = read(text, at);
  }
  return at;
}

}  // namespace roomgen
