#pragma once

#include <vector>

#include "camera.h"
#include "marks.h"
#include "roomgen/scene/room.h"

namespace roomgen::detail {

/// Puts labels into a picture so that their boxes stay inside it and apart from each other.
class LabelPlacer {
 public:
  LabelPlacer(double width, double height) : picture_(width, height) {}

  bool fits(const Vec2& center, const Vec2& size) const;
  /// Adds the label if it fits where it is.
  bool place(const Drawing::Label& label);
  const Vec2& picture() const { return picture_; }
  const std::vector<Drawing::Label>& labels() const { return labels_; }

 private:
  Vec2 picture_;
  std::vector<Drawing::Label> labels_;
};

/// Multiples of the step within [low, high].
std::vector<double> multiples(double low, double high, double step);

/// Adds grid lines, coordinates beside the room and the axes. Labels that find no place are left
/// out.
void lay_grid(const Room& room, const Camera& camera, bool paper_frame, double letter_height,
              LabelPlacer& placer, std::vector<Drawing::Stroke>& strokes);

/// Adds "x,y" at crossings of grid lines where nothing is in the way.
void lay_grid_points(const Scene& scene, const Camera& camera, bool paper_frame,
                     double letter_height, LabelPlacer& placer,
                     std::vector<Drawing::Stroke>& strokes);

/// "wall-2 north", where it looks to a side.
std::string wall_title(const Room& room, std::size_t wall, const std::string& separator);
/// "window-0, sill 0.9, head 2.1"; of others the id.
std::string opening_title(const Opening& opening, const std::string& separator);

enum class PartNames {
  ids,     ///< of walls and openings: outside, else inside
  inside,  ///< the same, inside alone
  titles,  ///< wall_title() and opening_title(), outside, else inside
};
/// Names walls, doors and windows beside them, as far as there is room.
void place_part_labels(const Room& room, const Camera& camera, double letter_height,
                       LabelPlacer& placer, PartNames names);

/// Hatches what doors and windows need, and of each thing that can be used from one side only what
/// it needs there.
void lay_clear_zones(const Scene& scene, const Camera& camera,
                     std::vector<Drawing::Stroke>& strokes);

}  // namespace roomgen::detail
