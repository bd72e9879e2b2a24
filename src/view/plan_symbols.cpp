#include "marks.h"

namespace roomgen {

namespace {

using Points = std::vector<Vec2>;

Points to_pixels(const Points& points, const Camera& camera) {
  Points pixels;
  for (const auto& p : points) pixels.push_back(camera.pixel({p.x(), p.y(), 0.0}));
  return pixels;
}

// One leaf, open, and the way of its edge.
void add_leaf(Drawing& drawing, const Vec2& hinge, const Vec2& latch, const Vec2& side,
              const Camera& camera) {
  const double length = (latch - hinge).norm();
  const double closed = std::atan2((latch - hinge).y(), (latch - hinge).x());
  const double turn = cross(latch - hinge, side) > 0 ? 0.5 * pi : -0.5 * pi;
  Points leaf = {hinge, hinge + length * side}, swing;
  constexpr int steps = 24;
  for (int i = 0; i <= steps; ++i) {
    const double angle = closed + turn * i / steps;
    swing.push_back(hinge + length * Vec2(std::cos(angle), std::sin(angle)));
  }
  drawing.strokes.push_back({Drawing::Line::plan_symbol, to_pixels(leaf, camera)});
  drawing.strokes.push_back({Drawing::Line::plan_symbol, to_pixels(swing, camera)});
}

void add_door(Drawing& drawing, const Room& room, const Opening& door, const Camera& camera) {
  const Segment line = segment(room, door);
  const bool swings_in = door.swing == DoorSwing::in;
  const Vec2 side = (swings_in ? 1.0 : -1.0) * inward(room, door);
  // A door that opens outward hangs at the outer face.
  const Vec2 face = swings_in ? Vec2::Zero() : Vec2(wall_thickness * side);
  const Vec2 from = line.a + face, to = line.b + face, middle = line.middle() + face;
  if (door.leaves > 1) {
    add_leaf(drawing, from, middle, side, camera);
    add_leaf(drawing, to, middle, side, camera);
  } else if (door.hinge_at_from) {
    add_leaf(drawing, from, to, side, camera);
  } else {
    add_leaf(drawing, to, from, side, camera);
  }
}

// Lines along the opening at these depths outward from the inner face.
void add_lines_along(Drawing& drawing, const Room& room, const Opening& opening,
                     std::initializer_list<double> depths, const Camera& camera) {
  const Segment line = segment(room, opening);
  const Vec2 outward = -inward(room, opening);
  for (const double depth : depths)
    drawing.strokes.push_back(
        {Drawing::Line::plan_symbol,
         to_pixels({line.a + depth * outward, line.b + depth * outward}, camera)});
}

void add_symbol(Drawing& drawing, const Room& room, const Opening& opening, const Camera& camera) {
  if (opening.type == OpeningType::window)
    add_lines_along(drawing, room, opening, {0.0, 0.5 * wall_thickness, wall_thickness}, camera);
  else if (opening.type == OpeningType::door && opening.swing == DoorSwing::sliding)
    add_lines_along(drawing, room, opening, {0.3 * wall_thickness, 0.7 * wall_thickness}, camera);
  else if (opening.type == OpeningType::door)
    add_door(drawing, room, opening, camera);
}

}  // namespace

Drawing plan_symbols(std::span<const Room> rooms, const Camera& camera) {
  Drawing drawing;
  for (const auto& room : rooms)
    for (const auto& opening : room.openings) {
      // A door between rooms is drawn by the one into which it opens.
      if (!opening.leads_to.empty() && opening.swing == DoorSwing::out) continue;
      add_symbol(drawing, room, opening, camera);
    }
  return drawing;
}

}  // namespace roomgen
