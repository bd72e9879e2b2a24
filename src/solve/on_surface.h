#pragma once

#include <optional>
#include <vector>

#include "layout.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

/// How well a thing stands on the surfaces of its support: gathered once, asked for many poses.
class Rest {
 public:
  /// Nothing for what does not stand on a thing of the layout.
  static std::optional<Rest> of(const Layout& layout, const Object& object);

  /// In [0, 1]: on the surface that is taken first (a table's top, a shelf's boards within reach), turned
  /// to who uses it, not at the very edge.
  double degree(const Footprint& footprint, double bottom) const;

 private:
  double worth(const SupportSurface& surface) const;
  double user_yaw(const Footprint& own) const;

  const std::vector<SupportSurface>* surfaces_ = nullptr;
  Footprint area_;
  double base_ = 0.0, height_ = 0.0;
  double rim_ = 0.0;          ///< the highest surface
  double best_worth_ = 0.0;
  bool has_front_ = false;    ///< the thing
  bool shelves_ = false, basin_ = false;
  std::vector<Footprint> seats_;  ///< at the support
};

}  // namespace roomgen
