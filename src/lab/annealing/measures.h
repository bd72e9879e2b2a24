#pragma once

#include <span>
#include <vector>

#include "roomgen/geometry/polygon.h"
#include "roomgen/lab/program.h"
#include "roomgen/scene/room.h"

namespace roomgen::lab::annealing {

// The costs of constraint programs (Infinigen Indoors, Raistrick et al. 2024, and the supplement of
// InfiniBench, section A), each a plain function of where things are. Metres, radians.

/// What a thing, a door or a window fills: its footprint between two heights.
struct Body {
  Footprint footprint;
  double bottom = 0.0;
  double top = 0.0;
};

/// dist: how far two bodies are apart, through the air; 0 when they touch.
double distance(const Body& a, const Body& b);
/// dist to a face of the room: of the footprint to the nearest wall, of the bottom to the floor, of the top
/// to the ceiling.
double distance_to_room(const Body& body, Face face, const Room& room);
/// dist to a face of a thing: of the nearest corner of the footprint of `a` to that side of `b`.
double distance_to_face(const Body& a, const Body& b, Face face);

/// access: the free space that `a` needs, a box of `depth` before one of its faces (front, back, left, right, top,
/// bottom), as wide and high as the thing; how deep `b` reaches into it, metres, 0 if it does not.
Body access_space(const Body& a, Face face, double depth);
/// The least distance by which one of two bodies had to move sideways to be clear of the other; 0 when they are.
double penetration(const Body& a, const Body& b);

/// angle: how far the front of `a` is from looking along or against the outward normal of the side of `b` that
/// is nearest: (1 - |f n|) / 2, so 0 when they are aligned, 0.5 at a right angle.
double misalignment(const Footprint& a, const Footprint& b);
double misalignment_to_walls(const Footprint& a, const Polygon& room);

/// focus: (1 - f u) / 2 with u from a to b's centre: 0 when a looks at b, 1 when it looks away.
double unfocused(const Footprint& a, const Vec2& target);

/// reflect: how far the things are from being mirror images of each other across the longer middle plane of
/// `about`: 1 - 1 / (1 + d), d the mean deviation (metres, and half turns) of the best matching of mirror images
/// to things over the mean distance between them; 0 for fewer than two.
double reflection_asymmetry(std::span<const Footprint> things, const Footprint& about);
/// rotasym: how far n things are from an n-fold rotation about their centre: the mean of |r - mean r| / mean r, of
/// the deviation of the angles between neighbours from 2 pi / n, and of their headings, which should turn along; both in
/// half turns. 0 for fewer than two.
double rotation_asymmetry(std::span<const Footprint> things);
/// coplanar: between neighbours along the longest extent of the group, (1 - f g) / 2 of their fronts plus the least
/// of the distances (metres) between the planes of their fronts and of their backs; the mean. 0 for fewer than two.
double uncoplanarity(std::span<const Footprint> things);

/// The floor that both cover, m2.
double shared_area(const Footprint& a, const Footprint& b);

/// The least sum of costs of a matching of rows to columns (a square matrix, row by row), and which column each
/// row takes (Kuhn 1955, Munkres 1957; O(n^3)).
std::vector<int> cheapest_matching(const std::vector<double>& costs, int n);

}  // namespace roomgen::lab::annealing
