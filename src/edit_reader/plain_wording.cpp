#include "language/inflection.h"
#include "roomgen/base/text.h"
#include "spoken_clause.h"
#include "wording.h"

namespace roomgen {

namespace {

using Token = brief::Token;

constexpr const char* subjects[] = {"it", "that", "there", "this", "what",      "where",
                                    "he", "she",  "here",  "who",  "everything"};

void replace_word(EditText& text, std::size_t at, const std::string& phrase) {
  const auto words = split(phrase, ' ');
  text.raw[at].text = text.tokens[at].text = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) insert_word(text, at + i, words[i]);
}

// "the sofa's blocking it", "it's dark", but "the crib's legs"
bool is_short_is(const EditText& text, std::size_t at) {
  for (const char* subject : subjects)
    if (text.is_word(at, subject)) return true;
  if (at + 1 >= text.tokens.size()) return false;
  const auto form = language::verb(text.tokens[at + 1].text);
  return longest_in(text.edits.short_is_before, text.tokens, at + 1) > 0 ||
         (form && form->form == language::VerbForm::gerund);
}

void write_out(EditText& text, std::size_t at) {
  if (text.tokens[at].kind != Token::Kind::word) return;
  const std::string clitic = text.raw[at].clitic;
  if (const auto slang = text.edits.contractions.find(text.tokens[at].text);
      slang != text.edits.contractions.end() && clitic.empty())
    return replace_word(text, at, slang->second);
  const auto known = text.edits.clitics.find(clitic);
  if (known != text.edits.clitics.end()) insert_word(text, at + 1, known->second);
  else if (clitic == "'s" && !text.is_word(at, "let") && is_short_is(text, at)) insert_word(text, at + 1, "is");
  else return;
  text.raw[at].clitic.clear();
}

// "please move it": there it begins what is asked for.
bool is_mere_courtesy(const EditText& text, std::size_t at, std::size_t length) {
  return at > 0 && !text.is_mark(at - 1) && !verb_at(text, at + length);
}

constexpr std::size_t least_clause = 3;  // words before a colon that are more than a name

// "rug: navy" is as good as "rug navy", but "we are hiring: add a desk" are two clauses.
void drop_colons(EditText& text) {
  std::size_t words = 0;
  for (std::size_t i = 0; i < text.tokens.size(); ++i) {
    const bool is_colon = text.raw[i].text == ":";
    words = text.is_mark(i) && !is_colon ? 0 : words + 1;
    if (!is_colon) continue;
    const bool parts_clauses = words > least_clause && verb_at(text, i + 1);
    if (!parts_clauses) {
      cut(text, i, i + 1);
      --i;
    }
    words = 0;
  }
}

// "the dining set" is the table with its chairs.
void reword(EditText& text, std::size_t at) {
  const auto known = brief::longest(text.edits.rewordings, text.tokens, at);
  if (!known) return;
  cut(text, at + 1, at + known.length);
  replace_word(text, at, *known.value);
}

}  // namespace

void word_plainly(EditText& text) {
  drop_colons(text);
  for (std::size_t i = 0; i < text.tokens.size(); ++i) reword(text, i);
  for (std::size_t i = 0; i < text.tokens.size(); ++i) write_out(text, i);
  for (std::size_t i = 0; i < text.tokens.size(); ++i)
    if (const auto length = longest_in(text.edits.courtesies, text.tokens, i);
        length > 0 && is_mere_courtesy(text, i, length)) {
      cut(text, i, i + length);
      --i;
    }
}

}  // namespace roomgen
