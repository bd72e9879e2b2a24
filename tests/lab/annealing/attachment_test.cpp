// Tracks: where things may be that are put up against walls and sides.

#include "lab/annealing/attachment.h"

#include "base/random.h"
#include "catch.h"

using namespace roomgen;
using namespace roomgen::lab;
using namespace roomgen::lab::annealing;

namespace {

const PutUp against_wall{PutUp::Type::stable_against, {Face::back}, {Face::wall}, 0.05, true};

Polygon room() { return *make_polygon({{0, 0}, {4, 0}, {4, 3}, {0, 3}}); }

Attachment to_wall(int wall) {
  Attachment attachment;
  attachment.child = Face::back, attachment.parent = Face::wall, attachment.wall = wall;
  return attachment;
}

}  // namespace

TEST_CASE("A thing against a wall has its back there and slides along it") {
  for (int wall = 0; wall < 4; ++wall) {
    const auto track = track_along_wall(against_wall, to_wall(wall), {0.5, 0.3}, room());
    REQUIRE(track);
    for (const double share : {0.0, 0.5, 1.0}) {
      const Footprint thing(track->at(track->low + share * (track->high - track->low)), {1.0, 0.6}, track->yaw);
      CHECK(gap(thing, room().edge(static_cast<std::size_t>(wall))) == Approx(0.05));
      CHECK(thing.front().dot(room().inward(static_cast<std::size_t>(wall))) == Approx(1.0));
      CHECK(contains(room(), thing));
    }
  }
  CHECK_FALSE(track_along_wall(against_wall, to_wall(1), {1.6, 0.3}, room()));  // wider than the wall is long
}

TEST_CASE("Two walls leave one corner, a contradiction nothing") {
  const PutUp side{PutUp::Type::stable_against, {Face::left}, {Face::wall}, 0.02, true};
  Attachment beside = to_wall(3);
  beside.child = Face::left;
  const auto one = track_along_wall(against_wall, to_wall(0), {0.5, 0.3}, room());
  const auto two = track_along_wall(side, beside, {0.5, 0.3}, room());
  REQUIRE(one);
  REQUIRE(two);
  const std::vector<Track> both{*one, *two};
  const auto common = common_track(both);
  // At wall 0 its front looks to +y, so that its left side looks to -x, where wall 3 is.
  REQUIRE(common);
  CHECK(common->low == common->high);
  CHECK(common->at(common->low).x() == Approx(0.52));
  CHECK(common->at(common->low).y() == Approx(0.35));
  const std::vector<Track> opposite{*one, *track_along_wall(against_wall, to_wall(2), {0.5, 0.3}, room())};
  CHECK_FALSE(common_track(opposite));
}

TEST_CASE("A chair stands with its front to any side of a table, wherever that is and however turned") {
  const PutUp front_against{PutUp::Type::stable_against, {Face::front}, {Face::front}, 0.05, false};
  Random random(5);
  for (int round = 0; round < 200; ++round) {
    const double x = random.uniform(-3, 3), y = random.uniform(-3, 3), yaw = random.uniform(-3, 3);
    const Footprint table({x, y}, {1.6, 0.9}, yaw);
    Attachment attachment;
    attachment.target = 0, attachment.child = Face::front;
    attachment.parent = std::vector<Face>{Face::front, Face::back, Face::left, Face::right}[static_cast<std::size_t>(round % 4)];
    const auto track = track_along_side(front_against, attachment, {0.22, 0.25}, table);
    REQUIRE(track);
    const Footprint chair(track->at(random.uniform(track->low, track->high)), {0.44, 0.5}, track->yaw);
    CHECK(gap(chair, table) == Approx(0.05).margin(1e-9));
    CHECK(ray_hit(table, chair.center(), chair.front()) > 0.0);
  }
}

TEST_CASE("Backs in one plane") {
  const PutUp coplanar{PutUp::Type::coplanar, {Face::back}, {Face::back}, 0.05, true};
  const Footprint desk({1, 2}, {1.4, 0.7}, 0.4);
  Attachment attachment;
  attachment.target = 0, attachment.child = Face::back, attachment.parent = Face::back;
  const auto track = track_along_side(coplanar, attachment, {0.3, 0.1}, desk);
  REQUIRE(track);
  CHECK(track->yaw == Approx(0.4));
  const Footprint screen(track->at(track->along(desk.center())), {0.6, 0.2}, track->yaw);
  // 5 cm before the desk's back: 0.35 - 0.05 - 0.1 behind its middle.
  CHECK(desk.to_local(screen.center()).y() == Approx(0.2));
  CHECK(desk.to_local(screen.center()).x() == Approx(0.0).margin(1e-9));
}
