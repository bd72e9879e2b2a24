#include "perceptron.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <unordered_map>

#include "tag_model.h"

namespace roomgen::language {

namespace {

constexpr int rounds = 30;       ///< averaged, so that the order of the sentences matters little
constexpr int fewest = 2;        ///< places of the corpus where a feature has to occur
constexpr double scale = 256.0;  ///< of the weights that are written
constexpr double greatest = 32767.0;

struct Weights {
  std::array<double, word_tag_count> now{}, sum{};
  std::array<int, word_tag_count> since{};
};

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
      if (count >= fewest && feature != 0) weights_[feature];
  }

  void run() {
    std::vector<std::size_t> order(sentences_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::uint32_t state = 1;
    for (int round = 0; round < rounds; ++round) {
      // std::shuffle differs between libraries.
      for (std::size_t i = order.size(); i-- > 1;) {
        state = state * 1664525u + 1013904223u;
        std::swap(order[i], order[(state >> 8) % (i + 1)]);
      }
      for (const auto i : order) learn(sentences_[i]);
    }
  }

  // By hash: a feature and its averaged weights that are not nothing.
  std::map<std::uint32_t, std::vector<std::pair<std::size_t, int>>> averaged() {
    std::map<std::uint32_t, std::vector<std::pair<std::size_t, int>>> result;
    for (auto& [feature, weights] : weights_)
      for (std::size_t tag = 0; tag < word_tag_count; ++tag) {
        settle(weights, tag);
        const double mean = scale * weights.sum[tag] / std::max(1, step_);
        const int value = static_cast<int>(std::lround(std::clamp(mean, -greatest, greatest)));
        if (value != 0) result[feature].push_back({tag, value});
      }
    return result;
  }

 private:
  void settle(Weights& weights, std::size_t tag) const {
    weights.sum[tag] += weights.now[tag] * (step_ - weights.since[tag]);
    weights.since[tag] = step_;
  }

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
    ++step_;
    std::array<double, word_tag_count> sums{};
    std::array<Weights*, std::tuple_size_v<TagFeatures>> found{};
    for (std::size_t i = 0; i < features.size(); ++i) {
      const auto weights = weights_.find(features[i]);
      if (weights == weights_.end()) continue;
      found[i] = &weights->second;
      for (std::size_t tag = 0; tag < word_tag_count; ++tag) sums[tag] += found[i]->now[tag];
    }
    const auto wanted = static_cast<std::size_t>(right);
    std::size_t said = wanted;
    for (std::size_t tag = 0; tag < word_tag_count; ++tag)
      if (tag != wanted && sums[tag] >= sums[said] &&
          may_have(facts, context, static_cast<WordTag>(tag)))
        said = tag;
    if (said != wanted)
      for (Weights* weights : found)
        if (weights) {
          change(*weights, said, -1.0);
          change(*weights, wanted, 1.0);
        }
    return static_cast<WordTag>(said);
  }
  void change(Weights& weights, std::size_t tag, double by) const {
    settle(weights, tag);
    weights.now[tag] += by;
  }

  const std::vector<TaggedSentence>& sentences_;
  std::unordered_map<std::uint32_t, Weights> weights_;
  int step_ = 0;
};

void append(std::string& to, std::size_t value, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i) to += static_cast<char>(value >> (8 * i) & 0xff);
}

}  // namespace

std::string train(const std::vector<TaggedSentence>& sentences) {
  Perceptron perceptron(sentences);
  perceptron.run();
  const auto features = perceptron.averaged();
  std::size_t count = 1;
  while (2 * count < 3 * features.size()) count *= 2;
  struct Slot {
    std::uint32_t feature = 0;
    std::size_t first = 0, many = 0;
  };
  std::vector<Slot> slots(count);
  std::string weights;
  for (const auto& [feature, values] : features) {
    std::size_t slot = feature & (count - 1);
    while (slots[slot].feature != 0) slot = (slot + 1) & (count - 1);
    slots[slot] = {feature, weights.size() / TagModel::weight_size, values.size()};
    for (const auto& [tag, value] : values) {
      append(weights, tag, 1);
      append(weights, static_cast<std::size_t>(value) & 0xffff, 2);
    }
  }
  std::string bytes(TagModel::magic);
  append(bytes, count, 4);
  for (const Slot& slot : slots) {
    append(bytes, slot.feature, 4);
    append(bytes, slot.first, 3);
    append(bytes, slot.many, 1);
  }
  return bytes + weights;
}

}  // namespace roomgen::language
