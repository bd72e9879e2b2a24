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
  // Half of the extent in those units.
  Vec2 half() const { return place(1.0, 1.0); }
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

// Paint is never quite even.
Tint brushed(const Tint& color, const Noise& strokes, double u, double v) {
  return color * (0.95 + 0.10 * strokes(u, v));
}

Image landscape(const Canvas& c, Random& random, std::uint64_t seed) {
  const Noise strokes(30, 90, seed);
  const Clouds clouds(3, 6, seed + 1);
  const double time = random.uniform();  // from noon to evening
  const Tint high = mixed({92, 148, 205}, {72, 74, 128}, time);
  const Tint low = mixed({214, 230, 240}, {246, 178, 118}, time);
  const double ground_hue = random.uniform(0.20, 0.40), horizon = random.uniform(0.38, 0.58);
  const Vec2 sun{random.uniform(0.15, 0.85), horizon - random.uniform(0.05, 0.22)};
  std::vector<Noise> hills;
  for (std::uint64_t k = 0; k < 4; ++k)
    hills.emplace_back(3 + static_cast<int>(2 * k), 1, seed + 2 + k);
  return painted(c.width, c.height, [&](double u, double v) {
    Tint color = mixed(high, low, smooth_step(0.0, horizon, v));
    color = mixed(color, {250, 246, 238}, 0.75 * smooth_step(0.52, 0.75, clouds(u, v)));
    const Vec2 from_sun = c.place(u, v) - c.place(sun.x(), sun.y());
    color = mixed(color, {255, 240, 205}, cover(from_sun.norm() - 0.05, 0.012));
    for (int k = 0; k < 4; ++k) {
      const double near = (k + 1) / 4.0;
      const double top = horizon + 0.13 * k - 0.26 * (1.0 - 0.5 * near) * (hills[k](u, 0.5) - 0.35);
      const Tint green = hue({ground_hue - 0.06 * near, 0.25 + 0.30 * near, 0.62 - 0.22 * near});
      const Tint hill = mixed(mixed(low, high, 0.5), green, 0.35 + 0.65 * near);
      color = mixed(color, hill * (1.06 - 0.35 * std::max(v - top, 0.0)), cover(top - v));
    }
    return brushed(color, strokes, u, v);
  });
}

Image abstract(const Canvas& c, Random& random, std::uint64_t seed) {
  const Noise strokes(60, 60, seed);
  const Clouds edge(5, 5, seed + 1);
  const double base = random.uniform();
  const Tint paper = hue({base + 0.1, 0.08, 0.94});
  struct Blot {
    Vec2 at, half;
    double turn, roundness;
    Tint color;
  };
  std::vector<Blot> blots;
  const int count = random.integer(5, 8);
  for (int k = 0; k < count; ++k) {
    const double x = random.uniform(-0.8, 0.8), y = random.uniform(-0.8, 0.8);
    const double w = random.uniform(0.06, 0.34), h = random.uniform(0.06, 0.34);
    const double turn = random.uniform(-0.5, 0.5), round = random.chance(0.5) ? 1.0 : 0.12;
    const double own = random.chance(0.3) ? 0.5 : random.uniform(-0.09, 0.09);
    const double strength = random.uniform(0.35, 0.75), light = random.uniform(0.35, 0.92);
    blots.push_back({c.half().cwiseProduct(Vec2(x, y)),
                     {w, h},
                     turn,
                     round,
                     hue({base + own, strength, light})});
  }
  return painted(c.width, c.height, [&](double u, double v) {
    Tint color = paper;
    for (const auto& blot : blots) {
      const Vec2 p = rotated(c.place(u, v) - blot.at, blot.turn);
      const double radius = blot.roundness * blot.half.minCoeff();
      const Vec2 out = (p.cwiseAbs() - (blot.half.array() - radius).matrix()).cwiseMax(0.0);
      const double wobble = 0.05 * (edge(u, v) - 0.5);
      color = mixed(color, blot.color, 0.93 * cover(out.norm() - radius + wobble));
    }
    return brushed(color, strokes, u, v);
  });
}

Image still_life(const Canvas& c, Random& random, std::uint64_t seed) {
  const Noise strokes(40, 60, seed);
  const Clouds wall(4, 3, seed + 1);
  const Tint wall_color = hue({random.uniform(), 0.22, random.uniform(0.35, 0.6)});
  const Tint cloth = hue({random.uniform(0.03, 0.13), 0.30, random.uniform(0.55, 0.8)});
  const Tint vase = hue({random.uniform(), 0.45, random.uniform(0.5, 0.8)});
  const double vase_x = random.uniform(-0.25, 0.25) * c.half().x() * 2;
  const double vase_width = random.uniform(0.11, 0.17), table = 0.5 * random.uniform(0.30, 0.44);
  struct Fruit {
    Vec2 at;
    double radius;
    Tint color;
  };
  std::vector<Fruit> fruits;
  const int count = random.integer(3, 6);
  for (int k = 0; k < count; ++k) {
    const double x = random.uniform(-0.75, 0.75) * c.half().x(),
                 radius = random.uniform(0.06, 0.10);
    const double y = table + 0.06 + 0.10 * k / count - radius;
    const double kind = random.uniform(0.0, 0.28);
    fruits.push_back({{x, y}, radius, hue({kind, 0.72, random.uniform(0.65, 0.9)})});
  }
  const auto lit = [](const Tint& color, const Vec2& from_middle) {
    return Tint(color * std::clamp(0.95 - 0.45 * (0.7 * from_middle.x() + 0.7 * from_middle.y()),
                                   0.3, 1.3));
  };
  return painted(c.width, c.height, [&](double u, double v) {
    const Vec2 p = c.place(u, v);
    Tint color = wall_color * (0.8 + 0.35 * wall(u, v) - 0.2 * p.x());
    color = mixed(color, cloth * (1.0 - 0.3 * (p.y() - table)), cover(table - p.y()));
    // The vase: a belly that narrows to a neck.
    const double foot = table + 0.05, up = (foot - p.y()) / 0.52;
    const double half = vase_width * (0.55 + 0.9 * std::sin(pi * std::clamp(up * 1.15, 0.0, 1.0)) *
                                                 (1.0 - 0.6 * std::clamp(up, 0.0, 1.0)));
    if (up > 0 && up < 1) {
      const double x = p.x() - vase_x;
      color = mixed(color, lit(vase, {1.1 * x / half, 0.0}), cover(std::abs(x) - half));
    }
    for (const auto& fruit : fruits) {
      const Vec2 at = (p - fruit.at) / fruit.radius;
      const Vec2 shadow =
          (p - fruit.at - Vec2(0.3, 0.85) * fruit.radius).cwiseProduct(Vec2(1, 2.4));
      color = mixed(color, color * 0.5, cover(shadow.norm() - fruit.radius, 0.03));
      color = mixed(color, lit(fruit.color, at), cover((at.norm() - 1.0) * fruit.radius));
      color = mixed(color, {255, 252, 240}, 0.6 * cover((at + Vec2(0.4, 0.4)).norm() - 0.12, 0.12));
    }
    return brushed(color, strokes, u, v);
  });
}

Image botanical(const Canvas& c, Random& random, std::uint64_t seed) {
  const Noise paper(40, 40, seed);
  const Tint ground = hue({random.uniform(0.08, 0.16), random.uniform(0.04, 0.12), 0.95});
  const Tint green =
      hue({random.uniform(0.24, 0.42), random.uniform(0.35, 0.6), random.uniform(0.35, 0.55)});
  const double sway = random.uniform(-0.25, 0.25), length = random.uniform(0.22, 0.34);
  const double slim = random.uniform(0.22, 0.45), lift = random.uniform(0.5, 1.1);
  const int pairs = random.integer(4, 7);
  const double tall = 0.8 * c.half().y();
  const auto stem = [&](double t) { return Vec2(sway * t * t, tall * (1.0 - 2.0 * t)); };
  struct Blade {
    Vec2 from, along;
    double length;
    Tint color;
  };
  std::vector<Blade> blades;
  for (int k = 0; k <= pairs; ++k)
    for (double side : {-1.0, 1.0}) {
      const double t = 0.22 + 0.76 * k / pairs,
                   angle = k == pairs ? 0.25 : lift * random.uniform(0.8, 1.2);
      blades.push_back({stem(t),
                        {side * std::sin(angle), -std::cos(angle)},
                        length * (1.15 - 0.55 * t),
                        green * random.uniform(0.85, 1.15)});
    }
  return painted(c.width, c.height, [&](double u, double v) {
    const Vec2 p = c.place(u, v);
    Tint color = ground;
    const double t = std::clamp((1.0 - p.y() / tall) / 2.0, 0.0, 1.0);
    color = mixed(color, green * 0.8, cover((p - stem(t)).norm() - 0.008));
    for (const auto& blade : blades) {
      const Vec2 from = p - blade.from;
      const double way = from.dot(blade.along) / blade.length, off = cross(blade.along, from);
      if (way <= 0 || way >= 1) continue;
      const double half = 0.5 * slim * blade.length * std::sin(pi * std::pow(way, 0.8));
      const double vein = 0.18 * cover(std::abs(off) - 0.003, 0.004);
      color = mixed(color, blade.color * (1.0 + vein + (off > 0 ? 0.08 : -0.04)),
                    cover(std::abs(off) - half));
    }
    return Tint(color * (0.98 + 0.03 * paper(u, v)));
  });
}

Image map(const Canvas& c, Random& random, std::uint64_t seed) {
  const Clouds land(4, 3, seed);
  const Noise paper(60, 60, seed + 1);
  const Tint sea = hue({random.uniform(0.50, 0.58), 0.22, 0.84}),
             soil = hue({random.uniform(0.10, 0.22), 0.28, 0.90});
  const double shore = random.uniform(0.44, 0.52);
  return painted(c.width, c.height, [&](double u, double v) {
    const Vec2 p = c.place(u, v);
    // Away from the edges, where the noise would repeat.
    const double height = land(0.02 + 0.96 * u, 0.02 + 0.96 * v) - 0.12 * p.squaredNorm();
    const double level = height - shore;
    Tint color = level > 0 ? mixed(soil, soil.cwiseProduct(Tint(0.80, 0.70, 0.58)),
                                   std::min(5.0 * level, 1.0))
                           : mixed(sea, sea * 0.86, std::min(-2.5 * level, 1.0));
    const double contour = std::abs(std::remainder(level, 0.06));
    color *= 1.0 - 0.12 * cover(contour - 0.004, 0.003);
    color = mixed(color, {105, 88, 66}, 0.8 * cover(std::abs(level) - 0.004, 0.004));
    const double meridian =
        std::min(std::abs(std::remainder(p.x(), 0.2)), std::abs(std::remainder(p.y(), 0.2)));
    color = mixed(color, {120, 110, 95}, 0.25 * cover(meridian - 0.001, 0.003));
    const Vec2 rim = c.half() - p.cwiseAbs();
    const double edge = rim.minCoeff();
    if (edge < 0.06)
      color = mixed({238, 228, 206}, {105, 88, 66}, cover(std::abs(edge - 0.045) - 0.004, 0.003));
    return Tint(color * (0.96 + 0.06 * paper(u, v)));
  });
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
    case Theme::landscape:
      return landscape(c, random, layers);
    case Theme::abstract:
      return abstract(c, random, layers);
    case Theme::still_life:
      return still_life(c, random, layers);
    case Theme::botanical:
      return botanical(c, random, layers);
    case Theme::map:
      return map(c, random, layers);
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
