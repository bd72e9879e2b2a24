#include "canvas.h"

#include <algorithm>
#include <cmath>

namespace roomgen::shape {

namespace {

constexpr int row_samples = 4;  // rows for each row of pixels

// Adds to each pixel the part of it that lies in [low, high).
void add_span(std::vector<double>& cover, double low, double high) {
  low = std::clamp(low, 0.0, static_cast<double>(cover.size()));
  high = std::clamp(high, low, static_cast<double>(cover.size()));
  for (auto x = static_cast<std::size_t>(low); x < cover.size() && static_cast<double>(x) < high;
       ++x) {
    const auto left = static_cast<double>(x);
    cover[x] += (std::min(high, left + 1.0) - std::max(low, left)) / row_samples;
  }
}

}  // namespace

Canvas::Canvas(int width, int height, const Tint& ground)
    : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height, ground) {}

Canvas::Rows Canvas::crossings(const Outlines& outlines, int low, int high) const {
  Rows rows(static_cast<std::size_t>(high - low) * row_samples);
  const auto row_at = [&](double y) {
    const double row = std::ceil((y - low) * row_samples - 0.5);
    return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(rows.size())));
  };
  for (const auto& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
      const auto [top, bottom] = std::minmax(a.y(), b.y());
      for (std::size_t row = row_at(top); row < row_at(bottom); ++row) {
        const double y = low + (static_cast<double>(row) + 0.5) / row_samples;
        rows[row].push_back(
            {a.x() + (y - a.y()) * (b.x() - a.x()) / (b.y() - a.y()), a.y() < b.y() ? 1 : -1});
      }
    }
  return rows;
}

void Canvas::fill(const Outlines& outlines, const Tint& color, double opacity) {
  double top = height_, bottom = 0.0;
  for (const auto& outline : outlines)
    for (const auto& point : outline) {
      top = std::min(top, point.y());
      bottom = std::max(bottom, point.y());
    }
  const int low = static_cast<int>(std::floor(std::max(top, 0.0)));
  const int high = static_cast<int>(std::ceil(std::min(bottom, static_cast<double>(height_))));
  if (low >= high) return;
  Rows rows = crossings(outlines, low, high);
  std::vector<double> cover;
  for (int y = low; y < high; ++y) {
    cover.assign(static_cast<std::size_t>(width_), 0.0);
    for (int k = 0; k < row_samples; ++k) {
      auto& row = rows[static_cast<std::size_t>((y - low) * row_samples + k)];
      std::sort(row.begin(), row.end(), [](const Crossing& a, const Crossing& b) {
        return a.x != b.x ? a.x < b.x : a.turn < b.turn;
      });
      int winding = 0;
      for (std::size_t i = 0; i + 1 < row.size(); ++i) {
        winding += row[i].turn;
        if (winding != 0) add_span(cover, row[i].x, row[i + 1].x);
      }
    }
    Tint* line = &pixels_[static_cast<std::size_t>(y) * width_];
    for (int x = 0; x < width_; ++x)
      if (const double share = cover[static_cast<std::size_t>(x)]; share > 0.0)
        line[x] = mixed(line[x], color, opacity * std::min(share, 1.0));
  }
}

Image Canvas::image() const {
  Image image(width_, height_);
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    for (int k = 0; k < 3; ++k)
      image.pixels[4 * i + k] =
          static_cast<std::uint8_t>(std::clamp(pixels_[i][k], 0.0, 255.0) + 0.5);
    image.pixels[4 * i + 3] = 255;
  }
  return image;
}

Outlines pen_outlines(const std::vector<Vec2>& points, bool closed, double width) {
  constexpr int half_circle = 10;
  Outlines result;
  const std::size_t pieces = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < pieces; ++i) {
    const Vec2 ends[] = {points[i], points[(i + 1) % points.size()]};
    const Vec2 along = ends[1] - ends[0];
    const double turn = std::atan2(along.y(), along.x()) - 0.5 * pi;
    auto& outline = result.emplace_back();
    for (int k = 0; k < 2 * half_circle; ++k) {
      const double angle = turn + pi * (k - (k < half_circle ? 0 : 1)) / (half_circle - 1);
      outline.push_back(ends[k < half_circle ? 1 : 0] +
                        0.5 * width * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  return result;
}

}  // namespace roomgen::shape
