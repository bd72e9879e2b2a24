#include "geometry/texture.h"

#include <cmath>
#include <set>

#include "catch.h"

using namespace roomgen;

namespace {

const Eigen::Vector3f red(190, 60, 50), pale(225, 225, 230);

int difference(const std::uint8_t* a, const std::uint8_t* b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

// How unlike neighbouring columns (or rows) are, one for each pair; the last is the seam.
std::vector<double> steps(const Image& image, bool columns) {
  const int count = columns ? image.width : image.height, along = columns ? image.height : image.width;
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    double sum = 0.0;
    for (int j = 0; j < along; ++j) {
      const int next = (i + 1) % count;
      sum += columns ? difference(image.at(i, j), image.at(next, j))
                     : difference(image.at(j, i), image.at(j, next));
    }
    result.push_back(sum / along);
  }
  return result;
}

Eigen::Vector3f mean(const Image& image) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      sum += Eigen::Vector3d(image.at(x, y)[0], image.at(x, y)[1], image.at(x, y)[2]);
  return (sum / (image.width * image.height)).cast<float>();
}

}  // namespace

TEST_CASE("every pattern has a name of its own, a size and a picture of its own") {
  std::set<std::string> names;
  std::set<std::vector<std::uint8_t>> pictures;
  for (const auto pattern : all_texture_patterns()) {
    names.insert(std::string(name(pattern)));
    CHECK(parse_texture_pattern(name(pattern)) == pattern);
    CHECK(texture_extent(pattern) > 0.3);
    pictures.insert(paint_texture(pattern, red, pale).pixels);
  }
  CHECK(names.size() == all_texture_patterns().size());
  CHECK(pictures.size() == all_texture_patterns().size());
  CHECK_FALSE(parse_texture_pattern("tartan"));
}

TEST_CASE("textures repeat without a seam") {
  for (const auto pattern : all_texture_patterns()) {
    const Image image = paint_texture(pattern, red, pale);
    for (const bool columns : {true, false}) {
      INFO(name(pattern) << (columns ? " across" : " down"));
      const auto all = steps(image, columns);
      const double worst = *std::max_element(all.begin(), all.end() - 1);
      CHECK(all.back() <= 1.25 * worst + 1.0);
    }
  }
}

TEST_CASE("textures have the tones that are asked for") {
  for (const auto pattern : all_texture_patterns()) {
    INFO(name(pattern));
    const Eigen::Vector3f in_red = mean(paint_texture(pattern, red, red));
    CHECK((in_red - red).norm() < 45.0f);
    CHECK(in_red.x() > 2.0f * in_red.y());
    // The second tone shows where the pattern has two of one rank, half and half at most.
    const bool moved = (mean(paint_texture(pattern, red, pale)) - in_red).norm() > 20.0f;
    if (has_two_tones(pattern)) CHECK(moved);
  }
}
