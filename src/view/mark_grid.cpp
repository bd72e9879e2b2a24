#include <algorithm>
#include <cmath>

#include "label_placer.h"
#include "roomgen/base/text.h"

namespace roomgen::detail {

namespace {

// The room's extent in the coordinates of the marks; axis 0 is the marks' x.
Bounds2 mark_extent(const Room& room, bool paper_frame) {
  Bounds2 extent;
  for (const auto& point : room.polygon.points)
    extent.add(mark_from_room(room, point, paper_frame));
  return extent;
}

// The parts of a line inside the room, as pairs of positions along it. `axis` is the coordinate of
// the scene that is fixed at `value`.
std::vector<double> crossings(const Room& room, int axis, double value) {
  std::vector<double> positions;
  for (std::size_t k = 0; k < room.polygon.size(); ++k) {
    const Segment e = room.polygon.edge(k);
    if ((e.a[axis] > value) == (e.b[axis] > value)) continue;
    const double t = (value - e.a[axis]) / (e.b[axis] - e.a[axis]);
    positions.push_back(e.a[1 - axis] + t * (e.b[1 - axis] - e.a[1 - axis]));
  }
  std::sort(positions.begin(), positions.end());
  return positions;
}

Vec2 on_line(int axis, double value, double along) {
  return axis == 0 ? Vec2(value, along) : Vec2(along, value);
}

std::vector<Vec2> dot_at(const Vec2& center, double radius) {
  constexpr int corners = 10;
  std::vector<Vec2> outline;
  for (int i = 0; i < corners; ++i)
    outline.push_back(center + radius * rotated(Vec2(1, 0), 2.0 * pi * i / corners));
  return outline;
}

class Grid {
 public:
  Grid(const Room& room, const Camera& camera, bool paper_frame, double letter_height,
       LabelPlacer& placer, std::vector<Drawing::Stroke>& strokes)
      : room_(room),
        camera_(camera),
        paper_(paper_frame),
        letter_(letter_height),
        placer_(placer),
        strokes_(strokes),
        outer_(outer_extent()) {}

  /// Everything about one coordinate of the marks: 0 is x, 1 is y.
  void lay_axis(int mark_axis) {
    const int axis = paper_ ? 1 - mark_axis : mark_axis;  // of the scene
    const Bounds2 extent = mark_extent(room_, paper_);
    name_axis(mark_axis, axis);
    const double step = grid_step(room_);
    for (const double value : multiples(extent.low[mark_axis], extent.high[mark_axis], step)) {
      Vec2 mark = Vec2::Zero();
      mark[mark_axis] = value;
      const double position = room_from_mark(room_, mark, paper_)[axis];
      draw_line(axis, position);
      const std::string text = format_number(value, 2);
      label_both_ends(axis, position, text);
    }
  }

 private:
  Bounds2 outer_extent() const {
    Bounds2 extent;
    for (const auto& p : offset_outward(room_.polygon, wall_thickness))
      extent.add(camera_.pixel({p.x(), p.y(), 0.0}));
    return extent;
  }

  void draw_line(int axis, double position) {
    const auto ends = crossings(room_, axis, position);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      const Vec2 a = on_line(axis, position, ends[i]), b = on_line(axis, position, ends[i + 1]);
      strokes_.push_back(
          {Drawing::Line::grid,
           {camera_.pixel({a.x(), a.y(), 0.0}), camera_.pixel({b.x(), b.y(), 0.0})}});
    }
  }

  // Below and above the room for a position along x, else to its left and right.
  void label_both_ends(int axis, double position, const std::string& text) {
    const Vec2 p = on_line(axis, position, 0.0);
    const Vec2 pixel = camera_.pixel({p.x(), p.y(), 0.0});
    const Vec2 size = label_size(text, letter_);
    const Vec2 gap = 0.5 * size + Vec2::Constant(0.3 * letter_);
    for (const bool high : {true, false}) {
      Vec2 center = high ? Vec2(outer_.high + gap) : Vec2(outer_.low - gap);
      center[axis] = pixel[axis];
      placer_.place({Drawing::Text::tick, text, center, size});
    }
  }

  // In the corner towards which the coordinate grows, with an arrow that shows it.
  void name_axis(int mark_axis, int axis) {
    const std::string text = mark_axis == 0 ? "x (m)" : "y (m)";
    const Vec2 size = label_size(text, letter_);
    // Plan: x runs to the right along the lower side, y up the left one. Paper: x runs down the
    // right side, y to the left along the upper one.
    const Vec2 corner = mark_axis == 0 ? outer_.high : outer_.low;
    const Vec2 outward = (corner - 0.5 * (outer_.low + outer_.high)).cwiseSign();
    Vec2 center = corner + outward.cwiseProduct(0.5 * size + Vec2::Constant(0.3 * letter_));
    const Vec2 picture(camera_.width, camera_.height);
    center =
        center.cwiseMin(picture - 0.5 * size - Vec2::Ones()).cwiseMax(0.5 * size + Vec2::Ones());
    placer_.place({Drawing::Text::axis, text, center, size});
    add_axis_arrow(axis, corner, outward);
  }

  void add_axis_arrow(int axis, const Vec2& corner, const Vec2& outward) {
    Vec2 tip = corner;
    tip[1 - axis] += outward[1 - axis] * 0.25 * letter_;
    Vec2 tail = tip;
    tail[axis] -= outward[axis] * 6.0 * letter_;
    strokes_.push_back({Drawing::Line::axis, {tail, tip}});
  }

  const Room& room_;
  const Camera& camera_;
  bool paper_;
  double letter_;
  LabelPlacer& placer_;
  std::vector<Drawing::Stroke>& strokes_;
  Bounds2 outer_;  ///< of the walls, pixels
};

}  // namespace

std::vector<double> multiples(double low, double high, double step) {
  std::vector<double> values;
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9; i += 1.0)
    values.push_back(i * step + 0.0);
  return values;
}

void lay_grid(const Room& room, const Camera& camera, bool paper_frame, double letter_height,
              LabelPlacer& placer, std::vector<Drawing::Stroke>& strokes) {
  Grid grid(room, camera, paper_frame, letter_height, placer, strokes);
  grid.lay_axis(0);
  grid.lay_axis(1);
}

void lay_grid_points(const Scene& scene, const Camera& camera, bool paper_frame,
                     double letter_height, LabelPlacer& placer,
                     std::vector<Drawing::Stroke>& strokes) {
  const Room& room = scene.room;
  const Bounds2 extent = mark_extent(room, paper_frame);
  const double step = 2.0 * grid_step(room);
  for (const double x : multiples(extent.low.x(), extent.high.x(), step))
    for (const double y : multiples(extent.low.y(), extent.high.y(), step)) {
      const Vec2 point = room_from_mark(room, {x, y}, paper_frame);
      if (!contains(room.polygon, point) || distance_to_boundary(room.polygon, point) < 0.1)
        continue;
      const std::string text = format_number(x, 2) + "," + format_number(y, 2);
      const Vec2 size = label_size(text, letter_height);
      // Beside the crossing, so that the crossing itself can be seen.
      const Vec2 pixel = camera.pixel({point.x(), point.y(), 0.0});
      const Vec2 beside = pixel + Vec2(0.5 * size.x() + 1.0, -0.5 * size.y() - 1.0);
      if (placer.place({Drawing::Text::point, text, beside, size}))
        strokes.push_back({Drawing::Line::dot, dot_at(pixel, 0.32 * letter_height)});
    }
}

}  // namespace roomgen::detail
