#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "fit_rugs.h"

namespace roomgen {

/// Of a finished room whose things are put elsewhere: what stands on a rug stays on it with all its feet, and what
/// stands beside it stays beside it, so that no height changes.
class RugRule {
 public:
  /// Asks nothing.
  RugRule() = default;
  /// As the things stand. What stands partly on a rug may go on doing so.
  RugRule(std::span<const Object> objects, const ModelTable& models);

  /// Is the rule kept between two of the things where they are now? Also if neither is a rug.
  bool keeps(std::size_t a, const Footprint& at_a, std::size_t b, const Footprint& at_b) const;

 private:
  struct Stand {
    RugStand stand = RugStand::beside;
    std::vector<Footprint> parts;  ///< that come down to the rug, in the thing's frame
  };
  std::map<std::pair<std::size_t, std::size_t>, Stand> stands_;  ///< by thing and rug
};

}  // namespace roomgen
