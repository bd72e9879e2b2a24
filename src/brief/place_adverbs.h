#pragma once

#include <cstddef>
#include <vector>

#include "place_teller.h"
#include "prompt_reading.h"

namespace roomgen::brief {

/// Reads words of place that name nothing and that no attachment has: "nearby", "on top", "side by side".
class PlaceAdverbs {
 public:
  PlaceAdverbs(PromptReading& reading, PlaceTeller& teller);

  /// Those before a token that were not read yet.
  void read_up_to(std::size_t end);

 private:
  bool is_doubled(std::size_t first, std::size_t length) const;
  Indices subjects_at(std::size_t token) const;

  PromptReading& reading_;
  PlaceTeller& teller_;
  const std::vector<bool> left_;  ///< by token: no phrase has it and no attachment
  std::size_t next_ = 0;          ///< token
};

}  // namespace roomgen::brief
