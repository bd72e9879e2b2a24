#include "measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomgen::lab::annealing {

namespace {

double apart(double low_a, double high_a, double low_b, double high_b) {
  return std::max({0.0, low_b - high_a, low_a - high_b});
}

// Of the outline edge of a footprint that belongs to the face; the corners run +x+y, -x+y, -x-y, +x-y.
Segment side_of(const Footprint& footprint, Face face) {
  const Vec2& half = footprint.half();
  const auto at = [&](double x, double y) { return footprint.to_world({x * half.x(), y * half.y()}); };
  switch (face) {
    case Face::front: return {at(-1, -1), at(1, -1)};
    case Face::back: return {at(1, 1), at(-1, 1)};
    case Face::left: return {at(1, -1), at(1, 1)};
    default: return {at(-1, 1), at(-1, -1)};
  }
}

double alignment_cost(const Vec2& front, const Vec2& normal) { return 0.5 * (1.0 - std::abs(front.dot(normal))); }

}  // namespace

double distance(const Body& a, const Body& b) {
  const double rise = apart(a.bottom, a.top, b.bottom, b.top);
  const double way = gap(a.footprint, b.footprint);
  return rise == 0.0 ? way : std::hypot(way, rise);
}

double distance_to_room(const Body& body, Face face, const Room& room) {
  if (face == Face::floor) return std::max(0.0, body.bottom);
  if (face == Face::ceiling) return std::max(0.0, room.height - body.top);
  return distance_to_boundary(room.polygon, body.footprint);
}

double distance_to_face(const Body& a, const Body& b, Face face) {
  if (face == Face::top || face == Face::support)
    return std::hypot(gap(a.footprint, b.footprint), std::max(0.0, a.bottom - b.top));
  if (face == Face::bottom) return std::hypot(gap(a.footprint, b.footprint), std::max(0.0, b.bottom - a.top));
  return std::hypot(gap(a.footprint, side_of(b.footprint, face)), apart(a.bottom, a.top, b.bottom, b.top));
}

Body access_space(const Body& a, Face face, double depth) {
  const Footprint& own = a.footprint;
  const Vec2 half = own.half();
  const auto beside = [&](const Vec2& local, const Vec2& size) {
    return Body{Footprint(own.to_world(local), size, own.yaw()), a.bottom, a.top};
  };
  switch (face) {
    case Face::back: return beside({0, half.y() + 0.5 * depth}, {2 * half.x(), depth});
    case Face::left: return beside({half.x() + 0.5 * depth, 0}, {depth, 2 * half.y()});
    case Face::right: return beside({-half.x() - 0.5 * depth, 0}, {depth, 2 * half.y()});
    case Face::top: return {own, a.top, a.top + depth};
    case Face::bottom: return {own, a.bottom - depth, a.bottom};
    default: return beside({0, -half.y() - 0.5 * depth}, {2 * half.x(), depth});
  }
}

double penetration(const Body& a, const Body& b) {
  if (a.bottom >= b.top || b.bottom >= a.top) return 0.0;
  const Footprint &p = a.footprint, &q = b.footprint;
  if (!p.bounds().overlaps(q.bounds())) return 0.0;
  const Vec2 between = q.center() - p.center();
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& axis : {p.x_axis(), p.y_axis(), q.x_axis(), q.y_axis()}) {
    const double depth = reach_along(p, axis) + reach_along(q, axis) - std::abs(between.dot(axis));
    if (depth <= 0.0) return 0.0;
    least = std::min(least, depth);
  }
  return least;
}

double misalignment(const Footprint& a, const Footprint& b) {
  const Vec2 local = b.to_local(a.center());
  const Vec2 outside = local.cwiseAbs() - b.half();
  // The side that the centre lies beyond most.
  return alignment_cost(a.front(), outside.x() > outside.y() ? b.x_axis() : b.y_axis());
}

double misalignment_to_walls(const Footprint& a, const Polygon& room) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < room.size(); ++k)
    if (const double way = distance(room.edge(k), a.center()); way < least) least = way, nearest = k;
  return alignment_cost(a.front(), room.inward(nearest));
}

double unfocused(const Footprint& a, const Vec2& target) {
  const Vec2 to = target - a.center();
  const double length = to.norm();
  return length < 1e-9 ? 0.0 : 0.5 * (1.0 - a.front().dot(to) / length);
}

double reflection_asymmetry(std::span<const Footprint> things, const Footprint& about) {
  const int n = static_cast<int>(things.size());
  if (n < 2) return 0.0;
  const Vec2 normal = about.half().x() >= about.half().y() ? about.y_axis() : about.x_axis();
  std::vector<double> costs(static_cast<std::size_t>(n) * n);
  double between = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Footprint &a = things[static_cast<std::size_t>(i)], &b = things[static_cast<std::size_t>(j)];
      const Vec2 image = a.center() - 2.0 * normal * normal.dot(a.center() - about.center());
      const Vec2 front = a.front() - 2.0 * normal * normal.dot(a.front());
      const double turn = std::acos(std::clamp(front.dot(b.front()), -1.0, 1.0)) / pi;
      costs[static_cast<std::size_t>(i * n + j)] = (image - b.center()).norm() + turn;
      between += (a.center() - b.center()).norm();
    }
  const auto match = cheapest_matching(costs, n);
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += costs[static_cast<std::size_t>(i * n + match[static_cast<std::size_t>(i)])];
  const double mean_between = std::max(1e-6, between / (n * (n - 1)));
  return 1.0 - 1.0 / (1.0 + sum / n / mean_between);
}

double rotation_asymmetry(std::span<const Footprint> things) {
  const std::size_t n = things.size();
  if (n < 2) return 0.0;
  Vec2 middle = Vec2::Zero();
  for (const auto& thing : things) middle += thing.center() / static_cast<double>(n);
  struct Spoke {
    double angle, radius, heading;
  };
  std::vector<Spoke> spokes;
  double mean = 0.0;
  for (const auto& thing : things) {
    const Vec2 out = thing.center() - middle;
    spokes.push_back({std::atan2(out.y(), out.x()), out.norm(), thing.yaw()});
    mean += out.norm() / static_cast<double>(n);
  }
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) { return a.angle < b.angle; });
  double radius = 0.0, angle = 0.0, heading = 0.0;
  const double step = 2.0 * pi / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Spoke &a = spokes[i], &b = spokes[(i + 1) % n];
    radius += std::abs(a.radius - mean) / std::max(1e-6, mean);
    angle += std::abs(wrap_angle(b.angle - a.angle - step)) / pi;
    heading += std::abs(wrap_angle(b.heading - a.heading - step)) / pi;
  }
  return (radius + angle + heading) / (3.0 * static_cast<double>(n));
}

double uncoplanarity(std::span<const Footprint> things) {
  if (things.size() < 2) return 0.0;
  Bounds2 box;
  for (const auto& thing : things) box.add(thing.center());
  const int along = box.size().x() >= box.size().y() ? 0 : 1;
  std::vector<const Footprint*> row;
  for (const auto& thing : things) row.push_back(&thing);
  std::sort(row.begin(), row.end(),
            [&](const auto* a, const auto* b) { return a->center()[along] < b->center()[along]; });
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    const Footprint &a = *row[i], &b = *row[i + 1];
    const auto plane = [&](const Footprint& f, double side) {
      return (f.center() + side * f.half().y() * f.front()).dot(a.front());
    };
    const double fronts = std::abs(plane(a, 1) - plane(b, 1)), backs = std::abs(plane(a, -1) - plane(b, -1));
    sum += 0.5 * (1.0 - a.front().dot(b.front())) + std::min(fronts, backs);
  }
  return sum / static_cast<double>(row.size() - 1);
}

double shared_area(const Footprint& a, const Footprint& b) {
  if (!a.bounds().overlaps(b.bounds())) return 0.0;
  // Clipping of one convex outline by the edges of the other (Sutherland and Hodgman 1974).
  std::vector<Vec2> shape(a.outline().begin(), a.outline().end()), next;
  const auto edges = b.outline();
  for (std::size_t k = 0; k < edges.size() && !shape.empty(); ++k) {
    const Vec2 start = edges[k], along = edges[(k + 1) % edges.size()] - start;
    next.clear();
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const Vec2 &p = shape[i], &q = shape[(i + 1) % shape.size()];
      const double in_p = cross(along, p - start), in_q = cross(along, q - start);
      if (in_p >= 0) next.push_back(p);
      if ((in_p > 0 && in_q < 0) || (in_p < 0 && in_q > 0)) next.push_back(p + (q - p) * (in_p / (in_p - in_q)));
    }
    shape.swap(next);
  }
  return shape.size() < 3 ? 0.0 : signed_area(shape);
}

std::vector<int> cheapest_matching(const std::vector<double>& costs, int n) {
  // Shortest augmenting paths with potentials; row and column 0 are sentinels.
  const auto size = static_cast<std::size_t>(n) + 1;
  std::vector<double> row_potential(size), column_potential(size);
  std::vector<std::size_t> row_of(size, 0), previous(size, 0);
  for (std::size_t row = 1; row < size; ++row) {
    row_of[0] = row;
    std::size_t column = 0;
    std::vector<double> least(size, std::numeric_limits<double>::infinity());
    std::vector<bool> seen(size, false);
    do {
      seen[column] = true;
      const std::size_t at = row_of[column];
      double delta = std::numeric_limits<double>::infinity();
      std::size_t best = 0;
      for (std::size_t j = 1; j < size; ++j) {
        if (seen[j]) continue;
        const double reduced = costs[(at - 1) * (size - 1) + j - 1] - row_potential[at] - column_potential[j];
        if (reduced < least[j]) least[j] = reduced, previous[j] = column;
        if (least[j] < delta) delta = least[j], best = j;
      }
      for (std::size_t j = 0; j < size; ++j)
        if (seen[j])
          row_potential[row_of[j]] += delta, column_potential[j] -= delta;
        else
          least[j] -= delta;
      column = best;
    } while (row_of[column] != 0);
    for (; column != 0; column = previous[column]) row_of[column] = row_of[previous[column]];
  }
  std::vector<int> match(static_cast<std::size_t>(n));
  for (std::size_t j = 1; j < size; ++j) match[row_of[j] - 1] = static_cast<int>(j) - 1;
  return match;
}

}  // namespace roomgen::lab::annealing
