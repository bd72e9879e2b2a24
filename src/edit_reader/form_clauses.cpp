#include "clause.h"
#include "create/part_forms.h"
#include "language/inflection.h"

namespace roomgen {

namespace {

bool is_part(const std::string& word) {
  const auto& parts = create::built_in_parts();
  return parts && (parts->labels.count(word) || parts->labels.count(language::singular(word)));
}

// "a little taller, maybe 10 cm": the words of the form itself.
std::string how_at(const EditText& text, std::size_t at, std::size_t& end) {
  std::string how;
  end = at;
  for (; !text.ends(end) && longest_in(text.edits.closers, text.tokens, end) == 0; ++end) {
    if (longest_in(text.edits.auxiliaries, text.tokens, end) > 0 && how.empty()) continue;
    // "the board blocks everything" is a deed.
    if (text.words.stops.count(text.tokens[end].text) || longest_in(text.edits.everything, text.tokens, end) > 0)
      return "";
    how += (how.empty() ? "" : " ") + text.tokens[end].text;
  }
  return how;
}

ReadClause reformed(const EditText& text, const Ids& ids, const std::string& part, std::size_t at) {
  std::size_t end = at;
  const std::string how = how_at(text, at, end);
  if (how.empty()) return what_at(text, at, "it is not clear how its form shall be");
  return of_each({ids, end}, end, [&](const std::string& id) { return edit::Reform{id, "with " + how + " " + part}; });
}

}  // namespace

std::optional<Read<std::string>> parts_at(const EditText& text, std::size_t at) {
  std::string words;
  // A cushion is a thing of its own as well; "a thicker cushion" is that which is there.
  bool is_thing = false, is_compared = false;
  for (std::size_t end = at; end < text.tokens.size(); ++end) {
    const auto& token = text.tokens[end];
    if (token.kind != brief::Token::Kind::word && token.kind != brief::Token::Kind::number)
      return std::nullopt;
    words += (words.empty() ? "" : " ") + token.text;
    is_compared = is_compared || language::positive(token.text).value_or(token.text) != token.text;
    const bool is_last_of_all = text.ends(end + 1) && !text.is_word(end + 1, "and");
    if (!text.ends(end + 1)) continue;
    if (!is_part(token.text)) return std::nullopt;
    is_thing = is_thing || text.kinds.named(language::singular(token.text));
    if (!is_last_of_all) continue;
    return is_thing && !is_compared ? std::nullopt : std::optional(Read<std::string>{words, end + 1});
  }
  return std::nullopt;
}

std::optional<ReadClause> read_form(const EditText& text, std::size_t at) {
  // "the legs of the crib shorter"
  std::size_t part = at;
  while (part < text.tokens.size() &&
         (text.words.definite.count(text.tokens[part].text) || text.edits.all.count(text.tokens[part].text)))
    ++part;
  if (part + 1 < text.tokens.size() && is_part(text.tokens[part].text) && text.is_word(part + 1, "of")) {
    const auto owner = things_at(text, part + 2, false);
    if (owner && *owner) return reformed(text, (*owner)->value, text.tokens[part].text, (*owner)->end);
  }
  // "the crib's legs shorter", "its top square"
  const auto owner = things_at(text, at, false);
  Ids ids;
  std::size_t next = at;
  if (owner && *owner) ids = (*owner)->value, next = (*owner)->end;
  else if ((text.is_word(at, "its") || text.is_word(at, "their")) && !text.latest.empty())
    ids = text.latest, next = at + 1;
  if (ids.empty() || next >= text.tokens.size() || !is_part(text.tokens[next].text) || text.ends(next + 1))
    return std::nullopt;
  return reformed(text, ids, text.tokens[next].text, next + 1);
}

}  // namespace roomgen
