#include "roomgen/geometry/outline.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace roomgen {

namespace {

constexpr double same_point = 1e-9;
constexpr double greatest = 1e6;  // coordinates beyond it are nonsense

// Reads the characters of a path: commands, and numbers with anything SVG allows between them.
class PathScanner {
 public:
  explicit PathScanner(std::string_view text) : text_(text) {}

  std::size_t position() const { return at_; }

  bool at_end() {
    skip_separators();
    return at_ == text_.size();
  }

  std::optional<char> command() {
    skip_separators();
    constexpr std::string_view commands = "MmLlHhVvCcSsQqTtAaZz";
    if (at_ == text_.size() || commands.find(text_[at_]) == std::string_view::npos)
      return std::nullopt;
    return text_[at_++];
  }

  std::optional<double> number() {
    skip_separators();
    std::size_t begin = at_;
    if (begin < text_.size() && text_[begin] == '+') ++begin;  // from_chars knows no plus
    double value = 0.0;
    const auto [end, code] =
        std::from_chars(text_.data() + begin, text_.data() + text_.size(), value);
    if (code != std::errc{} || !(std::abs(value) <= greatest)) return std::nullopt;
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  // The flags of an arc need no separator behind them: "a1,1 0 011,0".
  std::optional<bool> flag() {
    skip_separators();
    if (at_ == text_.size() || (text_[at_] != '0' && text_[at_] != '1')) return std::nullopt;
    return text_[at_++] == '1';
  }

 private:
  void skip_separators() {
    while (at_ < text_.size() &&
           std::string_view(" \t\r\n,").find(text_[at_]) != std::string_view::npos)
      ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

double angle_between(const Vec2& u, const Vec2& v) {
  return std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
}

struct Arc {
  Vec2 radii = Vec2::Ones();
  double turn = 0.0;  ///< of the ellipse's axis, degrees
  bool large = false, sweep = false;
};

class PathReader {
 public:
  PathReader(std::string_view path, int steps) : scanner_(path), steps_(std::max(1, steps)) {}

  Result<std::vector<Vec2>> run() {
    char command = 0;
    while (!scanner_.at_end()) {
      if (const auto next = scanner_.command()) {
        command = *next;
        if (!begin(command)) return problem("a path begins with M and has one closed outline");
        if (command == 'Z' || command == 'z') continue;
      } else if (command == 0 || closed_) {
        return problem("expected a command such as M, L, A or Z");
      }
      if (!step(command)) return problem("expected the numbers of " + std::string(1, command));
      if (points_.size() > max_outline_points)
        return problem("an outline has at most " + std::to_string(max_outline_points) + " points");
      // Further pairs after a move are lines.
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    if (points_.size() > 1 && (points_.back() - points_.front()).norm() < same_point)
      points_.pop_back();
    if (points_.size() < 3) return problem("an outline needs three points");
    return std::move(points_);
  }

 private:
  Error problem(const std::string& what) const {
    return {Error::Kind::invalid_input,
            "path, byte " + std::to_string(scanner_.position()) + ": " + what};
  }

  bool begin(char command) {
    const bool moves = command == 'M' || command == 'm';
    if (closed_ || moves != points_.empty()) return false;
    closed_ = command == 'Z' || command == 'z';
    return true;
  }

  void add(const Vec2& point) {
    if (points_.empty() || (point - points_.back()).norm() > same_point) points_.push_back(point);
    at_ = point;
  }

  // A point of a command: its lower-case form counts from where the pen is.
  std::optional<Vec2> point(char command) {
    const auto x = scanner_.number();
    const auto y = x ? scanner_.number() : std::nullopt;
    if (!y) return std::nullopt;
    const Vec2 read(*x, *y);
    return is_relative(command) ? Vec2(at_ + read) : read;
  }

  static bool is_relative(char command) { return command >= 'a'; }

  bool step(char command) {
    const char kind = is_relative(command) ? static_cast<char>(command - 'a' + 'A') : command;
    switch (kind) {
      case 'M':
      case 'L':
        return line(command);
      case 'H':
      case 'V':
        return along_axis(command, kind == 'H' ? 0 : 1);
      case 'C':
      case 'S':
        return cubic(command, kind == 'S');
      case 'Q':
      case 'T':
        return quadratic(command, kind == 'T');
      case 'A':
        return arc(command);
      default:
        return false;
    }
  }

  bool line(char command) {
    const auto to = point(command);
    if (!to) return false;
    add(*to);
    cubic_handle_ = quadratic_handle_ = at_;
    return true;
  }

  bool along_axis(char command, int axis) {
    const auto value = scanner_.number();
    if (!value) return false;
    Vec2 to = at_;
    to[axis] = is_relative(command) ? at_[axis] + *value : *value;
    add(to);
    cubic_handle_ = quadratic_handle_ = at_;
    return true;
  }

  bool cubic(char command, bool smooth) {
    const auto first = smooth ? std::optional<Vec2>(2.0 * at_ - cubic_handle_) : point(command);
    const auto second = first ? point(command) : std::nullopt;
    const auto to = second ? point(command) : std::nullopt;
    if (!to) return false;
    const Vec2 from = at_;
    for (int i = 1; i <= steps_; ++i) {
      const double t = static_cast<double>(i) / steps_, u = 1.0 - t;
      add(u * u * u * from + 3 * u * u * t * *first + 3 * u * t * t * *second + t * t * t * *to);
    }
    cubic_handle_ = *second;
    quadratic_handle_ = at_;
    return true;
  }

  bool quadratic(char command, bool smooth) {
    const auto handle =
        smooth ? std::optional<Vec2>(2.0 * at_ - quadratic_handle_) : point(command);
    const auto to = handle ? point(command) : std::nullopt;
    if (!to) return false;
    const Vec2 from = at_;
    for (int i = 1; i <= steps_; ++i) {
      const double t = static_cast<double>(i) / steps_, u = 1.0 - t;
      add(u * u * from + 2 * u * t * *handle + t * t * *to);
    }
    quadratic_handle_ = *handle;
    cubic_handle_ = at_;
    return true;
  }

  bool arc(char command) {
    Arc arc;
    const auto rx = scanner_.number();
    const auto ry = rx ? scanner_.number() : std::nullopt;
    const auto turn = ry ? scanner_.number() : std::nullopt;
    const auto large = turn ? scanner_.flag() : std::nullopt;
    const auto sweep = large ? scanner_.flag() : std::nullopt;
    const auto to = sweep ? point(command) : std::nullopt;
    if (!to) return false;
    arc = {Vec2(std::abs(*rx), std::abs(*ry)), *turn, *large, *sweep};
    draw(arc, *to);
    cubic_handle_ = quadratic_handle_ = at_;
    return true;
  }

  // Endpoint to centre form: SVG 1.1, appendix F.6.5 and F.6.6.
  void draw(Arc arc, const Vec2& to) {
    const Vec2 from = at_;
    if (arc.radii.minCoeff() < same_point || (to - from).norm() < same_point) return add(to);
    const double phi = radians(arc.turn);
    const Vec2 half = rotated(0.5 * (from - to), -phi);
    const double excess = half.cwiseQuotient(arc.radii).squaredNorm();
    if (excess > 1.0) arc.radii *= std::sqrt(excess);
    const Vec2 unit = half.cwiseQuotient(arc.radii);
    double scale = std::sqrt(std::max(0.0, 1.0 / unit.squaredNorm() - 1.0));
    if (arc.large == arc.sweep) scale = -scale;
    const Vec2 centre = scale * Vec2(unit.y(), -unit.x());  // on the unit circle
    const Vec2 start = unit - centre, end = -unit - centre;
    double sweep = angle_between(start, end);
    if (arc.sweep && sweep < 0) sweep += 2 * pi;
    if (!arc.sweep && sweep > 0) sweep -= 2 * pi;
    const double begin = std::atan2(start.y(), start.x());
    const Vec2 middle = rotated(centre.cwiseProduct(arc.radii), phi) + 0.5 * (from + to);
    for (int i = 1; i < steps_; ++i) {
      const double angle = begin + sweep * i / steps_;
      const Vec2 on_ellipse = arc.radii.cwiseProduct(Vec2(std::cos(angle), std::sin(angle)));
      add(middle + rotated(on_ellipse, phi));
    }
    add(to);
  }

  PathScanner scanner_;
  int steps_;
  std::vector<Vec2> points_;
  Vec2 at_ = Vec2::Zero();
  Vec2 cubic_handle_ = Vec2::Zero(), quadratic_handle_ = Vec2::Zero();
  bool closed_ = false;
};

}  // namespace

Result<std::vector<Vec2>> outline_of_path(std::string_view path, int arc_steps) {
  if (path.size() > max_path_bytes)
    return Error{Error::Kind::limit,
                 "a path has at most " + std::to_string(max_path_bytes) + " bytes"};
  return PathReader(path, arc_steps).run();
}

std::vector<Vec2> clipped(const std::vector<Vec2>& outline, const Vec2& normal, double offset) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& a = outline[i];
    const Vec2& b = outline[(i + 1) % outline.size()];
    const double over_a = normal.dot(a) - offset, over_b = normal.dot(b) - offset;
    if (over_a <= 0) kept.push_back(a);
    if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0))
      kept.push_back(a + over_a / (over_a - over_b) * (b - a));
  }
  return kept;
}

}  // namespace roomgen
