#include "pattern.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "noise.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/shape/program.h"

namespace roomgen::shape {

namespace {

constexpr int side = 256;

struct Colors {
  Tint first, second;
};

// 0 at whole numbers, 1 in the middle between.
double ridge(double x) {
  return 1.0 - std::abs(2.0 * fraction(x) - 1.0);
}

Image grain(const Colors& c, std::uint64_t seed) {
  const Noise fibre(5, 128, seed), pore(24, 200, seed + 1);
  const Clouds wave(1, 4, seed + 2), tone(1, 4, seed + 3);
  return painted(side, side, [&](double u, double v) -> Tint {
    // Year rings, cut at a slant: bands along u that wander.
    const double ring = fraction(9.0 * v + 1.3 * wave(u, v));
    const double band = smooth_step(0.0, 0.75, ring) * (1.0 - smooth_step(0.88, 1.0, ring));
    const double pores = smooth_step(0.72, 1.0, pore(u, v));
    const double shade =
        1.03 - 0.10 * band - 0.07 * (fibre(u, v) - 0.5) - 0.07 * pores + 0.08 * (tone(u, v) - 0.5);
    return mixed(c.first * shade, c.second, 0.10 * band);
  });
}

// Over and under: `threads` strands each way, the upper one at a place of the first colour along u.
Image woven(const Colors& c, int threads, double depth, double unevenness, std::uint64_t seed) {
  const Noise along(8, threads, seed), across(threads, 8, seed + 1), fibre(128, 128, seed + 2);
  return painted(side, side, [&](double u, double v) -> Tint {
    const double x = u * threads, y = v * threads;
    const bool level = (static_cast<int>(x) + static_cast<int>(y)) % 2 == 0;
    const double over = level ? ridge(x) : ridge(y), round = level ? ridge(y) : ridge(x);
    const double bulge = std::sqrt(round) * (0.55 + 0.45 * smooth_step(0.0, 0.9, over));
    const double own = level ? along(u, v) : across(u, v);
    const double shade = 1.0 - depth * (1.0 - bulge) + unevenness * (own - 0.5) +
                         0.06 * (fibre(u, v) - 0.5) + 0.25 * depth;
    return mixed(c.first, c.second, level ? 0.0 : 0.35) * shade;
  });
}

Image marble(const Colors& c, std::uint64_t seed) {
  const Clouds bend(3, 3, seed), branch(4, 4, seed + 1), cloud(3, 3, seed + 2);
  return painted(side, side, [&](double u, double v) -> Tint {
    const double main = ridge(u + v + 1.9 * bend(u, v));
    const double fine = ridge(2 * u - v + 2.6 * branch(u, v));
    const double vein = std::max(smooth_step(0.90, 1.0, main), 0.5 * smooth_step(0.94, 1.0, fine)) *
                        (0.45 + 0.55 * cloud(v, u));
    const double haze = 0.16 * smooth_step(0.55, 1.0, main);
    return mixed(c.first * (0.97 + 0.06 * cloud(u, v)), c.second,
                 std::min(0.75 * vein + haze, 1.0));
  });
}

// The distances to the nearest and second nearest of points scattered one to a cell.
struct Cells {
  Cells(int cells, std::uint64_t seed) : count(cells) {
    Random random(seed);
    for (int i = 0; i < cells * cells; ++i) {
      const double x = random.uniform(), y = random.uniform();
      offsets.push_back({x, y});
    }
  }
  struct Nearest {
    double first, second;
    int cell = 0;
  };
  Nearest at(double u, double v) const {
    const double x = u * count, y = v * count;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const auto wrapped = [&](int k) { return k < 0 ? k + count : k >= count ? k - count : k; };
    Nearest result{81.0, 81.0};  // squared until the end
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int cell = wrapped(row + dy) * count + wrapped(column + dx);
        const Vec2& offset = offsets[static_cast<std::size_t>(cell)];
        const double across = column + dx + offset.x() - x, down = row + dy + offset.y() - y;
        const double distance = across * across + down * down;
        if (distance < result.first) {
          result.second = result.first;
          result.first = distance;
          result.cell = cell;
        } else {
          result.second = std::min(result.second, distance);
        }
      }
    result.first = std::sqrt(result.first);
    result.second = std::sqrt(result.second);
    return result;
  }
  int count;
  std::vector<Vec2> offsets;
};

Image leather(const Colors& c, std::uint64_t seed) {
  const Cells pebbles(40, seed);
  const Clouds wear(3, 3, seed + 1), crumple(9, 9, seed + 2);
  return painted(side, side, [&](double u, double v) -> Tint {
    const double du = 0.012 * (crumple(u, v) - 0.5), dv = 0.012 * (crumple(v, u) - 0.5);
    const auto nearest = pebbles.at(fraction(u + du), fraction(v + dv));
    const double pebble = smooth_step(0.0, 0.30, nearest.second - nearest.first);
    return c.first * (0.88 + 0.13 * pebble + 0.10 * (wear(u, v) - 0.5));
  });
}

Image brushed(const Colors& c, std::uint64_t seed) {
  const Noise fine(3, 256, seed), middle(2, 90, seed + 1);
  const Clouds sheen(2, 3, seed + 2);
  return painted(side, side, [&](double u, double v) -> Tint {
    return c.first * (1.0 + 0.11 * (fine(u, v) - 0.5) + 0.07 * (middle(u, v) - 0.5) +
                      0.05 * (sheen(u, v) - 0.5));
  });
}

Image stripes(const Colors& c, std::uint64_t seed) {
  const Noise thread(4, 128, seed), weft(128, 128, seed + 1);
  return painted(side, side, [&](double u, double v) -> Tint {
    const double at = fraction(4.0 * v);
    const double wide = smooth_step(0.24, 0.26, at) * (1.0 - smooth_step(0.74, 0.76, at));
    const double thin = smooth_step(0.06, 0.07, at) * (1.0 - smooth_step(0.11, 0.12, at));
    return mixed(c.first, c.second, std::max(wide, 0.7 * thin)) *
           (0.97 + 0.04 * thread(u, v) + 0.04 * weft(u, v));
  });
}

Image checks(const Colors& c, std::uint64_t seed) {
  const Noise fibre(128, 128, seed);
  const auto band = [](double x) {
    const double at = fraction(x);
    return smooth_step(0.24, 0.26, at) * (1.0 - smooth_step(0.74, 0.76, at));
  };
  return painted(side, side, [&](double u, double v) -> Tint {
    // The threads of both directions show by turns where both are dyed.
    const double twill = ridge(48.0 * (u + v)) * 0.08;
    const double dye = 0.5 * (band(4 * u) + band(4 * v));
    return mixed(c.first, c.second, dye) * (0.94 + twill + 0.05 * fibre(u, v));
  });
}

Image speckle(const Colors& c, std::uint64_t seed) {
  const Cells chips(18, seed), grit(56, seed + 1);
  const Clouds tone(4, 4, seed + 2);
  Random random(seed);
  std::vector<double> size, shade;
  for (int i = 0; i < 18 * 18; ++i) {
    size.push_back(random.chance(0.6) ? random.uniform(0.12, 0.42) : 0.0);
    shade.push_back(random.uniform(0.75, 1.2));
  }
  return painted(side, side, [&](double u, double v) -> Tint {
    const auto chip = chips.at(u, v);
    const auto cell = static_cast<std::size_t>(chip.cell);
    const double edge = std::min(size[cell], 0.9 * chip.second) - chip.first;
    const double inside = size[cell] > 0 ? smooth_step(-0.03, 0.05, edge) : 0.0;
    const double dust = 0.4 * (1.0 - smooth_step(0.10, 0.22, grit.at(u, v).first));
    const Tint ground = mixed(c.first * (0.97 + 0.05 * tone(u, v)), c.second, dust * 0.5);
    return mixed(ground, c.second * shade[cell], inside);
  });
}

Image rug(const Colors& c, std::uint64_t seed) {
  const Noise tuft(128, 128, seed), wear(6, 6, seed + 1);
  Random random(seed);
  const double inner = random.uniform(0.18, 0.32), dots = random.integer(2, 4);
  const Tint third = 0.55 * c.first + 0.45 * c.second;
  return painted(side, side, [&](double u, double v) -> Tint {
    // Diamonds in a grid, drawn in steps like knots.
    const double knots = 64.0;
    const double x = (std::floor(u * knots) + 0.5) / knots,
                 y = (std::floor(v * knots) + 0.5) / knots;
    const double a = std::abs(2.0 * fraction(2 * x) - 1.0),
                 b = std::abs(2.0 * fraction(2 * y) - 1.0);
    const double diamond = a + b;
    Tint color = c.first;
    if (diamond > 0.86 && diamond < 1.14) color = c.second;
    if (diamond < 0.62 && diamond > 0.62 - inner) color = third;
    if (diamond < 0.14) color = c.second;
    if (diamond > 1.5) color = ridge(dots * 8 * x) > 0.5 ? c.second : third;
    return color * (0.90 + 0.12 * tuft(u, v) + 0.06 * (wear(u, v) - 0.5));
  });
}

Image tiles(const Colors& c, std::uint64_t seed) {
  const Clouds glaze(8, 8, seed), grit(48, 48, seed + 1);
  constexpr int count = 4;
  Random random(seed);
  std::vector<double> tone;
  for (int i = 0; i < count * count; ++i) tone.push_back(random.uniform(0.965, 1.035));
  return painted(side, side, [&](double u, double v) -> Tint {
    const double x = u * count, y = v * count;
    const double edge = 0.5 * std::min(ridge(x), ridge(y));
    const double tile = smooth_step(0.014, 0.032, edge);
    const double rim = 0.06 * (1.0 - smooth_step(0.03, 0.09, edge));
    const double own =
        tone[static_cast<std::size_t>(static_cast<int>(y) * count + static_cast<int>(x))];
    const Tint face = c.first * (own - rim + 0.04 * (glaze(u, v) - 0.5));
    return mixed(c.second * (0.95 + 0.1 * grit(u, v)), face, tile);
  });
}

}  // namespace

Pattern pattern_named(std::string_view name) {
  const auto names = pattern_names();  // in the order of the enumeration
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? Pattern::none : static_cast<Pattern>(found - names.begin());
}

double pattern_extent(Pattern pattern) {
  switch (pattern) {
    case Pattern::grain:
      return 0.5;
    case Pattern::weave:
    case Pattern::leather:
      return 0.12;
    case Pattern::brushed:
      return 0.3;
    case Pattern::wicker:
      return 0.16;
    case Pattern::stripes:
    case Pattern::checks:
      return 0.32;
    case Pattern::speckle:
      return 0.4;
    case Pattern::rug:
    case Pattern::tiles:
      return 0.6;
    case Pattern::marble:
    case Pattern::none:
      return 1.0;
  }
  return 1.0;
}

Image paint_pattern(Pattern pattern, const Eigen::Vector3f& first, const Eigen::Vector3f& second,
                    std::uint64_t seed) {
  const Colors colors{first.cast<double>(), second.cast<double>()};
  // Neighbouring seeds share none of the layers, which count on from the seed.
  const std::uint64_t base = seed * 0x9e3779b97f4a7c15ull;
  switch (pattern) {
    case Pattern::none:
      return painted(side, side, [&](double, double) { return colors.first; });
    case Pattern::grain:
      return grain(colors, base);
    case Pattern::weave:
      return woven(colors, 48, 0.35, 0.10, base);
    case Pattern::marble:
      return marble(colors, base);
    case Pattern::leather:
      return leather(colors, base);
    case Pattern::brushed:
      return brushed(colors, base);
    case Pattern::wicker:
      return woven(colors, 12, 0.60, 0.18, base);
    case Pattern::stripes:
      return stripes(colors, base);
    case Pattern::checks:
      return checks(colors, base);
    case Pattern::speckle:
      return speckle(colors, base);
    case Pattern::rug:
      return rug(colors, base);
    case Pattern::tiles:
      return tiles(colors, base);
  }
  return {};
}

}  // namespace roomgen::shape
