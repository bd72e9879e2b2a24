#pragma once

#include <span>
#include <string>
#include <vector>

#include "camera.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// What is drawn over a top view, in pixels from the top left corner of the picture.
struct Drawing {
  /// In the order in which they are drawn.
  enum class Line {
    paper,        ///< a wall's face, filled
    free,         ///< around a part of the floor that is free, which is shaded
    keep_clear,   ///< around what a door or a window needs, hatched
    use,          ///< around the floor without which a thing cannot be used, hatched lightly
    plan_symbol,  ///< door leaves and swings, panes of windows
    grid,         ///< faint, across the room
    hole,         ///< a door or a window in a wall's face, filled
    before,       ///< what stands before a wall, filled
    hung,         ///< what hangs on a wall, filled
    dot,          ///< around a crossing whose coordinates are written beside it, filled
    outline,      ///< of an object's footprint
    overhead,     ///< the same of what hangs over the room, dashed
    in_the_way,   ///< the same of what is in the way
    refused,      ///< where an object found no room, dashed
    axis,         ///< arrow along which a coordinate grows
    leader,       ///< from a label to its object
    arrow,        ///< an object's front; the head is at the last point
    front,        ///< an arrow over strong colours
    scale,        ///< a length that is named beside it
  };
  struct Stroke {
    Line kind = Line::grid;
    std::vector<Vec2> points;  ///< open polyline; closed ones repeat their first point
  };
  enum class Text {
    tick,    ///< a coordinate beside the room
    point,   ///< "x,y" at a crossing of grid lines
    axis,    ///< the name of an axis
    part,    ///< the id of a wall, a door or a window
    object,  ///< an object's name
    red,     ///< the same of what found no room, or is in the way
    legend,  ///< begins at the left of its box
  };
  struct Label {
    Text kind = Text::tick;
    std::string text;
    Vec2 center = Vec2::Zero();
    Vec2 size = Vec2::Zero();  ///< box that the text fits in
    double letters = 0.0;      ///< of its own, pixels; 0: text_height
  };
  std::vector<Stroke> strokes;
  std::vector<Label> labels;
  double text_height = 12.0;  ///< capital letters of object labels, pixels
};

/// Door leaves with their swing and panes of windows, as architects draw them, of all rooms.
Drawing plan_symbols(std::span<const Room> rooms, const Camera& camera);

/// Does a picture with marks show the object by its outline alone, since it hangs over what the
/// picture is about?
bool is_outline_only(const Scene& scene, const View& view, const Object& object);

/// The marks of set-of-mark prompting: grid lines every `grid_step` metres with their coordinates,
/// the axes by name, what must stay free, each object's name, outline and front. No two label boxes
/// overlap, all lie within the picture, and an object's label is on its object or tied to it by a
/// leader.
Drawing layout_marks(const Scene& scene, const Camera& camera, const View& view);

/// A drawing that needs no picture under it.
struct Sheet {
  int width = 0, height = 0;
  Drawing drawing;
};
/// View::Kind::elevation. Fails if `pixels` is out of bounds or there is no wall.
Result<Sheet> layout_elevation(const Scene& scene, const View& view);

/// Names over a picture of segments: the ids of all things that it shows, of walls, doors and windows, fronts, and
/// coordinates beside the rooms.
Drawing layout_segment_labels(const Scene& scene, const Camera& camera);

/// 0.5 m in rooms up to 6.5 m long, 1 m up to 13 m, else 2 m; less in what is no room: 0.2 m up to 2 m, 0.1 m
/// up to 1 m.
double grid_step(const Room& room);

/// Coordinates as the marks name them, from those of the scene, and back. The frame `paper`
/// measures x' = ymax - y and y' = xmax - x from the room's far corner; `plan` is the scene's own
/// frame.
Vec2 mark_from_room(const Room& room, const Vec2& point, bool paper_frame);
Vec2 room_from_mark(const Room& room, const Vec2& mark, bool paper_frame);

/// From one line of a label to the next, in heights of a letter.
inline constexpr double line_spacing = 1.45;
/// Size in pixels that a text of this letter height needs at most, its margin included.
Vec2 label_size(const std::string& text, double letter_height);

}  // namespace roomgen
