#include "catch.h"
#include "library/ranking.h"

using namespace roomgen;

TEST_CASE("Equal boxes are alike, and likeness falls with every axis") {
  const Vec3 want(1.2, 0.6, 0.75);
  CHECK(size_similarity(want, want) == Approx(1.0));
  const double wider = size_similarity({1.4, 0.6, 0.75}, want);
  const double wider_and_higher = size_similarity({1.4, 0.6, 0.9}, want);
  CHECK(wider < 1.0);
  CHECK(wider_and_higher < wider);
}

TEST_CASE("An upright cabinet is no low table") {
  CHECK(size_similarity({0.6, 0.45, 1.9}, {0.6, 0.45, 0.45}) == 0.0);
}

TEST_CASE("The thickness of flat things hardly counts") {
  CHECK(size_similarity({2.0, 1.4, 0.025}, {2.0, 1.4, 0.01}) > 0.95);
}

TEST_CASE("Relevance is the share of the wanted words by weight") {
  CHECK(text_relevance({}) == 1.0);
  CHECK(text_relevance({{3.0, 1.0}, {1.0, 0.0}}) == Approx(0.75));
}

TEST_CASE("The wrong kind, size or mount is no match however good the rest") {
  CHECK(match_score({0.0, 1.0, 1.0, 1.0}) == 0.0);
  CHECK(match_score({1.0, 1.0, 0.0, 1.0}) == 0.0);
  CHECK(match_score({1.0, 1.0, 1.0, 0.0}) == 0.0);
  CHECK(match_score({1.0, 0.0, 1.0, 1.0}) > 0.0);
  CHECK(match_score({1.0, 1.0, 1.0, 1.0}) == 1.0);
}

TEST_CASE("Low things on the floor may stand on something, high ones may not") {
  CHECK(mount_fit(Mount::floor, Mount::surface, {}, 0.4) > 0.0);
  CHECK(mount_fit(Mount::floor, Mount::surface, {}, 1.8) == 0.0);
  CHECK(mount_fit(Mount::wall, Mount::floor, {}, 0.4) == 0.0);
  CHECK(mount_fit(Mount::surface, Mount::wall, {Mount::wall}, 0.6) > 0.0);
}

TEST_CASE("Matches of equal score come in the order of their names") {
  std::vector<AssetMatch> matches(3);
  matches[0].asset.ref.id = "b";
  matches[1].asset.ref.id = "a";
  matches[2].asset.ref.id = "c";
  matches[2].score = 0.9;
  rank(matches, 2);
  REQUIRE(matches.size() == 2);
  CHECK(matches[0].asset.ref.id == "c");
  CHECK(matches[1].asset.ref.id == "a");
}
