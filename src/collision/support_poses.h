#pragma once

#include <memory>
#include <limits>
#include <span>
#include <vector>

#include "roomgen/scene/scene.h"
#include "roomgen/scene/object.h"
#include "support_surfaces.h"

namespace roomgen {

/// Where one thing rests on another: in the frame of the lower one, heights from its bottom.
struct SupportPose {
  Vec2 position = Vec2::Zero();  ///< centre of the upper one's box
  double bottom = 0.0;           ///< of the upper one, such that the meshes touch
  double yaw = 0.0;              ///< against the lower one's
  std::size_t surface = 0;       ///< of the lower one's surfaces
};

/// Knows the surfaces of objects (support_surfaces.h, at their size) and where things rest on them.
/// Meshes are those of `models`; objects without one are boxes. What has been found is kept, by mesh
/// and size. Not for use by two threads at once.
class SupportPoses {
 public:
  /// `models` must outlive this.
  explicit SupportPoses(const ModelTable& models);
  ~SupportPoses();

  /// Of an object, whatever its pose, the largest first; none of flat things.
  const std::vector<SupportSurface>& surfaces(const Object& support) const;

  /// Everywhere on all surfaces, on a grid and turned by quarters: where the whole footprint is on a
  /// surface, and only if there is no such place on any, where up to a tenth of it is not. What
  /// else stands there does not count.
  const std::vector<SupportPose>& everywhere(const Object& object, const Object& support) const;

  /// Is any of these places such that the bottom is at most so high? Found out faster than all.
  bool carries(const Object& object, const Object& support,
               double highest_bottom = std::numeric_limits<double>::infinity()) const;

  /// In the frame of the support.
  struct Place {
    Vec2 position = Vec2::Zero();
    double yaw = 0.0;
  };
  /// On whichever surfaces the object rests at the places: enough height, the centre of mass over the
  /// points of contact. One place after the other, the largest surface first.
  std::vector<SupportPose> at(const Object& object, const Object& support,
                              std::span<const Place> places) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace roomgen
