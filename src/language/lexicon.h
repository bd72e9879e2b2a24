#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "word_class.h"

namespace roomgen::language {

namespace layout {
enum class Section : int;
}

/// One meaning of a word.
struct Sense {
  PartOfSpeech part = PartOfSpeech::noun;
  int rank = 1;               ///< among those of its part of speech, the commonest first
  std::uint32_t synset = 0;   ///< words that share one are synonyms in this sense
  double tagged = 0.0;        ///< how often it was met in tagged texts, to about 9 %
  std::uint32_t classes = 0;  ///< bit k: the k-th WordClass

  bool is(WordClass word_class) const { return classes >> static_cast<int>(word_class) & 1; }
};

/// General knowledge of English: the words of WordNet 3.0 with their meanings, synonyms and more
/// general terms, in lower case, several words with spaces between them ("dining table"). Read in
/// place from bytes that are part of the program: it costs nothing to begin with, and looking a
/// word up takes under a microsecond. Words are lemmas: see inflection.h for their other forms.
class Lexicon {
 public:
  /// `bytes` as src/language/lexicon_layout.h describes them; they must outlive it.
  explicit Lexicon(std::string_view bytes);

  std::size_t size() const { return lemma_count_; }
  /// The lemma of a number below size(), in the order of their bytes.
  std::string_view lemma(std::size_t number) const;

  bool has(std::string_view word) const { return find(word).has_value(); }
  bool has(std::string_view word, PartOfSpeech part) const;
  /// By part of speech, then by rank; empty for unknown words.
  std::vector<Sense> senses(std::string_view word) const;
  std::vector<Sense> senses(std::string_view word, PartOfSpeech part) const;
  /// Those that are met at least a tenth as often as the commonest one.
  std::vector<Sense> common_senses(std::string_view word, PartOfSpeech part) const;
  /// The synset of a sense as WordNet writes it: "machine.n.1"; nothing if there is none. Nouns only.
  std::optional<std::uint32_t> synset(std::string_view sense) const;
  /// The words of a synset.
  std::vector<std::string_view> members(std::uint32_t synset) const;
  /// The synsets one step more general than a synset.
  std::vector<std::uint32_t> more_general(std::uint32_t synset) const;
  /// How often the word was met as this part of speech; 0 also for known words that are rare.
  double tagged(std::string_view word, PartOfSpeech part) const;

  /// The share of a noun's (or another part's) uses in which it is of the class, 0 to 1.
  double share(std::string_view word, WordClass word_class,
               PartOfSpeech part = PartOfSpeech::noun) const;
  /// Whether that is what the noun usually means: its first sense, or at least half of its uses.
  bool is(std::string_view word, WordClass word_class) const;
  /// Whether one of the common senses is of the class.
  bool may_be(std::string_view word, WordClass word_class) const;

  /// Whether the words share one of the common senses of both.
  bool are_synonyms(std::string_view a, std::string_view b,
                    PartOfSpeech part = PartOfSpeech::noun) const;
  /// How many steps up from a common sense of `word` a common sense of `general` lies: 0 for
  /// synonyms, nothing if none does within `most` steps.
  std::optional<int> steps_up(std::string_view word, std::string_view general, int most = 12,
                              PartOfSpeech part = PartOfSpeech::noun) const;
  /// Synonyms in the common senses, the commonest first, without the word itself.
  std::vector<std::string_view> synonyms(std::string_view word, PartOfSpeech part) const;
  /// Words one step more general in the common senses.
  std::vector<std::string_view> hypernyms(std::string_view word, PartOfSpeech part) const;

  /// The lemmas of an irregular form ("feet" gives foot), and the other way round.
  std::vector<std::string_view> irregular_bases(std::string_view form, PartOfSpeech part) const;
  std::vector<std::string_view> irregular_forms(std::string_view lemma, PartOfSpeech part) const;

  /// Goes with every copy of the data.
  std::string_view licence() const;

 private:
  std::optional<std::size_t> find(std::string_view word) const;
  std::size_t number(layout::Section section, std::size_t index) const;
  std::string_view text(layout::Section starts, layout::Section text, std::size_t index) const;
  PartOfSpeech part_of(std::size_t synset) const;

  std::string_view bytes_;
  std::size_t lemma_count_ = 0, irregular_count_ = 0;
};

/// The lexicon that is built in.
const Lexicon& lexicon();

}  // namespace roomgen::language
