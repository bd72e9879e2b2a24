#include "outline.h"

#include <algorithm>
#include <cmath>

namespace roomgen::brief {

namespace {

// Parts of a wall that a feature leaves at either end.
constexpr double cut_share = 0.45;

// A corner, and what is known of the wall that begins there.
struct Corner {
  Vec2 point = Vec2::Zero();
  bool own = true;      ///< of the outline rather than of a feature
  bool glazed = false;
};
using Ring = std::vector<Corner>;

double number(const shape::Expression& formula, const shape::Scope& scope) {
  // Formulas of data are checked by tests; one that has no value leaves a corner at the origin.
  const auto value = formula.number(scope);
  return value ? *value : 0.0;
}

Vec2 point(const FormulaPoint& formulas, const shape::Scope& scope) {
  return {number(formulas[0], scope), number(formulas[1], scope)};
}

Bounds2 box_around(const Ring& ring) {
  Bounds2 box;
  for (const auto& corner : ring) box.add(corner.point);
  return box;
}

std::vector<Vec2> points_of(const Ring& ring) {
  std::vector<Vec2> points;
  for (const auto& corner : ring) points.push_back(corner.point);
  return points;
}

Ring regular(int sides, const std::vector<int>& without) {
  Ring ring;
  for (int k = 0; k < sides; ++k) {
    if (std::find(without.begin(), without.end(), k) != without.end()) continue;
    // A wall, not a corner, lies in front.
    const double angle = -0.5 * pi + 2.0 * pi * (k + 0.5) / sides;
    ring.push_back({Vec2(std::cos(angle), std::sin(angle))});
  }
  return ring;
}

// In a box from the origin, one metre or less wide and deep.
Ring base_ring(const OutlineKind& kind, Random& random) {
  if (kind.sides > 0) {
    Ring ring = regular(kind.sides, kind.without);
    const Bounds2 box = box_around(ring);
    for (auto& corner : ring) corner.point = (corner.point - box.low) / box.size().maxCoeff();
    return ring;
  }
  const shape::Scope scope = drawn(kind.draws, random);
  Ring ring;
  for (const auto& formulas : kind.corners) ring.push_back({point(formulas, scope)});
  return ring;
}

// Left and right change places, so the corners run the other way.
void mirror(Ring& ring, int axis) {
  const Bounds2 box = box_around(ring);
  for (auto& corner : ring)
    corner.point[axis] = box.low[axis] + box.high[axis] - corner.point[axis];
  std::reverse(ring.begin(), ring.end());
}

void scale(Ring& ring, const Vec2& factor) {
  for (auto& corner : ring) corner.point = corner.point.cwiseProduct(factor);
}

void move_to_origin(Ring& ring) {
  const Vec2 low = box_around(ring).low;
  for (auto& corner : ring) corner.point -= low;
}

class FeatureMaker {
 public:
  FeatureMaker(const FeatureKind& kind, Random& random)
      : kind_(kind), scope_(drawn(kind.draws, random)) {}

  /// Changes one wall or corner that is long enough; false if none is.
  bool add(Ring& ring, Random& random) {
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < ring.size(); ++k)
      if (kind_.cut.empty() ? takes(ring, k) : takes_cut(ring, k)) places.push_back(k);
    if (places.empty()) return false;
    const std::size_t place = random.pick(places);
    kind_.cut.empty() ? break_wall(ring, place) : cut_corner(ring, place);
    return true;
  }

 private:
  static Segment wall(const Ring& ring, std::size_t k) {
    return {ring[k].point, ring[(k + 1) % ring.size()].point};
  }

  bool takes(const Ring& ring, std::size_t k) const {
    return ring[k].own && wall(ring, k).length() >= kind_.least;
  }

  bool takes_cut(const Ring& ring, std::size_t k) const {
    const std::size_t before = (k + ring.size() - 1) % ring.size();
    const Vec2 in = wall(ring, before).direction(), out = wall(ring, k).direction();
    return takes(ring, k) && takes(ring, before) && cross(in, out) > 0.5;
  }

  void break_wall(Ring& ring, std::size_t k) {
    const Segment line = wall(ring, k);
    const Vec2 along = line.direction(), outward = -left_of(along);
    scope_.values["m"] = 0.5 * line.length();
    Ring more;
    for (std::size_t i = 0; i < kind_.along.size(); ++i) {
      const Vec2 local = point(kind_.along[i], scope_);
      const bool last = i + 1 == kind_.along.size();
      more.push_back({line.a + local.x() * along + local.y() * outward, last,
                      std::find(kind_.glazed.begin(), kind_.glazed.end(), i) != kind_.glazed.end()});
    }
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k) + 1, more.begin(), more.end());
  }

  void cut_corner(Ring& ring, std::size_t k) {
    const std::size_t before = (k + ring.size() - 1) % ring.size();
    const Segment in = wall(ring, before), out = wall(ring, k);
    const double a = std::min(number(kind_.cut[0], scope_), cut_share * in.length());
    const double b = std::min(number(kind_.cut[1], scope_), cut_share * out.length());
    const Corner behind{out.a + b * out.direction(), true, false};
    ring[k] = {out.a - a * in.direction(), false, false};
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k) + 1, behind);
  }

  const FeatureKind& kind_;
  shape::Scope scope_;
};

// The sides of the base whose box or area comes to what is wanted.
Ring sized_base(const OutlineKind& kind, const OutlineSize& size, Random& random) {
  Ring ring = base_ring(kind, random);
  const Vec2 unit = box_around(ring).size();
  // A regular polygon keeps its proportions unless the sides of its box are given.
  const double side = std::sqrt(size.box.prod());
  scale(ring, size.area && kind.sides > 0 ? Vec2(Vec2::Constant(side)) : Vec2(size.box.cwiseQuotient(unit)));
  return ring;
}

void fit(Ring& ring, const OutlineSize& size) {
  if (size.area)
    scale(ring, Vec2::Constant(std::sqrt(*size.area / std::abs(signed_area(points_of(ring))))));
  else
    scale(ring, size.box.cwiseQuotient(box_around(ring).size()));
  move_to_origin(ring);
}

OutlineKind unit_square() {
  OutlineKind kind;
  for (const auto& [x, y] : {std::pair("0", "0"), {"1", "0"}, {"1", "1"}, {"0", "1"}})
    kind.corners.push_back({*shape::Expression::compile(x), *shape::Expression::compile(y)});
  return kind;
}

std::vector<std::size_t> glazed_walls(const Ring& ring, const Polygon& polygon) {
  std::vector<std::size_t> walls;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!ring[i].glazed) continue;
    const Vec2 middle = 0.5 * (ring[i].point + ring[(i + 1) % ring.size()].point);
    for (std::size_t k = 0; k < polygon.size(); ++k)
      if (distance(polygon.edge(k), middle) < 1e-6) walls.push_back(k);
  }
  return walls;
}

}  // namespace

Outline make_outline(const SaidShape& said, const FloorShapes& shapes, const OutlineSize& size,
                     Random random) {
  Outline outline;
  const auto known = shapes.outlines.find(said.outline);
  const OutlineKind kind = known == shapes.outlines.end() ? unit_square() : known->second;
  OutlineSize wanted = size;
  Ring ring = sized_base(kind, wanted, random);
  for (int axis : {0, 1})
    if (random.chance(0.5)) mirror(ring, axis);
  // Features are in metres: the outline has its size before they are added.
  fit(ring, wanted);
  for (const auto& name : said.features) {
    const auto feature = shapes.features.find(name);
    if (feature == shapes.features.end()) continue;
    if (!FeatureMaker(feature->second, random).add(ring, random)) outline.missing.push_back(name);
  }
  fit(ring, wanted);
  auto polygon = make_polygon(points_of(ring));
  if (!polygon) {
    outline = rectangle_of(size.box);
    outline.missing = said.features;
    return outline;
  }
  outline.polygon = *std::move(polygon);
  outline.glazed = glazed_walls(ring, outline.polygon);
  return outline;
}

Outline rectangle_of(const Vec2& size) {
  Outline outline;
  outline.polygon.points = {{0, 0}, {size.x(), 0}, size, {0, size.y()}};
  return outline;
}

Vec2 box_of(double area, double ratio, bool wide) {
  const double shorter = std::sqrt(area / ratio);
  return wide ? Vec2(shorter * ratio, shorter) : Vec2(shorter, shorter * ratio);
}

}  // namespace roomgen::brief
