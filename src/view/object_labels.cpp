#include "object_labels.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace roomgen::detail {

namespace {

constexpr double arrow_overhang = 0.10;  ///< metres beyond the front edge
constexpr double longest_tail = 0.5;     ///< metres within it
constexpr int label_directions = 16;
constexpr double ring_step = 0.5;  ///< in heights of a label

// A rug without a front still has one axis along which things are beside it; a plant has none.
bool has_direction(const Object& object) {
  constexpr double square = 1.1;
  if (object.traits.front) return true;
  if (object.traits.round || object.mount != Mount::floor) return false;
  const Vec2 size = object.size.head<2>();
  if (size.maxCoeff() < square * size.minCoeff()) return false;
  const auto& kinds = KindTable::built_in();
  return object.traits.flat ||
         (!kinds.get(object.category).zones.empty() && !kinds.is_a(object.category, "table"));
}

double distance_to_box(const Vec2& point, const Vec2& center, const Vec2& size) {
  return ((point - center).cwiseAbs() - 0.5 * size).cwiseMax(0.0).norm();
}

bool box_covers_arrow(const ObjectMark& mark, const Vec2& center, const Vec2& size) {
  // The outer half of the arrow is what must stay readable.
  for (const double t : {0.6, 0.8, 1.0}) {
    const Vec2 point = mark.arrow_start + t * (mark.arrow_end - mark.arrow_start);
    if (distance_to_box(point, center, size) <= 0.0) return true;
  }
  return false;
}

// Would nothing worth mentioning of the thing be seen beside a label there?
bool hides(const ObjectMark& mark, const Vec2& center, const Vec2& size) {
  Bounds2 box;
  for (const auto& corner : mark.outline) box.add(corner);
  const Vec2 low = box.low.cwiseMax(center - 0.5 * size), high = box.high.cwiseMin(center + 0.5 * size);
  const Vec2 shared = (high - low).cwiseMax(0.0), whole = box.size();
  return shared.x() * shared.y() > 0.5 * whole.x() * whole.y();
}

// Lower is better; in pixels, roughly.
double cost(const std::vector<ObjectMark>& marks, std::size_t own, const Vec2& center,
            const Vec2& size) {
  double total = (center - marks[own].center).norm();
  if (hides(marks[own], center, size))
    total += 2.5 * size.y();  // beside it, with a leader
  else if (!contains(marks[own], center))
    total += 1.5 * size.y();
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const bool has_front = marks[i].arrow_end != marks[i].arrow_start;
    if (has_front && box_covers_arrow(marks[i], center, size)) total += i == own ? 45.0 : 60.0;
    if (i == own) continue;
    if (distance_to_box(marks[i].center, center, size) <= 0.0)
      total += (hides(marks[i], center, size) ? 4.0 : 2.0) * size.y();
    if (contains(marks[i], center) && !contains(marks[own], center)) total += 1.5 * size.y();
  }
  return total;
}

struct Spot {
  Vec2 center = Vec2::Zero();
  double cost = std::numeric_limits<double>::max();
  bool found() const { return cost < std::numeric_limits<double>::max(); }
};

// Rings around the object, outward, until no farther spot can be cheaper.
Spot best_spot(const std::vector<ObjectMark>& marks, std::size_t own, const Vec2& size,
               const LabelPlacer& placer, double reach) {
  Spot best;
  const double step = ring_step * size.y();
  for (double radius = 0.0; radius < reach && radius < best.cost; radius += step)
    for (int i = 0; i < (radius > 0.0 ? label_directions : 1); ++i) {
      // Labels are wide: stretch the rings so that a step to the side clears as much as one up.
      const Vec2 direction = rotated(Vec2(0, 1), 2.0 * pi * i / label_directions);
      const Vec2 center = marks[own].center + radius * Vec2(direction.x() * 1.6, direction.y());
      if (!placer.fits(center, size)) continue;
      const double c = cost(marks, own, center, size);
      if (c < best.cost) best = {center, c};
    }
  return best;
}

}  // namespace

ObjectMark object_mark(const Object& object, const Camera& camera) {
  const auto pixel = [&](const Vec2& p) { return camera.pixel({p.x(), p.y(), top(object)}); };
  ObjectMark mark;
  mark.id = mark.text = object.id;
  const Footprint area = footprint(object);
  for (const auto& corner : area.outline()) mark.outline.push_back(pixel(corner));
  mark.center = pixel(area.center());
  mark.arrow_end = mark.arrow_start = mark.center;
  if (!has_direction(object)) return mark;
  const double edge = area.half().y();
  mark.arrow_start = pixel(area.center() + std::max(0.0, edge - longest_tail) * area.front());
  mark.arrow_end = pixel(area.center() + (edge + arrow_overhang) * area.front());
  return mark;
}

bool contains(const ObjectMark& mark, const Vec2& pixel) {
  const auto& corners = mark.outline;  // convex
  int left = 0, right = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 edge = corners[(i + 1) % corners.size()] - corners[i];
    (cross(edge, pixel - corners[i]) < 0 ? right : left) += 1;
  }
  return left == 0 || right == 0;
}

bool place_object_labels(const std::vector<ObjectMark>& marks, double letter_height,
                         LabelPlacer& placer, std::vector<Drawing::Stroke>& leaders) {
  // Small things first: a label on a bed can go anywhere on the bed, that of a lamp cannot.
  std::vector<std::size_t> order(marks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto extent = [&](std::size_t i) { return std::abs(signed_area(marks[i].outline)); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return extent(a) < extent(b); });

  const double reach = 30.0 * letter_height;
  for (const auto i : order) {
    if (marks[i].text.empty()) continue;
    const Vec2 size = label_size(marks[i].text, letter_height);
    const Spot spot = best_spot(marks, i, size, placer, reach);
    if (!spot.found()) return false;
    const bool red =
        marks[i].look == Drawing::Line::refused || marks[i].look == Drawing::Line::in_the_way;
    placer.place(
        {red ? Drawing::Text::red : Drawing::Text::object, marks[i].text, spot.center, size});
    if (contains(marks[i], spot.center)) continue;
    const Vec2 near =
        marks[i].center.cwiseMax(spot.center - 0.5 * size).cwiseMin(spot.center + 0.5 * size);
    leaders.push_back({Drawing::Line::leader, {near, marks[i].center}});
  }
  return true;
}

}  // namespace roomgen::detail
