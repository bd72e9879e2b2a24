#pragma once

#include "label_placer.h"

namespace roomgen::detail {

/// What the layout needs to know of an object, in pixels.
struct ObjectMark {
  std::string id;
  std::vector<Vec2> outline;
  Vec2 center = Vec2::Zero();
  Vec2 arrow_end = Vec2::Zero();  ///< equals the centre if the object has no front
};

ObjectMark object_mark(const Object& object, const Camera& camera);
bool contains(const ObjectMark& mark, const Vec2& pixel);

/// Places one label an object, near it, with leaders where a label had to move away. Fails when
/// there is no room for one of them at this letter height.
bool place_object_labels(const std::vector<ObjectMark>& marks, double letter_height,
                         LabelPlacer& placer, std::vector<Drawing::Stroke>& leaders);

}  // namespace roomgen::detail
