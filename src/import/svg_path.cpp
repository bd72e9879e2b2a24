#include "svg_path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numbers.h"

namespace roomgen::detail {

namespace {

constexpr int curve_steps = 8;
constexpr std::size_t max_points = 20000;

class PathParser {
 public:
  PathParser(std::string_view data, const std::string& source, std::size_t line)
      : rest_(data), source_(source), line_(line) {}

  Result<std::vector<DrawnLine>> run() {
    skip_separators(rest_);
    while (!rest_.empty() && !error_) {
      if (is_command(rest_.front())) {
        command_ = rest_.front();
        rest_.remove_prefix(1);
      } else if (command_ == 0 || command_ == 'Z' || command_ == 'z') {
        fail("expected a command, as M or L");
        break;
      }
      run_command();
      skip_separators(rest_);
      if (points_ > max_points) fail("the path has too many corners");
    }
    if (error_) return *error_;
    return std::move(lines_);
  }

 private:
  static bool is_command(char c) { return std::string_view("MmLlHhVvZzCcSsQqTtAa").find(c) != std::string_view::npos; }

  void fail(const std::string& what) {
    if (!error_) error_ = located(source_, line_, "path: " + what);
  }

  double number() {
    skip_separators(rest_);
    const auto value = take_number(rest_);
    if (!value) fail(std::string("\"") + command_ + "\" needs another number");
    return value.value_or(0.0);
  }

  // Flags of arcs may follow each other without anything between.
  bool flag() {
    skip_separators(rest_);
    if (rest_.empty() || (rest_.front() != '0' && rest_.front() != '1')) {
      fail("a flag of \"A\" must be 0 or 1");
      return false;
    }
    const bool set = rest_.front() == '1';
    rest_.remove_prefix(1);
    return set;
  }

  bool is_relative() const { return command_ >= 'a'; }

  Vec2 point() {
    const double x = number(), y = number();
    return is_relative() ? Vec2(at_ + Vec2(x, y)) : Vec2(x, y);
  }

  void line_to(const Vec2& p) {
    if (lines_.empty() || lines_.back().closed) move_to(at_);
    lines_.back().points.push_back({p, line_});
    at_ = p;
    ++points_;
  }

  void move_to(const Vec2& p) {
    lines_.push_back({});
    lines_.back().points.push_back({p, line_});
    at_ = start_ = p;
    ++points_;
  }

  void run_command() {
    const char upper = is_relative() ? static_cast<char>(command_ - 'a' + 'A') : command_;
    if (lines_.empty() && upper != 'M') return fail("must begin with M");
    std::optional<Vec2> control;
    switch (upper) {
      case 'M':
        move_to(point());
        command_ = is_relative() ? 'l' : 'L';  // what follows without a letter are lines
        break;
      case 'L': line_to(point()); break;
      case 'H': line_to({number() + (is_relative() ? at_.x() : 0.0), at_.y()}); break;
      case 'V': line_to({at_.x(), number() + (is_relative() ? at_.y() : 0.0)}); break;
      case 'Z':
        lines_.back().closed = true;
        at_ = start_;
        break;
      case 'C':
      case 'S': control = cubic(upper == 'S'); break;
      case 'Q':
      case 'T': control = quadratic(upper == 'T'); break;
      case 'A': arc(); break;
    }
    control_ = control;
    control_of_ = upper == 'C' || upper == 'S' ? 'C' : upper == 'Q' || upper == 'T' ? 'Q' : 0;
  }

  // The last control point mirrored, if a curve of that kind came before.
  Vec2 mirrored(char kind) const {
    return control_ && control_of_ == kind ? Vec2(2.0 * at_ - *control_) : at_;
  }

  Vec2 cubic(bool smooth) {
    const Vec2 a = at_, b = smooth ? mirrored('C') : point(), c = point(), d = point();
    for (int i = 1; i <= curve_steps; ++i) {
      const double t = static_cast<double>(i) / curve_steps, u = 1.0 - t;
      line_to(u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d);
    }
    return c;
  }

  Vec2 quadratic(bool smooth) {
    const Vec2 a = at_, b = smooth ? mirrored('Q') : point(), c = point();
    for (int i = 1; i <= curve_steps; ++i) {
      const double t = static_cast<double>(i) / curve_steps, u = 1.0 - t;
      line_to(u * u * a + 2 * u * t * b + t * t * c);
    }
    return b;
  }

  // SVG 1.1, F.6.5: the ellipse through both ends, made a unit circle by turning and scaling.
  void arc() {
    const Vec2 radii(std::abs(number()), std::abs(number()));
    const double turn = radians(number());
    const bool large = flag(), sweep = flag();
    const Vec2 from = at_, to = point();
    if (error_) return;
    if (radii.minCoeff() < 1e-9 || (to - from).norm() < 1e-12) return line_to(to);
    const auto to_circle = [&](const Vec2& p) {
      return Vec2(rotated(p, -turn).cwiseQuotient(radii));
    };
    const Vec2 a = to_circle(from), b = to_circle(to);
    const double half = 0.5 * (b - a).norm();
    const double scale = std::max(1.0, half);  // radii that are too short grow
    const double apothem = std::sqrt(std::max(0.0, scale * scale - half * half));
    const Vec2 side = left_of(Vec2((b - a) / (2.0 * half)));
    const Vec2 center = 0.5 * (a + b) + (large == sweep ? -1.0 : 1.0) * apothem * side;
    const double first = std::atan2((a - center).y(), (a - center).x());
    double angle = std::atan2((b - center).y(), (b - center).x()) - first;
    if (sweep && angle < 0) angle += 2.0 * pi;
    if (!sweep && angle > 0) angle -= 2.0 * pi;
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / arc_step)));
    for (int i = 1; i < steps; ++i) {
      const Vec2 on_circle = center + rotated(Vec2(scale, 0), first + angle * i / steps);
      line_to(rotated(Vec2(on_circle.cwiseProduct(radii)), turn));
    }
    line_to(to);
  }

  std::string_view rest_;
  const std::string& source_;
  std::size_t line_;
  char command_ = 0;
  Vec2 at_ = Vec2::Zero(), start_ = Vec2::Zero();
  std::optional<Vec2> control_;
  char control_of_ = 0;
  std::size_t points_ = 0;
  std::vector<DrawnLine> lines_;
  std::optional<Error> error_;
};

}  // namespace

Result<std::vector<DrawnLine>> parse_svg_path(std::string_view data, const std::string& source,
                                              std::size_t line) {
  return PathParser(data, source, line).run();
}

}  // namespace roomgen::detail
