#include "solve/fuse.h"

#include <set>

#include "base/random.h"
#include "catch.h"

using namespace roomgen;

namespace {

std::vector<Ranked> random_candidates(Random& random, int count) {
  std::vector<Ranked> candidates;
  for (int i = 0; i < count; ++i) {
    Ranked r;
    // Some share a place, as poses of several yaws do.
    if (i > 0 && random.chance(0.4)) r.position = random.pick(candidates).position;
    else r.position = {random.uniform(-3, 3), random.uniform(-3, 3)};
    r.lost = random.integer(0, 3);
    r.degree = random.uniform();
    candidates.push_back(r);
  }
  return candidates;
}

int least_lost(const std::vector<Ranked>& candidates) {
  int least = 99;
  for (const auto& r : candidates) least = std::min(least, r.lost);
  return least;
}

// The definition, cell by cell.
int rank_by_counting(const std::vector<Ranked>& candidates, const Ranked& one, const Vec2& location) {
  std::set<std::pair<long, long>> cells;
  for (const auto& r : candidates)
    cells.insert({std::lround(std::floor(r.position.x() / 0.2)),
                  std::lround(std::floor(r.position.y() / 0.2))});
  int nearer = 0;
  for (const auto& [i, j] : cells) {
    const Vec2 center(0.2 * (double(i) + 0.5), 0.2 * (double(j) + 0.5));
    nearer += (center - location).norm() < (one.position - location).norm() - 0.1 ? 1 : 0;
  }
  return 1 + nearer;
}

}  // namespace

TEST_CASE("Each constraint lost against the best candidate costs the same number of ranks") {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    auto candidates = random_candidates(random, random.integer(1, 60));
    FusionOptions options;
    options.lost_step = random.integer(1, 300);
    fuse(candidates, std::nullopt, options);
    for (const auto& r : candidates)
      REQUIRE(r.rank_c == 1 + options.lost_step * (r.lost - least_lost(candidates)));
  }
}

TEST_CASE("The rank by location is the number of occupied cells that are nearer, and one") {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    auto candidates = random_candidates(random, random.integer(1, 120));
    const Vec2 location(random.uniform(-4, 4), random.uniform(-4, 4));
    fuse(candidates, location, {});
    for (const auto& r : candidates) REQUIRE(r.rank_l == rank_by_counting(candidates, r, location));
  }
}

TEST_CASE("The fused score is the weighted sum of reciprocal ranks") {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    auto candidates = random_candidates(random, 40);
    FusionOptions options;
    options.alpha = random.uniform();
    options.c = random.uniform(1, 100);
    const bool suggested = random.chance(0.5);
    fuse(candidates, suggested ? std::optional<Vec2>({0.3, -0.7}) : std::nullopt, options);
    for (const auto& r : candidates) {
      const double by_constraints = options.alpha / (r.rank_c + options.c);
      const double by_location = suggested ? (1 - options.alpha) / (r.rank_l + options.c) : 0.0;
      REQUIRE(r.fused == Approx(by_constraints + by_location).epsilon(1e-12));
    }
  }
}

TEST_CASE("Further yaws at the same place change nobody's rank") {
  Random random(4);
  auto few = random_candidates(random, 80);
  auto many = few;
  for (const auto& r : few) many.insert(many.end(), 5, r);
  fuse(few, Vec2(0, 0), {});
  fuse(many, Vec2(0, 0), {});
  for (std::size_t i = 0; i < few.size(); ++i) {
    REQUIRE(many[i].rank_c == few[i].rank_c);
    REQUIRE(many[i].rank_l == few[i].rank_l);
  }
}

TEST_CASE("The paper's ranks count all candidates, first come first in ties") {
  Random random(5);
  FusionOptions options;
  options.ordinal_ranks = true;
  for (int i = 0; i < 50; ++i) {
    auto candidates = random_candidates(random, 30);
    const Vec2 location(0.5, 0.5);
    fuse(candidates, location, options);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      int before_c = 0, before_l = 0;
      const double own = (candidates[k].position - location).norm();
      for (std::size_t j = 0; j < candidates.size(); ++j) {
        const double other = (candidates[j].position - location).norm();
        before_c += candidates[j].lost < candidates[k].lost ||
                    (candidates[j].lost == candidates[k].lost && j < k);
        before_l += other < own || (other == own && j < k);
      }
      REQUIRE(candidates[k].rank_c == 1 + before_c);
      REQUIRE(candidates[k].rank_l == 1 + before_l);
    }
  }
}

TEST_CASE("With the start's figures a constraint outweighs a place 2 m from a good suggestion") {
  // The far one holds everything; the near one loses one constraint. 120 ranks cost more than the cells
  // within 1 m, but not than those of a whole large room.
  const auto winner = [](double distance) {
    std::vector<Ranked> candidates;
    for (double x = -6; x <= 6; x += 0.2)
      for (double y = -6; y <= 6; y += 0.2) candidates.push_back({{x, y}, 2, 0.0});
    candidates.push_back({{0, 0}, 1, 0.0});
    candidates.push_back({{distance, 0}, 0, 0.0});
    fuse(candidates, Vec2(0, 0), {});
    return order_of_choice(candidates).front() == candidates.size() - 1;
  };
  CHECK(winner(0.5));
  CHECK(winner(1.0));
  CHECK_FALSE(winner(4.0));
}

TEST_CASE("The order of choice is by fused score, then degree, then number") {
  std::vector<Ranked> candidates(5);
  candidates[0] = {{0, 0}, 0, 0.2, 1, 1, 0.010};
  candidates[1] = {{0, 0}, 0, 0.9, 1, 1, 0.010};
  candidates[2] = {{0, 0}, 0, 0.0, 1, 1, 0.016};
  candidates[3] = {{0, 0}, 0, 0.9, 1, 1, 0.010};
  candidates[4] = {{0, 0}, 0, 1.0, 1, 1, 0.001};
  CHECK(order_of_choice(candidates) == std::vector<std::size_t>{2, 1, 3, 0, 4});
}

TEST_CASE("Nothing is ranked when there is nothing") {
  std::vector<Ranked> none;
  fuse(none, Vec2(0, 0), {});
  CHECK(order_of_choice(none).empty());
}
