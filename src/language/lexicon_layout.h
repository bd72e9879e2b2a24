#pragma once

#include <cstddef>
#include <string_view>

// How the compiled lexicon lies in memory: what src/language/compile writes and lexicon.cpp reads
// in place. All numbers are unsigned, little end first, of `width` bytes, wherever they begin; so
// nothing depends on the alignment or the byte order of the machine.
namespace roomgen::language::layout {

inline constexpr std::string_view magic = "roomgen lexicon 1\n";
inline constexpr std::size_t width = 3;
inline constexpr std::size_t offset_width = 4;
inline constexpr std::size_t class_width = 2;

/// In this order after the magic, each given by the offset of its first byte; the last offset is
/// the size of the whole.
enum class Section : int {
  licence,           ///< text that has to go with every copy
  lemma_text,        ///< all lemmas in the order of their bytes, without separators
  lemma_starts,      ///< lemma -> its first byte in lemma_text; one more at the end
  lemma_senses,      ///< lemma -> its first sense; one more at the end
  senses,            ///< the synset of a sense; by part of speech, then by rank
  frequencies,       ///< a byte a sense: 8 log2(1 + times it was tagged in a text)
  classes,           ///< two bytes a synset: which of the masks is its own
  masks,             ///< four bytes each: bit k for the k-th word class
  general_starts,    ///< synset -> its first more general one; one more at the end
  general,           ///< synsets: hypernyms; of adjectives what they are like, or of
  member_starts,     ///< synset -> its first member; one more at the end
  members,           ///< lemmas
  irregular_text,    ///< irregular forms in the order of their bytes, without separators
  irregular_starts,  ///< form -> its first byte in irregular_text; one more at the end
  irregular_bases,   ///< form -> 4 times its lemma, plus its part of speech
  by_base,           ///< the forms in the order of irregular_bases
  parts,             ///< the first synset of each part of speech, and the number of all
  count
};

inline constexpr std::size_t section_count = static_cast<std::size_t>(Section::count);
inline constexpr std::size_t header_size = magic.size() + offset_width * (section_count + 1);

/// The factor of `frequencies`.
inline constexpr double frequency_scale = 8.0;

}  // namespace roomgen::language::layout
