#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace roomgen {

/// A seeded generator (PCG32, O'Neill 2014) with distributions of its own: a seed must give the same room everywhere.
/// Two draws are never arguments of one call, since compilers differ in which they evaluate first.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

  /// An independent generator for a named purpose: drawing from it leaves this one as it is, so that
  /// a new consumer of randomness does not change what the others see.
  Random fork(std::string_view purpose) const;

  std::uint32_t next();
  /// Uniform in [0, 1).
  double uniform();
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in {low, …, high}; precondition low <= high.
  int integer(int low, int high);
  bool chance(double probability) { return uniform() < probability; }
  /// Normal distribution (Box-Muller).
  double normal(double mean, double deviation);
  /// An index drawn in proportion to the weights; precondition: one of them is positive.
  std::size_t weighted(const std::vector<double>& weights);

  template <typename T>
  const T& pick(const std::vector<T>& items) {
    return items[static_cast<std::size_t>(integer(0, static_cast<int>(items.size()) - 1))];
  }
  template <typename T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i)
      std::swap(items[i - 1], items[static_cast<std::size_t>(integer(0, static_cast<int>(i) - 1))]);
  }

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_ = 0;
};

}  // namespace roomgen
