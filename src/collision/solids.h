#pragma once

#include <memory>

#include "roomgen/scene/scene.h"
#include "roomgen/scene/object.h"

namespace roomgen {

/// Decides whether two placed things share space (docs/constraints.md, "solid"): the one answer for
/// whoever places, checks or scores. Boxes first, then meshes of at most 20,000 triangles. Keeps a
/// bounding-volume tree of every mesh that it has seen. Not for use by two threads at once.
class Solids {
 public:
  /// `models` must outlive this; objects without a model count as their boxes, round ones as
  /// cylinders.
  explicit Solids(const ModelTable& models);
  ~Solids();

  /// Are both solid, and do they intersect()?
  bool overlap(const Object& a, const Object& b);

  /// Meshes that still cross after either of them is moved 5 mm away from the other, or one inside
  /// the other; rugs too. The order of the two does not matter.
  bool intersect(const Object& a, const Object& b);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What was asked of the pairs of one room whose boxes overlap. A thousand things at one spot are half a million
/// pairs of meshes; rooms have a few for each thing (docs/limits.md).
struct Crowd {
  static constexpr std::size_t most_pairs = 10000, most_overlaps = 200;
  std::size_t pairs = 0, overlaps = 0;

  bool is_full() const { return pairs == most_pairs || overlaps == most_overlaps; }
  /// Returns what it is told.
  bool add(bool overlap) {
    ++pairs;
    overlaps += overlap ? 1 : 0;
    return overlap;
  }
};

/// Do the boxes share space? Touching is no overlap.
bool boxes_overlap(const Object& a, const Object& b);
/// The middle of a rug, all of which must lie on the rug that it lies over.
Footprint core_of_rug(const Footprint& rug);
/// Is the one so much smaller than the other rug, and so far within it, that it may lie over it?
bool may_lie_over(const Footprint& rug, const Footprint& larger);
/// Would `object`, were it there, share space with the other's box where that is not allowed in general? Rugs
/// may lie under everything, and over larger rugs.
bool boxes_clash(const Object& object, const Footprint& footprint, double bottom, const Object& other,
                 const Footprint& footprint_of_other);
/// Both solid: rugs share the floor with what stands on them.
bool both_solid(const Object& a, const Object& b);

}  // namespace roomgen
