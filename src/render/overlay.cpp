#include "overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "opencv.h"
#include "roomgen/base/text.h"

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

using Points = std::vector<Vec2>;

// A polyline in pieces of a length with gaps of the same between them.
std::vector<Points> dashes(const Points& points, double length) {
  std::vector<Points> pieces;
  double phase = 0.0;  // of the way through a piece and its gap
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 whole = points[i + 1] - points[i];
    for (double at = 0.0; at < whole.norm();) {
      const bool drawn = phase < length;
      const double step =
          std::min((drawn ? length : 2.0 * length) - phase + 1e-6, whole.norm() - at);
      const Vec2 a = points[i] + at * whole.normalized();
      if (drawn) pieces.push_back({a, a + step * whole.normalized()});
      at += step;
      phase = std::fmod(phase + step, 2.0 * length);
    }
  }
  return pieces;
}

// Lines at 45 degrees so far apart within a convex outline.
std::vector<Points> hatching(const Points& outline, double apart) {
  std::vector<Points> lines;
  const Vec2 across = Vec2(1, 1).normalized();
  double low = 1e300, high = -1e300;
  for (const auto& p : outline)
    low = std::min(low, across.dot(p)), high = std::max(high, across.dot(p));
  for (double at = (std::floor(low / apart) + 1.0) * apart; at < high; at += apart) {
    Points ends;
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
      const double a = across.dot(outline[i]) - at, b = across.dot(outline[i + 1]) - at;
      if ((a < 0) != (b < 0))
        ends.push_back(outline[i] + a / (a - b) * (outline[i + 1] - outline[i]));
    }
    if (ends.size() == 2) lines.push_back(std::move(ends));
  }
  return lines;
}

class Pen {
 public:
  Pen(const OpenCv& cv, Image& picture) : cv_(cv), picture_(picture) {}

  void line(const Points& points, int thickness, const Ink& ink) {
    lines({points}, thickness, ink);
  }

  /// All of one ink, also where they cross.
  void lines(const std::vector<Points>& all, int thickness, const Ink& ink) {
    draw(all, thickness + 2, ink, [&](CvMat& mask, std::vector<CvPoint>& fixed) {
      CvPoint* corners = fixed.data();
      for (const auto& points : all) {
        const int count = static_cast<int>(points.size());
        cv_.PolyLine(&mask, &corners, &count, 1, false, white, thickness, CV_AA, subpixel_bits);
        corners += count;
      }
    });
  }

  void fill(const std::vector<Vec2>& points, const Ink& ink) {
    draw({points}, 2, ink, [&](CvMat& mask, std::vector<CvPoint>& fixed) {
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
    const double scale = std::min(letters / unit.height, box.x() / (full.width + 4.0));
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
  void draw(const std::vector<Points>& all, int margin, const Ink& ink, const Stroke& stroke) {
    Bounds2 extent;
    for (const auto& points : all)
      for (const auto& p : points) extent.add(p);
    if (extent.size().minCoeff() < 0.0) return;
    const PixelArea area = area_of(extent, margin);
    if (area.empty()) return;
    std::vector<CvPoint> fixed;
    for (const auto& points : all)
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
              x1 = std::min(picture_.width,
                            static_cast<int>(std::ceil(extent.high.x())) + margin + 1),
              y1 = std::min(picture_.height,
                            static_cast<int>(std::ceil(extent.high.y())) + margin + 1);
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

constexpr Ink none{0, 0, 0, 0.0};

/// How a line is drawn: with widths in that of the thinnest, lengths in heights of a letter.
struct Style {
  Ink ink;
  double width = 1.0;
  Ink halo = none;  ///< around it
  Ink fill = none;
  double dash = 0.0;   ///< 0: in one piece
  double hatch = 0.0;  ///< apart from each other are lines inside; 0: there are none
  bool arrow = false;
};

struct LineStyle {
  Drawing::Line kind;
  Style style;
};

constexpr Ink whitish{255, 255, 255, 0.8}, half_white{255, 255, 255, 0.5}, red{205, 20, 30, 1.0};
using Line = Drawing::Line;
constexpr LineStyle styles[] = {
    {Line::paper, {{64, 66, 72, 1.0}, 2.0, none, {244, 242, 236, 1.0}}},
    {Line::free, {{30, 120, 60, 0.8}, 1.0, none, {60, 170, 90, 0.22}}},
    {Line::keep_clear, {{205, 90, 0, 0.55}, 1.0, none, {240, 140, 30, 0.08}, 0.0, 0.9}},
    {Line::use, {{20, 110, 190, 0.3}, 1.0, none, {40, 140, 220, 0.05}, 0.0, 1.2}},
    {Line::plan_symbol, {{64, 66, 72, 0.9}}},
    {Line::grid, {{30, 60, 90, 0.42}}},
    {Line::hole, {{120, 50, 10, 1.0}, 1.0, none, {190, 222, 240, 1.0}}},
    {Line::before, {{70, 74, 84, 0.9}, 1.0, none, {120, 124, 134, 0.35}}},
    {Line::hung, {{90, 40, 130, 0.9}, 1.0, none, {150, 100, 200, 0.4}}},
    {Line::dot, {none, 0.0, none, {20, 40, 110, 0.95}}},
    {Line::outline, {{20, 40, 70, 0.7}, 1.0, half_white}},
    {Line::overhead, {{110, 50, 150, 0.9}, 1.0, half_white, none, 0.6}},
    {Line::in_the_way, {red, 2.0, whitish}},
    {Line::refused, {red, 2.0, whitish, none, 0.9}},
    {Line::axis, {{20, 40, 70, 1.0}, 1.0, none, none, 0.0, 0.0, true}},
    {Line::leader, {{20, 40, 70, 0.85}, 1.0, half_white}},
    {Line::arrow, {{196, 40, 36, 1.0}, 2.0, whitish, none, 0.0, 0.0, true}},
    {Line::front, {{16, 18, 24, 1.0}, 2.0, {255, 255, 255, 0.95}, none, 0.0, 0.0, true}},
    {Line::scale, {{20, 24, 32, 1.0}, 2.0}},
};

const Style& style_of(Line kind) {
  const auto is_it = [&](const LineStyle& row) { return row.kind == kind; };
  return std::find_if(std::begin(styles), std::end(styles), is_it)->style;
}

void draw_arrow(Pen& pen, const Drawing::Stroke& stroke, const Style& style, int thin,
                double letters) {
  const Vec2 from = stroke.points.front(), to = stroke.points.back();
  const double head = std::min(0.85 * letters, 0.6 * (to - from).norm());
  const int width = static_cast<int>(style.width) * thin;
  if (style.halo.opacity > 0.0) pen.arrow(from, to, width + 2, head + 3, style.halo);
  pen.arrow(from, to, width, head, style.ink);
}

void draw_stroke(Pen& pen, const Drawing::Stroke& stroke, int thin, double letters) {
  const Style& style = style_of(stroke.kind);
  if (style.arrow) return draw_arrow(pen, stroke, style, thin, letters);
  const int width = static_cast<int>(std::lround(style.width * thin));
  if (style.fill.opacity > 0.0) pen.fill(stroke.points, style.fill);
  if (style.hatch > 0.0)
    pen.lines(hatching(stroke.points, style.hatch * letters), width, style.ink);
  const std::vector<Points> pieces = style.dash > 0.0 ? dashes(stroke.points, style.dash * letters)
                                                      : std::vector<Points>{stroke.points};
  if (style.halo.opacity > 0.0) pen.lines(pieces, width + 2, style.halo);
  if (style.ink.opacity > 0.0) pen.lines(pieces, width, style.ink);
}

void draw_boxed(Pen& pen, const Drawing::Label& label, double letters, const Ink& ink) {
  const auto box = box_outline(label.center, label.size - Vec2::Constant(1.0));
  pen.fill(box, {255, 255, 255, 0.86});
  pen.line(box, 1, {ink.r, ink.g, ink.b, 0.7});
  pen.text(label.text, label.center, label.size, letters, ink, false);
}

void draw_lines(Pen& pen, const Drawing::Label& label, double letters, const Ink& ink) {
  const auto lines = split(label.text, '\n');
  Vec2 center = label.center -
                Vec2(0.0, 0.5 * line_spacing * letters * static_cast<double>(lines.size() - 1));
  for (const auto& line : lines) {
    pen.text(line, center, label_size(line, letters), letters, ink, true);
    center.y() += line_spacing * letters;
  }
}

void draw_label(Pen& pen, const Drawing::Label& label, double letters) {
  switch (label.kind) {
    case Drawing::Text::object:
      return draw_boxed(pen, label, letters, {12, 24, 48, 1.0});
    case Drawing::Text::red:
      return draw_boxed(pen, label, letters, red);
    case Drawing::Text::tick:
      return pen.text(label.text, label.center, label.size, letters, {40, 44, 52, 1.0}, false);
    case Drawing::Text::axis:
      return pen.text(label.text, label.center, label.size, letters, {20, 40, 70, 1.0}, false);
    case Drawing::Text::legend:
      return pen.text(label.text, label.center, label.size, letters, {20, 24, 32, 1.0}, false,
                      Pen::Align::left);
    case Drawing::Text::part:
      return draw_lines(pen, label, letters, {120, 50, 10, 1.0});
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
  std::vector<const Drawing::Stroke*> order;
  for (const auto& stroke : drawing.strokes)
    if (stroke.points.size() > 1) order.push_back(&stroke);
  std::stable_sort(order.begin(), order.end(), [](auto* a, auto* b) { return a->kind < b->kind; });
  for (const auto* stroke : order) draw_stroke(pen, *stroke, width, drawing.text_height);
  for (const auto& label : drawing.labels)
    draw_label(pen, label, label.letters > 0.0 ? label.letters : drawing.text_height);
  return {};
}

}  // namespace roomgen::detail
