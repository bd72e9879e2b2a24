#include "candidates.h"

#include "lexicon.h"
#include "small_words.h"

namespace roomgen::language {

namespace {

bool is_small_word(const std::string& word) {
  const auto& all = small_words();
  return all.determiners.count(word) || all.pronouns.count(word) || all.relatives.count(word) ||
         all.conjunctions.count(word) || all.subordinators.count(word) ||
         all.negations.count(word) || all.be.count(word) || all.auxiliaries.count(word) ||
         all.prepositions.count(word) || all.numbers.count(word) || all.adverbs.count(word);
}

// A word that no list knows is taken by its ending.
void guess(const std::string& word, Candidates& result) {
  if (word.size() > 5 && word.ends_with("ing")) result.verb = Verb{word, VerbForm::gerund};
  if (word.size() > 4 && word.ends_with("ed")) result.verb = Verb{word, VerbForm::past};
  result.is_adjective = word.ends_with("less") || word.ends_with("ish") || word.ends_with("esque");
  result.is_noun = !result.verb;
}

}  // namespace

Candidates candidates(const Token& token) {
  Candidates result;
  if (token.kind == Token::Kind::ordinal) {
    result.is_adjective = result.is_content = true;
    return result;
  }
  if (token.kind != Token::Kind::word) return result;
  const std::string& word = token.text;
  result.is_small = is_small_word(word);
  result.is_content = !result.is_small;
  if (result.is_small) return result;
  const Lexicon& english = lexicon();
  const std::string one = singular(word);
  result.is_noun = english.has(one, PartOfSpeech::noun);
  result.is_plural = one != word || small_words().plurals.count(word);
  result.noun_uses = english.tagged(one, PartOfSpeech::noun);
  if (one != word) result.noun_uses += english.tagged(word, PartOfSpeech::noun);
  result.verb = verb(word);
  if (result.verb) result.verb_uses = english.tagged(result.verb->base, PartOfSpeech::verb);
  result.is_adjective = english.has(word, PartOfSpeech::adjective) || positive(word).has_value();
  result.adjective_uses = english.tagged(positive(word).value_or(word), PartOfSpeech::adjective);
  result.is_adverb = english.has(word, PartOfSpeech::adverb);
  if (!result.is_noun && !result.verb && !result.is_adjective && !result.is_adverb)
    guess(word, result);
  return result;
}

}  // namespace roomgen::language
