#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "tag_features.h"
#include "word_tag.h"

namespace roomgen::language {

/// The weights of an averaged perceptron (Collins, "Discriminative training methods for hidden
/// Markov models", 2002), read in place from bytes that are part of the program.
///
/// The bytes: magic; the number of slots, a power of two (4 bytes); that many slots of a feature's
/// hash (4 bytes, 0: free) and its first weight (3) and number of weights (1); then weights of a
/// tag (1) and a signed value (2). Little end first; a feature is at the first slot from its hash
/// on.
class TagModel {
 public:
  explicit TagModel(std::string_view bytes);

  /// The sums of the weights by tag.
  std::array<int, word_tag_count> scores(const TagFeatures& features) const;
  /// The best of those that the word may have.
  WordTag best(const TagFeatures& features, const UnitFacts& facts,
               const TagContext& context) const;

  static constexpr std::string_view magic = "roomgen tagger 1\n";
  static constexpr std::size_t slot_size = 8, weight_size = 3;

 private:
  std::string_view slots_, weights_;
  std::uint32_t mask_ = 0;
};

/// Small words belong to closed classes: they are no nouns and no verbs behind one.
bool may_have(const UnitFacts& facts, const TagContext& context, WordTag tag);

/// The model that is built in.
const TagModel& tag_model();

/// The tag of every unit, from left to right.
std::vector<WordTag> tag_words(const std::vector<Unit>& units, const std::vector<UnitFacts>& facts,
                               const TagModel& model);

/// The tag of what is no word; nothing for words.
std::optional<WordTag> given_tag(const Unit& unit);

}  // namespace roomgen::language
