#include "plain_wording.h"

#include "language/inflection.h"
#include "roomgen/base/text.h"
#include "spoken_clause.h"
#include "word_order.h"

namespace roomgen {

namespace {

using Token = design::Token;

constexpr const char* subjects[] = {"it", "that", "there", "this", "what", "where", "he", "she", "here", "who", "everything"};

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
  return longest_in(text.edits.short_is_before, text.tokens, at + 1) > 0 || (form && form->form == language::VerbForm::gerund);
}

void write_out(EditText& text, std::size_t at) {
  if (text.tokens[at].kind != Token::Kind::word) return;
  const std::string clitic = text.raw[at].clitic;
  if (const auto slang = text.edits.contractions.find(text.tokens[at].text); slang != text.edits.contractions.end() && clitic.empty())
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

}  // namespace

void word_plainly(EditText& text) {
  for (std::size_t i = 0; i < text.tokens.size(); ++i) write_out(text, i);
  for (std::size_t i = 0; i < text.tokens.size(); ++i)
    if (const auto length = longest_in(text.edits.courtesies, text.tokens, i); length > 0 && is_mere_courtesy(text, i, length)) {
      cut(text, i, i + length);
      --i;
    }
}

}  // namespace roomgen
