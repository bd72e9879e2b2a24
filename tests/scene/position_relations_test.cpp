#include "support/held.h"

using namespace roomgen;

namespace {

//           back                The desk is 2 m wide and 1 m deep, its centre at (4, 4), its front down.
//        +--------+
//  right |  desk  | left
//        +--------+
//          front
Scene with_desk() {
  return rooms::scene(rooms::box(8, 8), {rooms::thing("desk-0", "thing", {2, 1, 0.75}, {4, 4})});
}

// A cube of 0.4 m with its centre off the desk's by so much.
Object cube(double x, double y, double yaw = 0) {
  return rooms::thing("cube-0", "thing", {0.4, 0.4, 0.4}, {4 + x, 4 + y}, yaw);
}

bool is(const std::string& relation, double x, double y) {
  return held(with_desk(), cube(x, y), relation + ", desk-0");
}

}  // namespace

TEST_CASE("near and far part at a gap of 1.5 m between the footprints") {
  CHECK(is("near", 0, -0.8));
  CHECK(is("near", 0, -(0.5 + 0.2 + 1.5)));
  CHECK_FALSE(is("near", 0, -(0.5 + 0.2 + 1.51)));
  CHECK(is("far", 0, -(0.5 + 0.2 + 1.5)));
  CHECK_FALSE(is("far", 0, -(0.5 + 0.2 + 1.49)));
  CHECK_FALSE(is("far", 0, -0.8));
}

TEST_CASE("next to ends at a gap of 0.5 m") {
  CHECK(is("next to", 0, -0.8));
  CHECK(is("next to", 1 + 0.2 + 0.5, 0));
  CHECK_FALSE(is("next to", 1 + 0.2 + 0.51, 0));
}

TEST_CASE("in front of: beyond the front, at most half the width off the middle") {
  //        +--------+
  //        +--------+
  //      no| yes    |no
  CHECK(is("in front of", 0, -0.6));
  CHECK(is("in front of", 1.0, -2));
  CHECK(is("in front of", -1.0, -2));
  CHECK_FALSE(is("in front of", 1.01, -2));
  CHECK_FALSE(is("in front of", 0, -0.49));
  CHECK_FALSE(is("in front of", 0, 1));
}

TEST_CASE("behind: the same beyond the back") {
  CHECK(is("behind", 0.9, 0.6));
  CHECK_FALSE(is("behind", 1.1, 0.6));
  CHECK_FALSE(is("behind", 0, -1));
}

TEST_CASE("left and right are the target's own, as a person in it would say") {
  CHECK(is("left of", 1.3, 0));
  CHECK(is("left of", 1.3, 0.5));
  CHECK_FALSE(is("left of", 1.3, 0.51));
  CHECK_FALSE(is("left of", -1.3, 0));
  CHECK_FALSE(is("left of", 0.99, 0));
  CHECK(is("right of", -1.3, -0.5));
  CHECK_FALSE(is("right of", -1.3, -0.51));
  CHECK_FALSE(is("right of", 1.3, 0));
}

TEST_CASE("side of: left or right") {
  CHECK(is("side of", 1.3, 0.2));
  CHECK(is("side of", -1.3, 0.2));
  CHECK_FALSE(is("side of", 0, -1));
  CHECK_FALSE(is("side of", 1.3, 0.6));
}

TEST_CASE("around: within 0.6 m and facing the target") {
  //   v         the chairs look at the table
  //  [=] <
  const auto around = [](double gap, double yaw) {
    return held(with_desk(), cube(0, -(0.5 + 0.2 + gap), yaw), "around, desk-0");
  };
  CHECK(around(0.0, 180));
  CHECK(around(0.6, 180));
  CHECK_FALSE(around(0.61, 180));
  CHECK_FALSE(around(0.2, 0));
  CHECK_FALSE(around(0.2, 90));
}

TEST_CASE("aligned: either offset, unless a side constraint with the same target says which") {
  const auto aligned = [](double x, double y, const std::string& with = "") {
    return held(with_desk(), cube(x, y), with + "center aligned, desk-0");
  };
  CHECK(aligned(0.05, -2));
  CHECK(aligned(-2, 0.05));
  CHECK_FALSE(aligned(0.06, -2));
  // Lateral in front of or behind it.
  CHECK(aligned(0.05, -2, "in front of, desk-0 | "));
  CHECK_FALSE(aligned(-2, 0.0, "in front of, desk-0 | "));
  CHECK(aligned(0.0, 2, "behind, desk-0 | "));
  // Longitudinal beside it.
  CHECK(aligned(2, 0.05, "left of, desk-0 | "));
  CHECK_FALSE(aligned(0.0, -2, "side of, desk-0 | "));
  // A side constraint with another target says nothing.
  CHECK(aligned(-2, 0.0, "in front of, wall-0 | "));
}

TEST_CASE("A target that is not there holds nothing") {
  for (const char* relation : {"near", "far", "in front of", "around", "face to", "aligned", "on"})
    CHECK_FALSE(held(with_desk(), cube(0, -1), std::string(relation) + ", piano-9"));
}

TEST_CASE("Round things are judged by their ellipse") {
  //  The corner of the box is nearer than the rim of the disc.
  Scene scene = with_desk();
  scene.objects[0].traits.round = true;
  scene.objects[0].size = {2, 2, 0.7};
  const double diagonal = 1.0 + 1.5 + 0.2 * std::sqrt(2.0);
  const auto at = [&](double distance) {
    const double offset = distance / std::sqrt(2.0);
    return held(scene, cube(offset, offset), "near, desk-0");
  };
  CHECK(at(diagonal - 0.02));
  CHECK_FALSE(at(diagonal + 0.03));  // by its box, the gap would be 0.41 m less
}

TEST_CASE("A pair's preferred gap has the best degree among those that are near") {
  // data/kinds has the distance of a coffee table to its sofa.
  const auto& table = KindTable::built_in();
  const auto& gaps = table.get("coffee table").gaps.empty() ? table.get("sofa").gaps
                                                            : table.get("coffee table").gaps;
  REQUIRE_FALSE(gaps.empty());
  Scene scene = rooms::scene(rooms::box(8, 8), {rooms::thing("sofa-0", "sofa", {2, 1, 0.8}, {4, 6})});
  double best = -1, best_gap = 0;
  for (double gap = 0.0; gap < 1.4; gap += 0.05) {
    const Object coffee = rooms::thing("coffee table-0", "coffee table", {1, 0.6, 0.4}, {4, 5.5 - gap - 0.3});
    const auto judgement = judged(scene, coffee, "near, sofa-0");
    CHECK(judgement.held);
    if (judgement.degree > best) best = judgement.degree, best_gap = gap;
  }
  CHECK(best_gap >= 0.3);
  CHECK(best_gap <= 0.5);
}
