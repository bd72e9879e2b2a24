#include "label_placer.h"

namespace roomgen::detail {

bool LabelPlacer::fits(const Vec2& center, const Vec2& size) const {
  const Vec2 low = center - 0.5 * size, high = center + 0.5 * size;
  if (low.minCoeff() < 0 || high.x() > picture_.x() || high.y() > picture_.y()) return false;
  for (const auto& other : labels_) {
    const Vec2 apart = (center - other.center).cwiseAbs() - 0.5 * (size + other.size);
    if (apart.maxCoeff() < 0) return false;
  }
  return true;
}

bool LabelPlacer::place(const Drawing::Label& label) {
  if (!fits(label.center, label.size)) return false;
  labels_.push_back(label);
  return true;
}

}  // namespace roomgen::detail
