#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace roomgen::language {

/// The weights of an averaged perceptron (Collins, "Discriminative training methods for hidden Markov models", 2002)
/// while it learns.
class AveragedWeights {
 public:
  explicit AveragedWeights(std::size_t labels) : labels_(labels) {}

  /// Only known features get weights.
  void know(std::uint32_t feature);
  void add_to(std::span<double> sums, std::uint32_t feature) const;
  void change(std::uint32_t feature, std::size_t label, double by);
  /// Behind every decision, right or wrong: the average is over these.
  void step() { ++steps_; }
  /// What LinearModel reads. The same decisions give the same bytes.
  std::string bytes(std::string_view magic) const;

 private:
  struct Weights {
    std::vector<double> now, sum;
    std::vector<int> since;
  };
  int averaged(const Weights& weights, std::size_t label) const;

  std::size_t labels_;
  std::unordered_map<std::uint32_t, Weights> weights_;
  int steps_ = 0;
};

/// The order in which sentences are learned from, another one each round. The same on every machine.
class LearningOrder {
 public:
  explicit LearningOrder(std::size_t count);
  const std::vector<std::size_t>& next();

 private:
  std::vector<std::size_t> order_;
  std::uint32_t state_ = 1;
};

}  // namespace roomgen::language
