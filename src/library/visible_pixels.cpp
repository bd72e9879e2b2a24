#include "visible_pixels.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace roomgen {

namespace {

constexpr int pixels = 72;
constexpr double flat = 1e-12;

// Looking along -`toward`: columns along `right`, rows along `up`.
struct Direction {
  Vec3 right, up, toward;
};
const Direction directions[] = {
    {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},    // from above
    {Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY()},   // from the front
    {-Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitX()},  // from both sides
    {Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX()},
};

class Picture {
 public:
  Picture(const Model& model, const Direction& direction, const Bounds3& box, double size)
      : model_(model), direction_(direction), size_(size), seen_(pixels * pixels) {
    const Vec3 middle = box.center();
    low_ = Vec2(direction.right.dot(middle), direction.up.dot(middle)) - Vec2::Constant(0.5 * pixels * size);
  }

  template <typename Opaque>
  void draw(const Opaque& opaque) {
    for (std::size_t part = 0; part < model_.parts.size(); ++part)
      for (const auto& t : model_.parts[part].mesh.triangles) draw(part, t, opaque);
  }
  template <typename Visit>
  void each(const Visit& visit) const {
    for (const auto& seen : seen_)
      if (seen.nearness > -1e300) visit(seen.pixel);
  }

 private:
  struct Seen {
    double nearness = -1e301;
    VisiblePixel pixel;
  };

  template <typename Opaque>
  void draw(std::size_t part, const Triangle& t, const Opaque& opaque) {
    const Mesh& mesh = model_.parts[part].mesh;
    Vec2 p[3];
    double near[3];
    for (int i = 0; i < 3; ++i) {
      const Vec3 corner = mesh.positions[t[static_cast<std::size_t>(i)]].cast<double>();
      p[i] = (Vec2(direction_.right.dot(corner), direction_.up.dot(corner)) - low_) / size_;
      near[i] = direction_.toward.dot(corner);
    }
    const double area = cross(p[1] - p[0], p[2] - p[0]);
    if (std::abs(area) < flat) return;
    const Vec2 low = p[0].cwiseMin(p[1]).cwiseMin(p[2]), high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    for (int row = first(low.y()); row <= last(high.y()); ++row)
      for (int column = first(low.x()); column <= last(high.x()); ++column) {
        const Vec2 at(column + 0.5, row + 0.5);
        const double a = cross(p[1] - at, p[2] - at) / area, b = cross(p[2] - at, p[0] - at) / area;
        const double c = 1.0 - a - b;
        if (a < 0.0 || b < 0.0 || c < 0.0) continue;
        Seen& seen = seen_[static_cast<std::size_t>(row * pixels + column)];
        const double nearness = a * near[0] + b * near[1] + c * near[2];
        if (nearness <= seen.nearness) continue;
        VisiblePixel pixel{part, Vec2::Zero(), size_ * size_};
        if (!mesh.uvs.empty())
          pixel.uv = (a * mesh.uvs[t[0]].cast<double>() + b * mesh.uvs[t[1]].cast<double>() +
                      c * mesh.uvs[t[2]].cast<double>());
        if (opaque(pixel)) seen = {nearness, pixel};
      }
  }

  static double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
  static int first(double at) { return std::clamp(static_cast<int>(std::ceil(at - 0.5)), 0, pixels - 1); }
  static int last(double at) { return std::clamp(static_cast<int>(std::floor(at - 0.5)), 0, pixels - 1); }

  const Model& model_;
  const Direction& direction_;
  double size_;
  Vec2 low_ = Vec2::Zero();
  std::vector<Seen> seen_;
};

}  // namespace

void each_visible_pixel(const Model& model, const std::function<bool(const VisiblePixel&)>& opaque,
                        const std::function<void(const VisiblePixel&)>& visit) {
  const Bounds3 box = bounds(model);
  if (box.empty()) return;
  const double size = std::max(1e-9, box.size().maxCoeff()) / pixels;
  for (const auto& direction : directions) {
    Picture picture(model, direction, box, size);
    picture.draw(opaque);
    picture.each(visit);
  }
}

}  // namespace roomgen
