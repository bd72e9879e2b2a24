#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace roomgen::language {

/// Weights of features for labels, read in place from bytes that are part of the program, as AveragedWeights
/// (train/averaged_weights.h) writes them: a magic; the number of slots, a power of two (4 bytes); that many slots of
/// a feature's hash (4 bytes, 0: free), its first weight (3) and number of weights (1); then weights of a label (1)
/// and a signed value (2). Little end first; a feature is at the first slot from its hash on.
class LinearModel {
 public:
  LinearModel() = default;
  /// Empty if the bytes do not begin with the magic. They must outlive the model.
  LinearModel(std::string_view bytes, std::string_view magic);

  /// Adds the weights of a feature to the sums of the labels.
  void add_to(std::span<int> sums, std::uint32_t feature) const;

  static constexpr std::size_t slot_size = 8, weight_size = 3;

 private:
  std::string_view slots_, weights_;
  std::uint32_t mask_ = 0;
};

}  // namespace roomgen::language
