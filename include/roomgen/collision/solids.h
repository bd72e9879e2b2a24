#pragma once

#include <memory>

#include "roomgen/scene/model_table.h"
#include "roomgen/scene/object.h"

namespace roomgen {

/// Decides whether two placed things share space (docs/constraints.md, "solid"): boxes first, then
/// meshes of at most 20,000 triangles. Keeps a bounding-volume tree of every mesh that it has seen.
/// Not for use by two threads at once.
class Solids {
 public:
  /// `models` must outlive this; objects without a model count as their boxes.
  explicit Solids(const ModelTable& models);
  ~Solids();

  /// Meshes that still intersect after either of them is moved 5 mm away from the other, or one inside
  /// the other. The order of the two does not matter.
  bool overlap(const Object& a, const Object& b);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Do the boxes (for round things the cylinders) share space? Touching is no overlap.
bool boxes_overlap(const Object& a, const Object& b);
/// Both solid: rugs share the floor with what stands on them.
bool both_solid(const Object& a, const Object& b);

}  // namespace roomgen
