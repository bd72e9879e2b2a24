#include "texture_painter.h"

namespace roomgen::detail {

namespace {

class Carpet : public Painter {
 public:
  explicit Carpet(const Rgb& tone) : tone_(tone) {}
  Rgb color(float u, float v) const override {
    return tone_ *
           (0.90f + 0.11f * fibre_.at(u, v) + 0.06f * tuft_.at(u, v) + 0.04f * wear_.at(u, v));
  }

 private:
  Rgb tone_;
  Noise fibre_{200, 200, 31}, tuft_{90, 90, 32}, wear_{5, 5, 33};
};

class Concrete : public Painter {
 public:
  explicit Concrete(const Rgb& tone) : tone_(tone) {}
  Rgb color(float u, float v) const override {
    const float cloud = 0.6f * broad_.at(u, v) + 0.4f * middle_.at(u, v);
    return tone_ * (0.95f + 0.08f * cloud + 0.03f * grit_.at(u, v));
  }

 private:
  Rgb tone_;
  Noise broad_{4, 4, 41}, middle_{11, 11, 42}, grit_{140, 140, 43};
};

}  // namespace

std::unique_ptr<Painter> plain_painter(TexturePattern pattern, const Rgb& tone) {
  if (pattern == TexturePattern::carpet) return std::make_unique<Carpet>(tone);
  return std::make_unique<Concrete>(tone);
}

}  // namespace roomgen::detail
