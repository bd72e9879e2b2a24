#include "picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "noise.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen::shape {

namespace {

constexpr int longer_side = 256;

struct Canvas {
  int width = longer_side, height = longer_side;
  // One unit is the shorter side, the origin in the middle, y down.
  Vec2 place(double u, double v) const {
    const double shorter = std::min(width, height);
    return {(u - 0.5) * width / shorter, (v - 0.5) * height / shorter};
  }
};

Canvas canvas(double aspect) {
  const double a = std::isfinite(aspect) ? std::clamp(aspect, 0.2, 5.0) : 1.0;
  const auto pixels = [](double part) { return static_cast<int>(std::lround(longer_side * part)); };
  return {pixels(std::min(a, 1.0)), pixels(std::min(1.0 / a, 1.0))};
}

// A colour of the wheel: hue in turns, the rest 0 to 1.
/// Given in braces, its parts are drawn in their order by every compiler.
struct HueParts {
  double turn, saturation, value;
};

Tint hue(const HueParts& parts) {
  const auto& [turn, saturation, value] = parts;
  Tint result;
  for (int k = 0; k < 3; ++k) {
    const double away = std::abs(std::remainder(turn - k / 3.0, 1.0)) * 6.0;
    result[k] = 255.0 * value * (1.0 - saturation * std::clamp(away - 1.0, 0.0, 1.0));
  }
  return result;
}

// How much of a soft-edged shape covers a point, from its distance to the outline, negative inside.
double cover(double distance, double softness = 0.006) {
  return 1.0 - smooth_step(-softness, softness, distance);
}

Image screen(const Canvas& c, Random& random, std::uint64_t seed) {
  const Clouds glow(2, 2, seed);
  const double base = random.uniform(0.48, 0.68);
  const Tint dark = hue({base, 0.70, 0.30}),
             light = hue({base + random.uniform(-0.10, 0.14), 0.55, 0.85});
  const int cards = random.integer(3, 5);
  const double row = random.uniform(0.52, 0.66), tall = random.uniform(0.16, 0.24);
  std::vector<Tint> colors;
  for (int k = 0; k < cards; ++k)
    colors.push_back(hue({base + random.uniform(-0.2, 0.2), 0.45, random.uniform(0.55, 0.95)}));
  return painted(c.width, c.height, [&](double u, double v) {
    Tint color =
        mixed(dark, light,
              std::clamp(0.9 * (1.0 - v) * u + 0.7 * (glow(0.3 + 0.4 * u, 0.3 + 0.4 * v) - 0.35),
                         0.0, 1.0));
    const auto panel = [&](double left, double top, double right, double bottom, const Tint& tone,
                           double strength) {
      const Vec2 low = c.place(left, top), high = c.place(right, bottom);
      const double radius = 0.02;
      const Vec2 half = 0.5 * (high - low);
      const Vec2 off =
          ((c.place(u, v) - 0.5 * (low + high)).cwiseAbs() - (half.array() - radius).matrix())
              .cwiseMax(0.0);
      color = mixed(color, tone, strength * cover(off.norm() - radius));
    };
    const double pitch = 0.86 / cards;
    for (int k = 0; k < cards; ++k)
      panel(0.07 + pitch * k, row, 0.07 + pitch * (k + 0.86), row + tall,
            mixed(colors[k], dark, 0.7 * (v - row) / tall), 0.85);
    panel(0.07, 0.10, 0.40, 0.16, {255, 255, 255}, 0.55);
    panel(0.07, 0.20, 0.27, 0.235, {255, 255, 255}, 0.30);
    panel(0.07, 0.90, 0.93, 0.925, {255, 255, 255}, 0.15);
    panel(0.07, 0.90, 0.45, 0.925, {255, 255, 255}, 0.55);
    return color;
  });
}

Image mirror(const Canvas& c, Random& random, std::uint64_t seed) {
  const Clouds haze(2, 2, seed);
  const double tilt = random.uniform(-0.4, 0.4), tint = random.uniform(0.52, 0.60);
  return painted(c.width, c.height, [&](double u, double v) {
    const double down = v + tilt * (u - 0.5);
    const Tint sky =
        mixed(hue({tint, 0.16, 0.90}), hue({tint, 0.05, 0.97}), smooth_step(0.0, 0.65, down));
    const Tint color = mixed(sky, hue({tint - 0.4, 0.10, 0.78}), smooth_step(0.60, 1.0, down));
    return Tint(color * (0.97 + 0.06 * haze(0.5 * u, 0.5 * v)));
  });
}

Image clock(const Canvas& c, Random& random, std::uint64_t) {
  const bool dark = random.chance(0.35);
  const Tint face =
      dark ? hue({random.uniform(), 0.2, 0.18}) : hue({random.uniform(0.05, 0.17), 0.06, 0.96});
  const Tint ink = dark ? Tint(235, 230, 220) : Tint(38, 36, 36);
  const Tint accent = hue({random.uniform(), 0.75, 0.75});
  const double minutes = random.integer(0, 719);
  const auto direction = [](double turn) {
    return Vec2(std::sin(2 * pi * turn), -std::cos(2 * pi * turn));
  };
  const Vec2 hour = direction(minutes / 720), minute = direction(minutes / 60),
             second = direction(random.uniform());
  return painted(c.width, c.height, [&](double u, double v) {
    const Vec2 p = c.place(u, v);
    Tint color = face * (1.0 - 0.10 * p.squaredNorm());
    const auto line = [&](const Vec2& a, const Vec2& b, double width, const Tint& tone) {
      color = mixed(color, tone, cover(distance(Segment{a, b}, p) - width));
    };
    for (int k = 0; k < 12; ++k)
      line(direction(k / 12.0) * (k % 3 ? 0.41 : 0.37), direction(k / 12.0) * 0.44,
           k % 3 ? 0.006 : 0.011, ink);
    line(-0.05 * hour, 0.24 * hour, 0.013, ink);
    line(-0.06 * minute, 0.36 * minute, 0.009, ink);
    line(-0.09 * second, 0.38 * second, 0.003, accent);
    color = mixed(color, accent, cover(p.norm() - 0.022));
    return mixed(color, ink, cover(std::abs(p.norm() - 0.487) - 0.008));
  });
}

Image plain(const Canvas& c, Random& random, std::uint64_t seed) {
  const Noise canvas_weave(96, 96, seed);
  const Tint tone = hue({random.uniform(), random.uniform(0.05, 0.35), random.uniform(0.6, 0.92)});
  return painted(c.width, c.height, [&](double u, double v) {
    return Tint(tone * (0.97 + 0.05 * canvas_weave(u, v)));
  });
}

}  // namespace

Image paint_picture(Theme theme, std::uint64_t seed, double aspect) {
  const Canvas c = canvas(aspect);
  Random random(seed, static_cast<std::uint64_t>(theme));
  const std::uint64_t layers = seed * 0x9e3779b97f4a7c15ull + 77;
  switch (theme) {
    case Theme::screen:
      return screen(c, random, layers);
    case Theme::mirror:
      return mirror(c, random, layers);
    case Theme::clock:
      return clock(c, random, layers);
    case Theme::plain:
      return plain(c, random, layers);
  }
  return {};
}

}  // namespace roomgen::shape
