#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.h"
#include "shape/pattern.h"
#include "shape/picture.h"

using namespace roomgen;
using namespace roomgen::shape;

namespace {

const std::vector<Pattern> patterns = {Pattern::none,    Pattern::grain,   Pattern::weave,
                                       Pattern::marble,  Pattern::leather, Pattern::brushed,
                                       Pattern::wicker,  Pattern::stripes, Pattern::checks,
                                       Pattern::speckle, Pattern::rug,     Pattern::tiles};
const std::vector<Theme> themes = {Theme::screen, Theme::mirror, Theme::clock, Theme::plain};
const Eigen::Vector3f first(180, 140, 90), second(60, 50, 80);

double difference(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(a.pixels[i] - b.pixels[i]);
  return sum / a.pixels.size();
}

// Mean difference between two columns, or rows.
double step(const Image& image, bool columns, int a, int b) {
  double sum = 0.0;
  const int n = columns ? image.height : image.width;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 3; ++k)
      sum += columns ? std::abs(image.at(a, i)[k] - image.at(b, i)[k])
                     : std::abs(image.at(i, a)[k] - image.at(i, b)[k]);
  return sum / (3 * n);
}

double contrast(const Image& image) {
  double sum = 0.0, squares = 0.0;
  const int n = image.width * image.height;
  for (int i = 0; i < n; ++i) {
    const double g = image.pixels[4 * i + 1];
    sum += g;
    squares += g * g;
  }
  return std::sqrt(std::max(squares / n - sum / n * (sum / n), 0.0));
}

}  // namespace

TEST_CASE("Patterns are opaque squares that equal arguments repeat") {
  for (auto pattern : patterns) {
    const Image image = paint_pattern(pattern, first, second, 5);
    REQUIRE(image.width == 256);
    REQUIRE(image.height == 256);
    CHECK(image.pixels == paint_pattern(pattern, first, second, 5).pixels);
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) REQUIRE(image.pixels[i] == 255);
    CHECK(pattern_extent(pattern) > 0.05);
    CHECK(pattern_extent(pattern) <= 1.0);
  }
}

TEST_CASE("Patterns show something, but for none") {
  for (auto pattern : patterns) {
    INFO(static_cast<int>(pattern));
    const double seen = contrast(paint_pattern(pattern, first, second, 1));
    if (pattern == Pattern::none)
      CHECK(seen == 0.0);
    else
      CHECK(seen > 2.0);
  }
}

TEST_CASE("Patterns keep near to their first colour where they have no other") {
  for (auto pattern : {Pattern::grain, Pattern::weave, Pattern::leather, Pattern::brushed}) {
    const Image image = paint_pattern(pattern, first, first, 2);
    for (int k = 0; k < 3; ++k) {
      double sum = 0.0;
      for (std::size_t i = k; i < image.pixels.size(); i += 4) sum += image.pixels[i];
      CHECK(sum / (256 * 256) == Approx(first[k]).epsilon(0.15));
    }
  }
}

TEST_CASE("Patterns tile: across the border they change no more than inside") {
  for (auto pattern : patterns)
    for (bool columns : {true, false}) {
      INFO(static_cast<int>(pattern) << (columns ? " columns" : " rows"));
      const Image image = paint_pattern(pattern, first, second, 3);
      double worst = 0.0;
      for (int k = 0; k + 1 < 256; ++k) worst = std::max(worst, step(image, columns, k, k + 1));
      CHECK(step(image, columns, 255, 0) <= worst * 1.05 + 0.5);
    }
}

TEST_CASE("A pattern's seed changes what chance decides") {
  for (auto pattern : patterns)
    if (pattern != Pattern::none)
      CHECK(difference(paint_pattern(pattern, first, second, 1),
                       paint_pattern(pattern, first, second, 2)) > 0.3);
}

TEST_CASE("Pictures have the aspect that was asked for") {
  for (auto theme : themes)
    for (double aspect : {0.2, 0.7, 1.0, 1.5, 16.0 / 9, 5.0}) {
      const Image image = paint_picture(theme, 3, aspect);
      CHECK(std::max(image.width, image.height) == 256);
      CHECK(static_cast<double>(image.width) / image.height == Approx(aspect).epsilon(0.02));
    }
}

TEST_CASE("Every seed paints its own picture, and the same one again") {
  for (auto theme : themes)
    for (std::uint64_t seed = 1; seed < 6; ++seed) {
      INFO(static_cast<int>(theme) << " " << seed);
      const Image image = paint_picture(theme, seed, 1.4);
      CHECK(image.pixels == paint_picture(theme, seed, 1.4).pixels);
      CHECK(difference(image, paint_picture(theme, seed + 1, 1.4)) > 1.0);
    }
}
