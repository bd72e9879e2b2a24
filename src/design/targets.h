#pragma once

#include <vector>

#include "roomgen/scene/relation.h"
#include "sketch.h"

namespace roomgen::design {

/// A way with things instead of kinds ("near, sofa" became "near, sofa-1").
struct Choice {
  std::vector<Relation> relations;
  double burden = 0.0;  ///< how well provided its targets are already: 0 for none, 1 for enough
};

/// The ways to name things, those with the least burden first. Empty if a kind has no member in the
/// room. Each kind means one thing throughout a way.
std::vector<Choice> resolve(const Sketch& sketch, const Object& self,
                            const std::vector<Relation>& way);

}  // namespace roomgen::design
