#pragma once

#include <vector>

#include "marks.h"

namespace roomgen::detail {

/// Puts labels into a picture so that their boxes stay inside it and apart from each other.
class LabelPlacer {
 public:
  LabelPlacer(double width, double height) : picture_(width, height) {}

  bool fits(const Vec2& center, const Vec2& size) const;
  /// Adds the label if it fits where it is.
  bool place(const Drawing::Label& label);
  const std::vector<Drawing::Label>& labels() const { return labels_; }

 private:
  Vec2 picture_;
  std::vector<Drawing::Label> labels_;
};

}  // namespace roomgen::detail
