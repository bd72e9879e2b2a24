#include "tone.h"

#include "language/lexicon.h"
#include "scene/finish_words.h"

namespace roomgen::brief {

bool begins_tone(std::span<const Token> tokens, std::size_t i, const Vocabulary& words) {
  const FinishWords& finishes = finish_words();
  if (i + 1 >= tokens.size() || tokens[i].kind != Token::Kind::word || !finishes.basic_colors.count(tokens[i + 1].text)) return false;
  const std::string& first = tokens[i].text;
  if (finishes.basic_colors.count(first)) return false;  // "black white": two of them
  if (finishes.colors.count(first)) return true;
  const bool is_other = finishes.describes(first) || words.materials.count(first) || words.sizes.count(first) ||
                        words.room_words.count(first) || words.numbers.count(first) || words.stops.count(first) ||
                        words.definite.count(first) || words.negations.count(first);
  using language::PartOfSpeech;
  const auto& english = language::lexicon();
  return !is_other && english.tagged(first, PartOfSpeech::noun) > english.tagged(first, PartOfSpeech::adjective);
}

}  // namespace roomgen::brief
