#include "perceptron.h"

#include <array>
#include <unordered_map>

#include "averaged_weights.h"
#include "tag_model.h"

namespace roomgen::language {

namespace {

constexpr int rounds = 30;       ///< averaged, so that the order of the sentences matters little
constexpr int fewest = 2;        ///< places of the corpus where a feature has to occur

class Perceptron {
 public:
  explicit Perceptron(const std::vector<TaggedSentence>& sentences) : sentences_(sentences) {
    std::unordered_map<std::uint32_t, int> occurrences;
    for (const auto& sentence : sentences) {
      TagContext context;
      for (std::size_t i = 0; i < sentence.units.size(); ++i) {
        if (!given_tag(sentence.units[i]))
          for (const auto feature : tag_features(sentence.facts, i, context))
            ++occurrences[feature];
        context.add(sentence.units[i], sentence.facts[i], sentence.tags[i]);
      }
    }
    for (const auto& [feature, count] : occurrences)
      if (count >= fewest) weights_.know(feature);
  }

  void run() {
    LearningOrder order(sentences_.size());
    for (int round = 0; round < rounds; ++round)
      for (const auto i : order.next()) learn(sentences_[i]);
  }

  std::string bytes() const { return weights_.bytes(TagModel::magic); }

 private:
  // It goes on from what it would have said itself, as when it reads.
  void learn(const TaggedSentence& sentence) {
    TagContext context;
    for (std::size_t i = 0; i < sentence.units.size(); ++i) {
      WordTag tag = sentence.tags[i];
      if (!given_tag(sentence.units[i]))
        tag = learn(tag_features(sentence.facts, i, context), sentence.facts[i], context, tag);
      context.add(sentence.units[i], sentence.facts[i], tag);
    }
  }

  WordTag learn(const TagFeatures& features, const UnitFacts& facts, const TagContext& context,
                WordTag right) {
    weights_.step();
    std::array<double, word_tag_count> sums{};
    for (const auto feature : features) weights_.add_to(sums, feature);
    const auto wanted = static_cast<std::size_t>(right);
    std::size_t said = wanted;
    for (std::size_t tag = 0; tag < word_tag_count; ++tag)
      if (tag != wanted && sums[tag] >= sums[said] &&
          may_have(facts, context, static_cast<WordTag>(tag)))
        said = tag;
    if (said != wanted)
      for (const auto feature : features) {
        weights_.change(feature, said, -1.0);
        weights_.change(feature, wanted, 1.0);
      }
    return static_cast<WordTag>(said);
  }

  const std::vector<TaggedSentence>& sentences_;
  AveragedWeights weights_{word_tag_count};
};

}  // namespace

std::string train(const std::vector<TaggedSentence>& sentences) {
  Perceptron perceptron(sentences);
  perceptron.run();
  return perceptron.bytes();
}

}  // namespace roomgen::language
