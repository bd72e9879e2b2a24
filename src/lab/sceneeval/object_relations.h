#pragma once

#include <span>

#include "thing.h"

/// SceneEval's functions of objects to each other (spatial/spatial_relation.py, version 1.1.1), each in
/// [0, 1]; a relation holds above one half. `target` is what is judged, `anchor` what it is judged
/// against. Where SceneEval draws points by chance these take an even grid of them, and the exact
/// distance where it takes the least of many.
namespace roomgen::lab::sceneeval {

/// Of comparisons of sides: what a computation may be off by.
inline constexpr double exact_margin = 1e-9;  // metres

inline constexpr double satisfied_above = 0.5;

/// 1 within the range of distances, outside a Gaussian of the excess.
double distance_score(double distance, double low, double high, double deviation);

double inside_of(const Thing& target, const Thing& anchor);
double outside_of(const Thing& target, const Thing& anchor);
/// How squarely the target's front looks at what it hits of the anchor; 0 at 30 degrees.
double face_to(const Thing& target, const Thing& anchor);
double side_of(const Thing& target, const Thing& anchor, BoxSide side);
/// In the anchor's box, on that half of it.
double side_region(const Thing& target, const Thing& anchor, BoxSide side);
/// At one of the two long (short) sides; 0 for a square anchor.
double long_short_side_of(const Thing& target, const Thing& anchor, bool long_side);
double on_top(const Thing& target, const Thing& anchor);
double middle_of(const Thing& target, const Thing& anchor);
/// How evenly at least three targets stand about the anchor.
double surround(std::span<const Thing> targets, const Thing& anchor);
double next_to(const Thing& target, const Thing& anchor);
double near(const Thing& target, const Thing& anchor);
double across_from(const Thing& target, const Thing& anchor);
double far(const Thing& target, const Thing& anchor);

/// Between the filled box of the smaller of the two and the other's surface.
double distance_between(const Thing& a, const Thing& b);

}  // namespace roomgen::lab::sceneeval
