// Overlap and gap of pairs against points sampled in what the footprints really cover.
#include "catch.h"
#include "roomgen/geometry/polygon.h"
#include "support/shapes.h"

using namespace roomgen;

namespace {

constexpr int pairs = 2000;

// Round things count as 24-sided polygons around the ellipse: 1 / cos(7.5 degrees) wider at the corners.
double slack_of(const Footprint& f) {
  return f.round() ? 0.009 * f.half().maxCoeff() : 0.0;
}

bool covers(const Footprint& f, const Vec2& p) {
  const double c = std::cos(f.yaw()), s = std::sin(f.yaw());
  const Vec2 d = p - f.center();
  const Vec2 local(c * d.x() + s * d.y(), c * d.y() - s * d.x());
  const Vec2 unit = local.cwiseQuotient(f.half());
  return f.round() ? unit.squaredNorm() < 1.0 : unit.cwiseAbs().maxCoeff() < 1.0;
}

double nearest(const std::vector<Vec2>& from, const std::vector<Vec2>& to) {
  double best = 1e300;
  for (const auto& a : from)
    for (const auto& b : to) best = std::min(best, (a - b).squaredNorm());
  return std::sqrt(best);
}

struct Pair {
  Footprint a, b;
};

Pair random_pair(Random& random, int number) {
  const Footprint a = shapes::random_footprint(random, number % 4 == 1 || number % 4 == 3);
  return {a, shapes::random_footprint(random, number % 4 >= 2)};
}

}  // namespace

TEST_CASE("Footprints overlap if a sampled point is in both") {
  Random random(1);
  int overlapping = 0;
  for (int i = 0; i < pairs; ++i) {
    const auto [a, b] = random_pair(random, i);
    const auto points = shapes::sample(a, 12, 48);
    const bool shared = std::any_of(points.begin(), points.end(),
                                    [&](const Vec2& p) { return covers(b, p) && covers(a, p); });
    INFO("pair " << i);
    if (shared) REQUIRE(overlaps(a, b));
    overlapping += shared ? 1 : 0;
  }
  CHECK(overlapping > pairs / 4);
  CHECK(overlapping < 3 * pairs / 4);
}

TEST_CASE("Footprints that overlap by a band really share points") {
  Random random(2);
  for (int i = 0; i < pairs; ++i) {
    const auto [a, b] = random_pair(random, i);
    // Everything within the band of slack may be outside the ellipses.
    const double band = 0.02 + slack_of(a) + slack_of(b);
    if (!overlaps(a, b, band)) continue;
    const auto points = shapes::sample(a, 40, 160);
    INFO("pair " << i);
    REQUIRE(std::any_of(points.begin(), points.end(), [&](const Vec2& p) { return covers(b, p); }));
  }
}

TEST_CASE("The gap is the distance of the nearest sampled points") {
  Random random(3);
  for (int i = 0; i < pairs; ++i) {
    const auto [a, b] = random_pair(random, i);
    const double found = gap(a, b);
    const double sampled = nearest(shapes::sample(a, 1, 160), shapes::sample(b, 1, 160));
    const double step = (4.0 * (a.half().maxCoeff() + b.half().maxCoeff())) / 40.0;
    INFO("pair " << i << " found " << found << " sampled " << sampled);
    if (overlaps(a, b, 0.0)) {
      REQUIRE(found == 0.0);
      continue;
    }
    REQUIRE(found <= sampled + 1e-9);
    REQUIRE(found >= sampled - step * step / (8.0 * std::max(sampled, 0.01)) - slack_of(a) -
                         slack_of(b) - 0.005);
  }
}

TEST_CASE("Overlap and gap do not depend on the order, and agree with each other") {
  Random random(4);
  for (int i = 0; i < pairs; ++i) {
    const auto [a, b] = random_pair(random, i);
    INFO("pair " << i);
    REQUIRE(overlaps(a, b) == overlaps(b, a));
    REQUIRE(gap(a, b) == Approx(gap(b, a)).margin(1e-9));
    REQUIRE((gap(a, b) > 1e-6) <= !overlaps(a, b));
  }
}

TEST_CASE("Overlap and gap do not change when both are moved and turned together") {
  Random random(5);
  for (int i = 0; i < pairs; ++i) {
    const auto [a, b] = random_pair(random, i);
    const double turn = random.uniform(-pi, pi);
    const Vec2 shift = shapes::random_point(random, -5, 5);
    const auto moved = [&](const Footprint& f) {
      return Footprint(rotated(f.center(), turn) + shift, 2.0 * f.half(), f.yaw() + turn, f.round());
    };
    INFO("pair " << i);
    const double distance = gap(a, b);
    REQUIRE(gap(moved(a), moved(b)) == Approx(distance).margin(1e-9));
    if (distance > 1e-6 || overlaps(a, b, 1e-5))
      REQUIRE(overlaps(moved(a), moved(b)) == overlaps(a, b));
  }
}

TEST_CASE("Things that touch do not overlap, and things moved into each other by 1 mm do") {
  //  +----++----+
  //  | a  || b  |   for many yaws
  //  +----++----+
  for (int degree = 0; degree < 360; degree += 7) {
    const double yaw = radians(degree);
    const Footprint a({1, 2}, {1, 0.5}, yaw);
    const auto beside = [&](double x) { return Footprint(a.to_world({x, 0.1}), {0.6, 0.4}, yaw); };
    INFO("yaw " << degree);
    CHECK_FALSE(overlaps(a, beside(0.8)));
    CHECK(gap(a, beside(0.8)) == Approx(0.0).margin(1e-9));
    CHECK(overlaps(a, beside(0.799)));
    CHECK_FALSE(overlaps(a, beside(0.799), 0.002));
    CHECK(gap(a, beside(1.0)) == Approx(0.2));
  }
}
