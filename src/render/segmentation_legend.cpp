#include "segmentation_legend.h"

#include <algorithm>
#include <cmath>

#include "overlay.h"
#include "pixel_rect.h"
#include "roomgen/base/text.h"

namespace roomgen::detail {

namespace {

constexpr double legend_part = 0.23;     // of the longer side
constexpr double row_by_width = 0.105;   // of the legend's width, with few entries
constexpr double letters_by_row = 0.5;
constexpr int rows_below = 5;            // for the scale and the arrow

// Rows of one height, from the top; positions in pixels of the picture.
struct Rows {
  double left = 0.0, width = 0.0, height = 0.0;

  Vec2 middle(double row, double along) const { return {left + along * width, (row + 0.5) * height}; }
  double letters() const { return letters_by_row * height; }
};

void fill(Image& image, const Vec2& low, const Vec2& high, const Rgb& color) {
  const PixelRect rect = PixelRect{static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(high.x()),
                                   static_cast<int>(high.y())}
                             .clipped({0, 0, image.width, image.height});
  for (int y = rect.y0; y < rect.y1; ++y)
    for (int x = rect.x0; x < rect.x1; ++x)
      std::copy(color.begin(), color.end(), image.at(x, y));
}

Image widened(const Image& picture, int width) {
  Image wide(picture.width + width, picture.height);
  std::fill(wide.pixels.begin(), wide.pixels.end(), std::uint8_t{255});
  for (int y = 0; y < picture.height; ++y) std::copy_n(picture.at(0, y), 4 * picture.width, wide.at(0, y));
  return wide;
}

void add_text(Drawing& drawing, const Rows& rows, double row, double from, const std::string& text) {
  const Vec2 size((0.97 - from) * rows.width, rows.height);
  const Vec2 left = rows.middle(row, from);
  drawing.labels.push_back({Drawing::Text::legend, text, left + Vec2(0.5 * size.x(), 0.0), size});
}

// The longest round length that fits.
void add_scale(Drawing& drawing, const Rows& rows, double row, double pixels_per_metre) {
  double metres = 0.1;
  for (const double length : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0})
    if (length * pixels_per_metre < 0.85 * rows.width) metres = length;
  const Vec2 from = rows.middle(row, 0.06), to = from + Vec2(metres * pixels_per_metre, 0.0);
  const Vec2 tick(0.0, 0.2 * rows.height);
  drawing.strokes.push_back({Drawing::Line::scale, {from - tick, from + tick, from, to, to - tick, to + tick}});
  add_text(drawing, rows, row + 0.8, 0.06, format_number(metres, 1) + " m");
}

void add_arrow(Drawing& drawing, const Rows& rows, double row) {
  drawing.strokes.push_back({Drawing::Line::front, {rows.middle(row, 0.04), rows.middle(row, 0.17)}});
  add_text(drawing, rows, row, 0.21, "front of a thing");
}

}  // namespace

int legend_width(int pixels) { return static_cast<int>(std::lround(legend_part * pixels)); }

Result<Image> with_legend(const Image& picture, const Legend& legend, int width) {
  Image image = widened(picture, width);
  const double lines = static_cast<double>(legend.entries.size()) + rows_below;
  const Rows rows{static_cast<double>(picture.width), static_cast<double>(width),
                  std::min(row_by_width * width, picture.height / lines)};
  Drawing drawing;
  drawing.text_height = rows.letters();
  double row = 0.3;
  for (const auto& entry : legend.entries) {
    fill(image, rows.middle(row - 0.36, 0.04), rows.middle(row + 0.36, 0.17), legend.colors.at(entry.category));
    const std::string count = entry.count > 1 ? " (" + std::to_string(entry.count) + ")" : "";
    add_text(drawing, rows, row, 0.21, entry.category + count);
    row += 1.0;
  }
  add_arrow(drawing, rows, row + 0.5);
  add_scale(drawing, rows, row + 2.0, legend.pixels_per_metre);
  if (auto drawn = draw_overlay(image, drawing); !drawn) return drawn.error();
  return image;
}

}  // namespace roomgen::detail
