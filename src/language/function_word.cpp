#include "function_word.h"

#include "small_words.h"

namespace roomgen::language {

namespace {

// Of phrases ("in front of") each word.
Words closed_classes() {
  const SmallWords& small = small_words();
  Words all;
  for (const auto& [word, determiner] : small.determiners)
    if (determiner != Determiner::no) all.insert(word);
  for (const auto& [clitic, word] : small.contractions) all.insert(word);
  for (const auto* words : {&small.pronouns, &small.standing_alone, &small.relatives,
                            &small.conjunctions, &small.subordinators, &small.be, &small.auxiliaries,
                            &small.prepositions, &small.adverbs})
    for (const auto& phrase : *words)
      for (std::size_t begin = 0; begin < phrase.size();) {
        const std::size_t end = std::min(phrase.find(' ', begin), phrase.size());
        all.insert(phrase.substr(begin, end - begin));
        begin = end + 1;
      }
  for (const auto* words : {&small.negative_pronouns, &small.negations})
    for (const auto& word : *words) all.erase(word);
  return all;
}

}  // namespace

bool is_function_word(const Token& token) {
  static const Words words = closed_classes();
  if (token.kind == Token::Kind::number || token.kind == Token::Kind::ordinal) return false;
  return token.kind != Token::Kind::word || words.count(token.text) > 0;
}

}  // namespace roomgen::language
