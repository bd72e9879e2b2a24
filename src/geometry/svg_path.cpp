#include "svg_path.h"

#include <cmath>
#include <optional>
#include <string>

#include "flatten.h"
#include "path_scanner.h"

namespace roomgen {

namespace {

using namespace detail;

// The first error stays; what was read after it is of no use.
class SvgPathReader {
 public:
  SvgPathReader(std::string_view path, const SvgPathOptions& options)
      : scanner_(path), options_(options) {}

  Result<std::vector<SvgSubpath>> run() {
    while (!error_ && !scanner_.at_end()) {
      if (next_command()) run_command();
      if (points_ > options_.most_points)
        fail("a path has at most " + std::to_string(options_.most_points) + " points");
    }
    if (error_) return *error_;
    return std::move(subpaths_);
  }

 private:
  void fail(const std::string& what) {
    if (!error_)
      error_ = {Error::Kind::invalid_input,
                "path, byte " + std::to_string(scanner_.position()) + ": " + what};
  }

  // --- Commands and their numbers -------------------------------------------------------------

  // Without a letter the command before it goes on.
  bool next_command() {
    const auto letter = scanner_.command();
    if (!letter && (command_ == 0 || kind() == 'Z')) {
      fail("expected a command, as M or L");
      return false;
    }
    command_ = letter.value_or(command_);
    if (subpaths_.empty() && kind() != 'M') fail("a path begins with M");
    const bool begins = kind() == 'M' || subpaths_.empty() || subpaths_.back().closed;
    if (begins && subpaths_.size() >= options_.most_subpaths)
      fail("here begins a subpath too many, at most " + std::to_string(options_.most_subpaths) +
           " may be drawn");
    return !error_;
  }

  bool is_relative() const { return command_ >= 'a'; }

  char kind() const { return is_relative() ? static_cast<char>(command_ - 'a' + 'A') : command_; }

  double number() {
    const auto value = scanner_.number();
    if (!value || std::abs(*value) > options_.greatest)
      fail(std::string("expected the numbers of ") + command_);
    return value.value_or(0.0);
  }

  bool flag() {
    const auto set = scanner_.flag();
    if (!set) fail(std::string("a flag of ") + command_ + " is 0 or 1");
    return set.value_or(false);
  }

  Vec2 point() {
    const double x = number(), y = number();
    return is_relative() ? Vec2(at_ + Vec2(x, y)) : Vec2(x, y);
  }

  double along_axis(int axis) {
    const double value = number();
    return is_relative() ? at_[axis] + value : value;
  }

  // --- Drawing --------------------------------------------------------------------------------

  void run_command() {
    std::optional<Vec2> cubic_control, quadratic_control;
    switch (kind()) {
      case 'M':
        move_to(point());
        command_ = is_relative() ? 'l' : 'L';  // further pairs are lines
        break;
      case 'L': line_to(point()); break;
      case 'H': line_to({along_axis(0), at_.y()}); break;
      case 'V': line_to({at_.x(), along_axis(1)}); break;
      case 'C': cubic_control = cubic(point()); break;
      case 'S': cubic_control = cubic(2.0 * at_ - cubic_control_); break;
      case 'Q': quadratic_control = quadratic(point()); break;
      case 'T': quadratic_control = quadratic(2.0 * at_ - quadratic_control_); break;
      case 'A': arc(); break;
      case 'Z': close(); break;
    }
    cubic_control_ = cubic_control.value_or(at_);
    quadratic_control_ = quadratic_control.value_or(at_);
  }

  void move_to(const Vec2& p) {
    subpaths_.emplace_back();
    subpaths_.back().points.push_back(p);
    at_ = start_ = p;
    ++points_;
  }

  void line_to(const Vec2& p) {
    if (subpaths_.back().closed) move_to(at_);
    subpaths_.back().points.push_back(p);
    at_ = p;
    ++points_;
  }

  void close() {
    subpaths_.back().closed = true;
    at_ = start_;
  }

  void draw(const std::vector<Vec2>& points) {
    for (const auto& p : points) line_to(p);
  }

  // Both give their last control point, from which a smooth curve behind them starts.
  Vec2 cubic(const Vec2& first) {
    const Vec2 second = point(), end = point();
    draw(flatten_cubic(at_, first, second, end, options_));
    return second;
  }

  Vec2 quadratic(const Vec2& control) {
    const Vec2 end = point();
    draw(flatten_quadratic(at_, control, end, options_));
    return control;
  }

  void arc() {
    EllipticalArc arc;
    arc.radii.x() = std::abs(number());
    arc.radii.y() = std::abs(number());
    arc.turn = radians(number());
    arc.large = flag();
    arc.sweep = flag();
    const Vec2 end = point();
    if (!error_) draw(flatten_arc(at_, arc, end, options_));
  }

  PathScanner scanner_;
  const SvgPathOptions& options_;
  char command_ = 0;
  Vec2 at_ = Vec2::Zero(), start_ = Vec2::Zero();
  // Of the curve before; where it was no such curve, the pen's place.
  Vec2 cubic_control_ = Vec2::Zero(), quadratic_control_ = Vec2::Zero();
  std::size_t points_ = 0;
  std::vector<SvgSubpath> subpaths_;
  std::optional<Error> error_;
};

}  // namespace

Result<std::vector<SvgSubpath>> read_svg_path(std::string_view path,
                                              const SvgPathOptions& options) {
  return SvgPathReader(path, options).run();
}

}  // namespace roomgen
