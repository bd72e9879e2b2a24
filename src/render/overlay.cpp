#include "overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "opencv.h"

namespace roomgen::detail {

namespace {

struct Ink {
  int r, g, b;
  double opacity;
};

constexpr int subpixel_bits = 4;

// A rectangle of pixels.
struct PixelArea {
  int x = 0, y = 0, width = 0, height = 0;

  bool empty() const { return width <= 0 || height <= 0; }
};

// How far each pixel of an area is covered, 0 to 255.
class Coverage {
 public:
  explicit Coverage(const PixelArea& area)
      : area_(area), bytes_(static_cast<std::size_t>(area.width) * area.height) {}

  CvMat mat() { return cvMat(area_.height, area_.width, CV_8UC1, bytes_.data()); }
  const PixelArea& area() const { return area_; }
  const std::uint8_t* row(int y) const {
    return bytes_.data() + static_cast<std::size_t>(y) * area_.width;
  }

 private:
  PixelArea area_;
  std::vector<std::uint8_t> bytes_;
};

// The picture turns to ink where it is covered.
void blend(Image& picture, const Coverage& covered, const Ink& ink) {
  const int color[3] = {ink.r, ink.g, ink.b};
  const int strength = static_cast<int>(ink.opacity * 256.0);
  const PixelArea& area = covered.area();
  for (int y = 0; y < area.height; ++y) {
    const auto* coverage = covered.row(y);
    auto* pixel = picture.at(area.x, area.y + y);
    for (int x = 0; x < area.width; ++x, pixel += 4) {
      if (!coverage[x]) continue;
      const int weight = coverage[x] * strength;  // of 255 * 256
      for (int c = 0; c < 3; ++c)
        pixel[c] =
            static_cast<std::uint8_t>(pixel[c] + (color[c] - pixel[c]) * weight / (255 * 256));
    }
  }
}

class Pen {
 public:
  Pen(const OpenCv& cv, Image& picture) : cv_(cv), picture_(picture) {}

  void line(const std::vector<Vec2>& points, int thickness, const Ink& ink) {
    draw(points, thickness + 2, ink, [&](CvMat& mask, std::vector<CvPoint>& fixed) {
      CvPoint* corners = fixed.data();
      const int count = static_cast<int>(fixed.size());
      cv_.PolyLine(&mask, &corners, &count, 1, false, white, thickness, CV_AA, subpixel_bits);
    });
  }

  void fill(const std::vector<Vec2>& points, const Ink& ink) {
    draw(points, 2, ink, [&](CvMat& mask, std::vector<CvPoint>& fixed) {
      cv_.FillConvexPoly(&mask, fixed.data(), static_cast<int>(fixed.size()), white, CV_AA,
                         subpixel_bits);
    });
  }

  void arrow(const Vec2& from, const Vec2& to, int thickness, double head, const Ink& ink) {
    const Vec2 along = (to - from).normalized(), side = left_of(along);
    const Vec2 neck = to - head * along;
    line({from, neck}, thickness, ink);
    fill({to, neck + 0.55 * head * side, neck - 0.55 * head * side}, ink);
  }

  enum class Align { left, center };

  /// Capital letters `letters` pixels high, shrunk if the box would not hold the text.
  void text(const std::string& words, const Vec2& center, const Vec2& box, double letters,
            const Ink& ink, bool halo, Align align = Align::center) {
    const CvSize unit = size_of("H"), full = size_of(words);
    const double scale =
        std::min(letters / unit.height, box.x() / (full.width + 4.0));
    const int thickness = std::max(1, static_cast<int>(std::lround(letters / 14.0)));

    const PixelArea area = area_of({center - 0.7 * box, center + 0.7 * box}, 3);
    if (area.empty()) return;
    const double left = center.x() - 0.5 * (align == Align::left ? box.x() : full.width * scale);
    const CvPoint origin =
        cvPoint(static_cast<int>(std::lround(left)) - area.x,
                static_cast<int>(std::lround(center.y() + 0.5 * unit.height * scale)) - area.y);
    for (const bool background : {true, false}) {
      if (background && !halo) continue;
      Coverage coverage(area);
      CvMat mask = coverage.mat();
      const CvFont font = font_of(scale, background ? thickness + 2 : thickness);
      cv_.PutText(&mask, words.c_str(), origin, &font, white);
      blend(picture_, coverage, background ? Ink{255, 255, 255, 0.75} : ink);
    }
  }

 private:
  // `stroke` covers what it draws with white.
  template <typename Stroke>
  void draw(const std::vector<Vec2>& points, int margin, const Ink& ink, const Stroke& stroke) {
    Bounds2 extent;
    for (const auto& p : points) extent.add(p);
    const PixelArea area = area_of(extent, margin);
    if (area.empty()) return;
    std::vector<CvPoint> fixed;
    for (const auto& p : points) fixed.push_back(fixed_point(p, area));
    Coverage coverage(area);
    CvMat mask = coverage.mat();
    stroke(mask, fixed);
    blend(picture_, coverage, ink);
  }

  CvFont font_of(double scale, int thickness) const {
    CvFont font;
    cv_.InitFont(&font, CV_FONT_HERSHEY_DUPLEX, scale, scale, 0.0, thickness, CV_AA);
    return font;
  }

  // At scale 1.
  CvSize size_of(const std::string& words) const {
    const CvFont font = font_of(1.0, 1);
    CvSize size{};
    int baseline = 0;
    cv_.GetTextSize(words.c_str(), &font, &size, &baseline);
    return size;
  }

  // Of the part within the picture.
  PixelArea area_of(const Bounds2& extent, int margin) const {
    const int x0 = std::max(0, static_cast<int>(std::floor(extent.low.x())) - margin),
              y0 = std::max(0, static_cast<int>(std::floor(extent.low.y())) - margin),
              x1 = std::min(picture_.width, static_cast<int>(std::ceil(extent.high.x())) + margin + 1),
              y1 = std::min(picture_.height, static_cast<int>(std::ceil(extent.high.y())) + margin + 1);
    return {x0, y0, x1 - x0, y1 - y0};
  }

  // Pixel centres are at whole numbers in OpenCV, at halves in our coordinates.
  static CvPoint fixed_point(const Vec2& p, const PixelArea& area) {
    constexpr double unit = 1 << subpixel_bits;
    return cvPoint(static_cast<int>(std::lround((p.x() - 0.5 - area.x) * unit)),
                   static_cast<int>(std::lround((p.y() - 0.5 - area.y) * unit)));
  }

  const CvScalar white = cvScalar(255);
  const OpenCv& cv_;
  Image& picture_;
};

std::vector<Vec2> box_outline(const Vec2& center, const Vec2& size) {
  const Vec2 h = 0.5 * size;
  return {center - h, center + Vec2(h.x(), -h.y()), center + h, center + Vec2(-h.x(), h.y()),
          center - h};
}

void draw_front(Pen& pen, const Vec2& from, const Vec2& to, int width, double head) {
  pen.arrow(from, to, width + 3, head + 4, {255, 255, 255, 0.95});
  pen.arrow(from, to, width + 1, head, {16, 18, 24, 1.0});
}

void draw_stroke(Pen& pen, const Drawing::Stroke& stroke, int width, double letters) {
  const Vec2 first = stroke.points.front(), last = stroke.points.back();
  switch (stroke.kind) {
    case Drawing::Line::grid:
      return pen.line(stroke.points, width, {30, 60, 90, 0.42});
    case Drawing::Line::dot:
      return pen.fill(stroke.points, {20, 40, 110, 0.95});
    case Drawing::Line::outline:
      return pen.line(stroke.points, width, {20, 40, 70, 0.55});
    case Drawing::Line::free:
      pen.fill(stroke.points, {60, 170, 90, 0.22});
      return pen.line(stroke.points, width, {30, 120, 60, 0.8});
    case Drawing::Line::leader:
      return pen.line(stroke.points, width, {20, 40, 70, 0.85});
    case Drawing::Line::plan_symbol:
      return pen.line(stroke.points, width, {64, 66, 72, 0.9});
    case Drawing::Line::scale:
      return pen.line(stroke.points, 2 * width, {20, 24, 32, 1.0});
    case Drawing::Line::axis:
      return pen.arrow(first, last, width, 0.7 * letters, {20, 40, 70, 1.0});
    case Drawing::Line::front:
      return draw_front(pen, first, last, width, std::min(0.85 * letters, 0.4 * (last - first).norm()));
    case Drawing::Line::arrow:
      pen.arrow(first, last, width + 3, 0.95 * letters + 2, {255, 255, 255, 0.75});
      return pen.arrow(first, last, width + 1, 0.85 * letters, {196, 40, 36, 1.0});
  }
}

void draw_label(Pen& pen, const Drawing::Label& label, double letters) {
  switch (label.kind) {
    case Drawing::Text::object:
      pen.fill(box_outline(label.center, label.size - Vec2::Constant(1.0)), {255, 255, 255, 0.86});
      pen.line(box_outline(label.center, label.size - Vec2::Constant(1.0)), 1, {20, 40, 70, 0.7});
      return pen.text(label.text, label.center, label.size, letters, {12, 24, 48, 1.0}, false);
    case Drawing::Text::tick:
      return pen.text(label.text, label.center, label.size, letters, {40, 44, 52, 1.0}, false);
    case Drawing::Text::axis:
      return pen.text(label.text, label.center, label.size, letters, {20, 40, 70, 1.0}, false);
    case Drawing::Text::legend:
      return pen.text(label.text, label.center, label.size, letters, {20, 24, 32, 1.0}, false, Pen::Align::left);
    case Drawing::Text::part:
      return pen.text(label.text, label.center, label.size, letters, {120, 50, 10, 1.0}, true);
    case Drawing::Text::point:
      return pen.text(label.text, label.center, label.size, 0.72 * letters, {20, 40, 70, 0.9},
                      true);
  }
}

}  // namespace

Status draw_overlay(Image& image, const Drawing& drawing) {
  const auto& cv = opencv();
  if (!cv) return cv.error();
  Pen pen(*cv, image);
  const int width = std::max(1, static_cast<int>(std::lround(drawing.text_height / 11.0)));
  for (const auto kind :
       {Drawing::Line::free, Drawing::Line::plan_symbol, Drawing::Line::grid, Drawing::Line::dot,
        Drawing::Line::outline, Drawing::Line::axis, Drawing::Line::leader, Drawing::Line::arrow,
        Drawing::Line::front, Drawing::Line::scale})
    for (const auto& stroke : drawing.strokes)
      if (stroke.kind == kind && stroke.points.size() > 1)
        draw_stroke(pen, stroke, width, drawing.text_height);
  for (const auto& label : drawing.labels)
    draw_label(pen, label, label.letters > 0.0 ? label.letters : drawing.text_height);
  return {};
}

}  // namespace roomgen::detail
