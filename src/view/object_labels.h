#pragma once

#include "label_placer.h"

namespace roomgen::detail {

/// What the layout needs to know of an object, in pixels.
struct ObjectMark {
  std::string id;
  std::string text;  ///< its name in the picture; empty: it has none
  std::vector<Vec2> outline;
  Vec2 center = Vec2::Zero();
  Vec2 arrow_start = Vec2::Zero();
  Vec2 arrow_end = Vec2::Zero();  ///< equals the start if the object has no front
  Drawing::Line look = Drawing::Line::outline;
  bool may_be_nameless = false;
};

/// Named by its id.
ObjectMark object_mark(const Object& object, const Camera& camera);
bool contains(const ObjectMark& mark, const Vec2& pixel);

/// Gives the marks the names that leave the picture readable: `floor` are the pixels of the room.
/// Some may lose theirs, kinds of many are named briefly, with a legend along the lower edge, and
/// such things too near to each other share a name; lines that show which go to `strokes`.
void name_marks(std::vector<ObjectMark>& marks, double letter_height, double floor,
                LabelPlacer& placer, std::vector<Drawing::Stroke>& strokes);

/// Places the name of each object that has one near it, with leaders where a label had to move
/// away. Fails when there is no room for one of them at this letter height.
bool place_object_labels(const std::vector<ObjectMark>& marks, double letter_height,
                         LabelPlacer& placer, std::vector<Drawing::Stroke>& leaders);

}  // namespace roomgen::detail
