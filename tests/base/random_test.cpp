#include "base/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "catch.h"

using roomgen::Random;

namespace {

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
};

template <typename Draw>
Moments moments(int count, Draw draw) {
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < count; ++i) {
    const double value = draw();
    sum += value;
    squares += value * value;
  }
  const double mean = sum / count;
  return {mean, squares / count - mean * mean};
}

std::array<std::uint32_t, 4> first_four(Random random) {
  return {random.next(), random.next(), random.next(), random.next()};
}

}  // namespace

TEST_CASE("A seed gives the sequence it always gave") {
  // Computed apart, from the published definitions of PCG32 and SplitMix64.
  CHECK(first_four(Random(0)) ==
        std::array<std::uint32_t, 4>{0x86f952fe, 0xd90e5468, 0x7209bdb6, 0x35c93874});
  CHECK(first_four(Random(7)) ==
        std::array<std::uint32_t, 4>{0xf9091eef, 0x52121cb0, 0xd561bc41, 0x7ca7ede1});
  CHECK(first_four(Random(~std::uint64_t{0})) ==
        std::array<std::uint32_t, 4>{0xf6804c22, 0x12593548, 0xbd0560e4, 0x5a39669a});
}

TEST_CASE("Neighbouring seeds and streams have nothing in common") {
  std::set<std::array<std::uint32_t, 4>> seen;
  for (std::uint64_t seed = 0; seed < 500; ++seed)
    for (std::uint64_t stream = 0; stream < 4; ++stream) seen.insert(first_four(Random(seed, stream)));
  CHECK(seen.size() == 2000);
}

TEST_CASE("Uniform numbers are at least 0 and below 1, with the moments of the uniform distribution") {
  Random random(11);
  double low = 1.0, high = 0.0;
  const auto found = moments(200000, [&] {
    const double value = random.uniform();
    low = std::min(low, value), high = std::max(high, value);
    return value;
  });
  CHECK(low >= 0.0);
  CHECK(high < 1.0);
  CHECK(found.mean == Approx(0.5).margin(0.003));
  CHECK(found.variance == Approx(1.0 / 12.0).margin(0.001));
}

TEST_CASE("Integers cover their range evenly, both ends included") {
  Random random(12);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) {
    const int value = random.integer(-3, 3);
    REQUIRE(value >= -3);
    REQUIRE(value <= 3);
    ++counts[static_cast<std::size_t>(value + 3)];
  }
  for (int count : counts) CHECK(count == Approx(10000).margin(400));
  CHECK(random.integer(5, 5) == 5);
}

TEST_CASE("Normal numbers have the mean, the deviation and the tails asked for") {
  Random random(13);
  int within_one = 0;
  const auto found = moments(200000, [&] {
    const double value = random.normal(3.0, 2.0);
    REQUIRE(std::isfinite(value));
    within_one += std::abs(value - 3.0) < 2.0 ? 1 : 0;
    return value;
  });
  CHECK(found.mean == Approx(3.0).margin(0.02));
  CHECK(found.variance == Approx(4.0).margin(0.06));
  CHECK(within_one / 200000.0 == Approx(0.6827).margin(0.005));
}

TEST_CASE("A chance comes true as often as it says") {
  Random random(14);
  CHECK(moments(100000, [&] { return random.chance(0.2) ? 1.0 : 0.0; }).mean ==
        Approx(0.2).margin(0.006));
  for (int i = 0; i < 1000; ++i) {
    REQUIRE_FALSE(random.chance(0.0));
    REQUIRE(random.chance(1.0));
  }
}

TEST_CASE("Weighted draws follow the weights and never take what weighs nothing") {
  Random random(15);
  std::array<int, 4> counts{};
  for (int i = 0; i < 60000; ++i) ++counts[random.weighted({1.0, 0.0, 2.0, 3.0})];
  CHECK(counts[0] == Approx(10000).margin(450));
  CHECK(counts[1] == 0);
  CHECK(counts[2] == Approx(20000).margin(600));
  CHECK(counts[3] == Approx(30000).margin(600));
}

TEST_CASE("Shuffling keeps the items and reaches every order alike") {
  Random random(16);
  std::array<int, 6> orders{};
  for (int i = 0; i < 60000; ++i) {
    std::vector<int> items = {0, 1, 2};
    random.shuffle(items);
    REQUIRE(std::accumulate(items.begin(), items.end(), 0) == 3);
    const int order = 2 * items[0] + (items[1] > items[2] ? 1 : 0);
    ++orders[static_cast<std::size_t>(order)];
  }
  for (int count : orders) CHECK(count == Approx(10000).margin(450));
}

TEST_CASE("A fork leaves its parent as it was") {
  Random with(17), without(17);
  Random fork = with.fork("assets");
  for (int i = 0; i < 100; ++i) fork.next();
  CHECK(first_four(with) == first_four(without));
}

TEST_CASE("Forks depend on purpose and on the parent's state, and on nothing else") {
  const Random parent(18);
  CHECK(first_four(parent.fork("assets")) == first_four(parent.fork("assets")));
  CHECK(first_four(parent.fork("assets")) != first_four(parent.fork("placement")));
  CHECK(first_four(parent.fork("assets")) != first_four(parent));
  CHECK(first_four(parent.fork("assets")) != first_four(Random(19).fork("assets")));
}

TEST_CASE("A fork's numbers do not follow its parent's") {
  Random parent(20);
  Random fork = parent.fork("other");
  double product = 0.0;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) product += (parent.uniform() - 0.5) * (fork.uniform() - 0.5);
  // The standard error of the correlation is 1 / sqrt(count) = 0.003.
  CHECK(12.0 * product / count == Approx(0.0).margin(0.015));
}
