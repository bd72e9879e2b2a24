#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "linear_model.h"
#include "tag_features.h"
#include "word_tag.h"

namespace roomgen::language {

/// Which tag a word has, learned from the corpus by an averaged perceptron.
class TagModel {
 public:
  explicit TagModel(std::string_view bytes) : weights_(bytes, magic) {}

  /// The sums of the weights by tag.
  std::array<int, word_tag_count> scores(const TagFeatures& features) const;
  /// The best of those that the word may have.
  WordTag best(const TagFeatures& features, const UnitFacts& facts,
               const TagContext& context) const;

  static constexpr std::string_view magic = "roomgen tagger 1\n";

 private:
  LinearModel weights_;
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
