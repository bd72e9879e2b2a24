#include "overlay.h"

#include <opencv2/imgproc.hpp>

namespace roomgen::detail {

namespace {

struct Ink {
  int r, g, b;
  double opacity;
};

constexpr Ink paper{255, 255, 255, 1.0};
constexpr int subpixel_bits = 4;

cv::Rect clipped(const cv::Rect& rect, const cv::Mat& picture) {
  return rect & cv::Rect(0, 0, picture.cols, picture.rows);
}

// The picture turns to ink where the mask, which covers `area`, says so.
void blend(cv::Mat& picture, const cv::Rect& area, const cv::Mat& mask, const Ink& ink) {
  const int color[3] = {ink.r, ink.g, ink.b};
  const int strength = static_cast<int>(ink.opacity * 256.0);
  for (int y = 0; y < area.height; ++y) {
    const auto* coverage = mask.ptr<std::uint8_t>(y);
    auto* pixel = picture.ptr<std::uint8_t>(area.y + y) + 4 * area.x;
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
  explicit Pen(Image& image) : picture_(image.height, image.width, CV_8UC4, image.pixels.data()) {}

  void line(const std::vector<Vec2>& points, int thickness, const Ink& ink) {
    Bounds2 extent;
    for (const auto& p : points) extent.add(p);
    const cv::Rect area = area_of(extent, thickness + 2);
    if (area.empty()) return;
    cv::Mat mask = cv::Mat::zeros(area.size(), CV_8UC1);
    std::vector<cv::Point> fixed;
    for (const auto& p : points) fixed.push_back(fixed_point(p, area));
    cv::polylines(mask, fixed, false, cv::Scalar(255), thickness, cv::LINE_AA, subpixel_bits);
    blend(picture_, area, mask, ink);
  }

  void fill(const std::vector<Vec2>& points, const Ink& ink) {
    Bounds2 extent;
    for (const auto& p : points) extent.add(p);
    const cv::Rect area = area_of(extent, 2);
    if (area.empty()) return;
    cv::Mat mask = cv::Mat::zeros(area.size(), CV_8UC1);
    std::vector<cv::Point> fixed;
    for (const auto& p : points) fixed.push_back(fixed_point(p, area));
    cv::fillConvexPoly(mask, fixed, cv::Scalar(255), cv::LINE_AA, subpixel_bits);
    blend(picture_, area, mask, ink);
  }

  void arrow(const Vec2& from, const Vec2& to, int thickness, double head, const Ink& ink) {
    const Vec2 along = (to - from).normalized(), side = left_of(along);
    const Vec2 neck = to - head * along;
    line({from, neck}, thickness, ink);
    fill({to, neck + 0.55 * head * side, neck - 0.55 * head * side}, ink);
  }

  /// Capital letters `letters` pixels high, shrunk if the box would not hold the text.
  void text(const std::string& words, const Vec2& center, const Vec2& box, double letters,
            const Ink& ink, bool halo) {
    int baseline = 0;
    const cv::Size unit = cv::getTextSize("H", font, 1.0, 1, &baseline);
    double scale = letters / unit.height;
    const cv::Size full = cv::getTextSize(words, font, 1.0, 1, &baseline);
    scale = std::min(scale, box.x() / (full.width + 4.0));
    const int thickness = std::max(1, static_cast<int>(std::lround(letters / 14.0)));

    const cv::Rect area = area_of({center - 0.7 * box, center + 0.7 * box}, 3);
    if (area.empty()) return;
    const cv::Point origin(
        static_cast<int>(std::lround(center.x() - 0.5 * full.width * scale)) - area.x,
        static_cast<int>(std::lround(center.y() + 0.5 * unit.height * scale)) - area.y);
    for (const bool background : {true, false}) {
      if (background && !halo) continue;
      cv::Mat mask = cv::Mat::zeros(area.size(), CV_8UC1);
      cv::putText(mask, words, origin, font, scale, cv::Scalar(255),
                  background ? thickness + 2 : thickness, cv::LINE_AA);
      blend(picture_, area, mask, background ? Ink{255, 255, 255, 0.75} : ink);
    }
  }

 private:
  static constexpr int font = cv::FONT_HERSHEY_DUPLEX;

  cv::Rect area_of(const Bounds2& extent, int margin) const {
    const cv::Point low(static_cast<int>(std::floor(extent.low.x())) - margin,
                        static_cast<int>(std::floor(extent.low.y())) - margin);
    const cv::Point high(static_cast<int>(std::ceil(extent.high.x())) + margin + 1,
                         static_cast<int>(std::ceil(extent.high.y())) + margin + 1);
    return clipped(cv::Rect(low, high), picture_);
  }

  // Pixel centres are at whole numbers in OpenCV, at halves in our coordinates.
  static cv::Point fixed_point(const Vec2& p, const cv::Rect& area) {
    constexpr double unit = 1 << subpixel_bits;
    return {static_cast<int>(std::lround((p.x() - 0.5 - area.x) * unit)),
            static_cast<int>(std::lround((p.y() - 0.5 - area.y) * unit))};
  }

  cv::Mat picture_;
};

std::vector<Vec2> box_outline(const Vec2& center, const Vec2& size) {
  const Vec2 h = 0.5 * size;
  return {center - h, center + Vec2(h.x(), -h.y()), center + h, center + Vec2(-h.x(), h.y()),
          center - h};
}

void draw_stroke(Pen& pen, const Drawing::Stroke& stroke, int width, double letters) {
  const Vec2 first = stroke.points.front(), last = stroke.points.back();
  switch (stroke.kind) {
    case Drawing::Line::grid:
      return pen.line(stroke.points, width, {30, 60, 90, 0.22});
    case Drawing::Line::outline:
      return pen.line(stroke.points, width, {20, 40, 70, 0.55});
    case Drawing::Line::free:
      pen.fill(stroke.points, {60, 170, 90, 0.22});
      return pen.line(stroke.points, width, {30, 120, 60, 0.8});
    case Drawing::Line::leader:
      return pen.line(stroke.points, width, {20, 40, 70, 0.85});
    case Drawing::Line::plan_symbol:
      return pen.line(stroke.points, width, {64, 66, 72, 0.9});
    case Drawing::Line::axis:
      return pen.arrow(first, last, width, 0.7 * letters, {20, 40, 70, 1.0});
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
    case Drawing::Text::point:
      return pen.text(label.text, label.center, label.size, 0.72 * letters, {20, 40, 70, 0.9},
                      true);
  }
}

}  // namespace

void draw_overlay(Image& image, const Drawing& drawing) {
  Pen pen(image);
  const int width = std::max(1, static_cast<int>(std::lround(drawing.text_height / 11.0)));
  for (const auto kind :
       {Drawing::Line::free, Drawing::Line::plan_symbol, Drawing::Line::grid,
        Drawing::Line::outline, Drawing::Line::axis, Drawing::Line::leader, Drawing::Line::arrow})
    for (const auto& stroke : drawing.strokes)
      if (stroke.kind == kind && stroke.points.size() > 1)
        draw_stroke(pen, stroke, width, drawing.text_height);
  for (const auto& label : drawing.labels) draw_label(pen, label, drawing.text_height);
}

}  // namespace roomgen::detail
